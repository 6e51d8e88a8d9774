// Dumps that are compressed while they are written and unpacked while they are read (zstd,
// RFC 8878), so that neither takes more memory than a window.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <ostream>
#include <string_view>

namespace crossgrain::adapters::dump {

/// What the name of a compressed dump ends in.
inline constexpr const char* zstd_extension = ".zst";

/// A new file, written as any output stream; `zstd -d` unpacks it.
class ZstdFile final : public std::ostream {
  public:
    /// Replaces what is there. The stream is in a failed state if the file cannot be opened.
    explicit ZstdFile(const std::filesystem::path& file);
    /// Ends the file if nobody has: what was written until then can be unpacked.
    ~ZstdFile() override;
    ZstdFile(const ZstdFile&) = delete;
    ZstdFile& operator=(const ZstdFile&) = delete;

    /// Writes the end, with a checksum of the content. False if anything could not be written.
    [[nodiscard]] bool finish();

  private:
    class Buffer;
    std::unique_ptr<Buffer> buffer_;
};

/// Unpacks bytes that come piece by piece.
class ZstdUnpacker {
  public:
    /// `sink` gets the content, in pieces of at most 128 KiB.
    explicit ZstdUnpacker(std::function<void(std::string_view)> sink);
    ~ZstdUnpacker();
    ZstdUnpacker(const ZstdUnpacker&) = delete;
    ZstdUnpacker& operator=(const ZstdUnpacker&) = delete;

    /// Throws TrajectoryError for bytes that are no zstd, that do not match their checksum, or that
    /// need a window of more than 8 MiB (ours need 2); and whatever the sink throws.
    void feed(std::string_view bytes);
    /// Throws TrajectoryError if the compressed content is cut off.
    void finish() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace crossgrain::adapters::dump
