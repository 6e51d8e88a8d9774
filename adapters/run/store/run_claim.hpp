// Who computes a run, when several processes share a results directory.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace crossgrain::store {

/// The sole right to compute the run of a key, until the end of the scope or of the process. It is
/// a lock on one byte of <directory>/claims.lock, at the place that the key names: nothing is left
/// behind, however the process ends.
class RunClaim {
  public:
    /// Nothing while somebody else, in this process or another, holds it. `key`: a digest in
    /// hexadecimal, at least 15 digits of it. Throws StoreError when the file cannot be locked.
    [[nodiscard]] static std::optional<RunClaim> take(const std::filesystem::path& directory,
                                                      const std::string& key);
    ~RunClaim();
    RunClaim(RunClaim&& other) noexcept : file_(other.file_) { other.file_ = -1; }
    RunClaim(const RunClaim&) = delete;
    RunClaim& operator=(const RunClaim&) = delete;
    RunClaim& operator=(RunClaim&&) = delete;

  private:
    explicit RunClaim(int file) : file_(file) {}
    int file_;
};

}  // namespace crossgrain::store
