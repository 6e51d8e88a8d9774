// What a program writes into its pipe, on its way to whoever measures it: bytes, checked frames,
// sink; and, when asked, the same bytes into a compressed file.
#pragma once

#include "adapters/dump/dump_reader.hpp"
#include "adapters/dump/zstd_file.hpp"
#include "cases/scene/frame.hpp"
#include "cases/scene/frame_guard.hpp"
#include "cases/scene/scene.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

namespace crossgrain::adapters {

class TrajectoryStream {
  public:
    /// `keep_in`: file for the bytes, compressed with zstd, or empty. `scene` must outlive the
    /// stream.
    TrajectoryStream(const scene::Scene& scene, const scene::FrameSink& sink,
                     const std::filesystem::path& keep_in);

    /// Throws TrajectoryError (not a dump, not this scene's trajectory, the copy cannot be written)
    /// or whatever the sink throws.
    void take(std::string_view bytes);
    /// Throws TrajectoryError unless the whole trajectory has been taken.
    void finish();

    /// Whether `take` has thrown.
    [[nodiscard]] bool has_failed() const noexcept { return failed_; }
    [[nodiscard]] std::int64_t frames() const noexcept { return guard_.frames_passed(); }

  private:
    scene::FrameGuard guard_;
    dump::DumpReader reader_;
    std::filesystem::path copy_path_;
    std::optional<dump::ZstdFile> copy_;
    bool failed_ = false;
};

}  // namespace crossgrain::adapters
