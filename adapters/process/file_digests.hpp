// Digests of large files, which are computed again only when a file has changed.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>

namespace crossgrain::adapters::process {

class FileDigests {
  public:
    /// Remembers digests in `file`, which need not exist, nor be whole, nor be writable; nowhere if
    /// it is empty.
    explicit FileDigests(std::filesystem::path file);
    /// Writes what is new.
    ~FileDigests();
    FileDigests(const FileDigests&) = delete;
    FileDigests& operator=(const FileDigests&) = delete;

    /// SHA-256 of a file's bytes, 64 hexadecimal digits. Throws std::system_error if it cannot be
    /// read, Interrupted on a stop request.
    [[nodiscard]] std::string of(const std::filesystem::path& file, const std::stop_token& stop);

    /// $XDG_CACHE_HOME/crossgrain/file-digests or ~/.cache/...; empty if there is no such place.
    [[nodiscard]] static std::filesystem::path usual_place();

  private:
    /// What changes when a file does: "device inode size mtime ctime".
    struct Remembered {
        std::string stamp, digest;
    };
    static std::map<std::string, Remembered> read(const std::filesystem::path& file);
    void write() const;

    std::filesystem::path file_;
    std::map<std::string, Remembered> known_;  ///< by path
    std::map<std::string, Remembered> added_;
};

}  // namespace crossgrain::adapters::process
