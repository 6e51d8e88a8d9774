// What the fuzz targets share: their bytes as a file, and what counts as a refusal.
#pragma once

#include "native/base/errors.hpp"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include <sys/mman.h>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace crossgrain::tests {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// A file that holds a text and is nowhere on disk.
class MemoryFile {
  public:
    explicit MemoryFile(std::string_view text) : file_(memfd_create("fuzz", MFD_CLOEXEC)) {
        if (file_ < 0 || write(file_, text.data(), text.size()) != ssize_t(text.size()))
            throw std::runtime_error("no memory for a file");
    }
    ~MemoryFile() { close(file_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

  private:
    int file_;
};

/// Runs a reader. Bad input may be refused in the words of the project; whatever else is thrown
/// ends the program, and so is a finding.
template <class Reader>
int refuses_or_reads(Reader reader) {
    try {
        reader();
    } catch (const CaseError&) {
    } catch (const TrajectoryError&) {
    }
    return 0;
}

}  // namespace crossgrain::tests
