#include "adapters/program/trajectory_stream.hpp"

#include "native/base/errors.hpp"

#include <fmt/format.h>

namespace crossgrain::adapters {

TrajectoryStream::TrajectoryStream(const scene::Scene& scene, const scene::FrameSink& sink,
                                   const std::filesystem::path& keep_in)
    : guard_(scene, sink), reader_(scene, [this](const scene::Frame& frame) { guard_(frame); }),
      copy_path_(keep_in) {
    if (!keep_in.empty()) copy_.emplace(keep_in);
}

void TrajectoryStream::take(std::string_view bytes) {
    // Set beforehand, so that it stays set whatever is thrown.
    failed_ = true;
    if (copy_ && !copy_->write(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
        throw TrajectoryError(fmt::format("cannot write {}", copy_path_.string()));
    }
    reader_.feed(bytes);
    failed_ = false;
}

void TrajectoryStream::finish() {
    reader_.finish();
    guard_.finish();
    if (copy_ && !copy_->finish()) {
        throw TrajectoryError(fmt::format("cannot write {}", copy_path_.string()));
    }
}

}  // namespace crossgrain::adapters
