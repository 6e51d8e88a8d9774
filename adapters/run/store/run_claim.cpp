#include "adapters/run/store/run_claim.hpp"

#include "adapters/run/store/access.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

namespace crossgrain::store {
namespace {

/// The byte of a key: its first 60 bits, which a file offset can hold.
std::int64_t place_of(const std::string& key) {
    constexpr std::size_t digits = 15;
    std::int64_t place = 0;
    const char* end = key.data() + digits;
    if (key.size() < digits || std::from_chars(key.data(), end, place, 16).ptr != end)
        throw std::invalid_argument("a claim needs a hexadecimal key");
    return place;
}

[[noreturn]] void fail(const std::filesystem::path& file) {
    throw StoreError(fmt::format("{} cannot be locked: {}", file.string(), std::strerror(errno)));
}

}  // namespace

std::optional<RunClaim> RunClaim::take(const std::filesystem::path& directory,
                                       const std::string& key) {
    struct flock byte {};
    byte.l_type = F_WRLCK;
    byte.l_whence = SEEK_SET;
    byte.l_start = place_of(key);
    byte.l_len = 1;
    const std::filesystem::path path = directory / "claims.lock";
    const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file < 0) fail(path);
    RunClaim claim(file);
    // Of the open file, not of the process: threads exclude each other as well.
    if (fcntl(file, F_OFD_SETLK, &byte) == 0) return claim;
    if (errno == EAGAIN || errno == EACCES) return std::nullopt;
    fail(path);
}

RunClaim::~RunClaim() {
    if (file_ >= 0) close(file_);
}

}  // namespace crossgrain::store
