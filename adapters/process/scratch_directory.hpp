// Working directories of runs: nobody else's, and gone when nobody needs them any more, also after
// this program was killed.
#pragma once

#include <filesystem>
#include <string>

namespace crossgrain::adapters::process {

/// A directory of our own below a parent, from its making until the end of the scope. A file in it,
/// named `running` and locked, tells others that it is in use; the lock ends with this process.
class ScratchDirectory {
  public:
    /// Makes <parent>/<stem>-<process>, or <stem>-<process>-2, ...; the parent as well if it is not
    /// there. `stem` is a plain name (native/base/file_stem.hpp). Throws
    /// std::filesystem::filesystem_error.
    ScratchDirectory(const std::filesystem::path& parent, const std::string& stem);
    /// Removes the directory, unless it is kept.
    ~ScratchDirectory();
    ScratchDirectory(const ScratchDirectory&) = delete;
    ScratchDirectory& operator=(const ScratchDirectory&) = delete;

    /// Leaves the directory on disk instead of those that were kept under the same stem before.
    void keep() noexcept;
    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  private:
    std::filesystem::path parent_, path_;
    std::string stem_;
    int lock_ = -1;
};

/// Removes the scratch directories below `parent` whose process has ended without doing so, and
/// empty ones. What was kept stays, and so does everything that is no scratch directory. Never
/// throws: what cannot be removed now can be later.
void sweep(const std::filesystem::path& parent) noexcept;

}  // namespace crossgrain::adapters::process
