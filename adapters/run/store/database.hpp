// The SQLite file below a results directory: opened for one purpose, in our format, with errors
// that name their true cause.
#pragma once

#include "adapters/run/store/access.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <memory>
#include <string>

namespace crossgrain::store {

class Database {
  public:
    /// <directory>/crossgrain.db. Access::write makes both if they are missing; to read, a missing
    /// file is an empty database. A file of format 1 is converted first, in either case. Throws
    /// StoreError.
    Database(std::filesystem::path directory, Access access, Note note);
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    [[nodiscard]] SQLite::Database& sqlite() const noexcept { return *sqlite_; }
    [[nodiscard]] const std::filesystem::path& directory() const noexcept { return directory_; }
    void note(const std::string& line) const;

    /// Runs a database operation; its failure becomes a StoreError.
    template <class Operation>
    auto guarded(Operation operation) const {
        try {
            return operation();
        } catch (const SQLite::Exception& error) {
            throw failure(error);
        }
    }

  private:
    [[nodiscard]] StoreError failure(const SQLite::Exception& error) const;
    void open_to_write();
    void require_directory() const;
    void require_plain_file() const;
    void open_to_read();
    void connect(const std::string& name, int flags);
    [[nodiscard]] int format() const;
    void make_current();
    void use_write_ahead_log();

    /// What the busy handler of SQLite needs; its address must not change.
    struct Wait;

    std::filesystem::path directory_, file_;
    Note note_;
    std::unique_ptr<Wait> wait_;
    std::unique_ptr<SQLite::Database> sqlite_;
};

}  // namespace crossgrain::store
