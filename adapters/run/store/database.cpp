#include "adapters/run/store/database.hpp"

#include "adapters/run/store/schema.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

namespace crossgrain::store {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

namespace {

// A run is stored within milliseconds. Who holds the lock for a minute has been suspended.
constexpr auto longest_wait = 60s;
constexpr auto wait_until_note = 2s;

/// The name of a file as an SQLite URI that is never written, locked or waited for.
std::string immutable_uri(const fs::path& file) {
    std::string uri = "file:";
    for (const char c : fs::absolute(file).string()) {
        const bool special = c == '?' || c == '#' || c == '%';
        uri += special ? fmt::format("%{:02x}", static_cast<unsigned>(c)) : std::string(1, c);
    }
    return uri + "?immutable=1";
}

/// Whether another process has written what is not yet in the file itself.
bool has_write_ahead_log(const fs::path& file) {
    std::error_code error;
    const auto size = fs::file_size(file.string() + "-wal", error);
    return !error && size > 0;
}

}  // namespace

struct Database::Wait {
    const Database& database;
    Clock::time_point start;
    bool told = false;

    /// SQLite's busy handler: called again and again while somebody else holds the lock.
    static int turn(void* self, int count) {
        Wait& wait = *static_cast<Wait*>(self);
        const auto now = Clock::now();
        if (count == 0) {
            wait.start = now;
            wait.told = false;
        }
        if (now - wait.start > longest_wait) return 0;
        if (!wait.told && now - wait.start > wait_until_note) {
            wait.told = true;
            wait.database.note(fmt::format("waiting for another program that writes to {}",
                                           wait.database.file_.string()));
        }
        std::this_thread::sleep_for(count < 10 ? 2ms : 20ms);
        return 1;
    }
};

Database::Database(fs::path directory, Access access, Note note)
    : directory_(std::move(directory)), file_(directory_ / "crossgrain.db"), note_(std::move(note)),
      wait_(std::make_unique<Wait>(Wait{.database = *this, .start = {}})) {
    if (access == Access::read) require_directory();
    require_plain_file();
    guarded([&] { access == Access::write ? open_to_write() : open_to_read(); });
}

Database::~Database() = default;

void Database::note(const std::string& line) const {
    if (note_) note_(line);
}

StoreError Database::failure(const SQLite::Exception& error) const {
    const auto because = [&](const std::string& cause) {
        return StoreError(fmt::format("results directory {}: {}", directory_.string(), cause));
    };
    switch (error.getErrorCode()) {  // without SQLite's further distinctions
    case SQLITE_FULL:
        return because("the disk is full");
    case SQLITE_READONLY:
    case SQLITE_PERM:
        return because("crossgrain.db cannot be written (no permission, or a read-only disk)");
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return because(fmt::format("another program has held the lock of crossgrain.db for {} s",
                                   longest_wait / 1s));
    case SQLITE_NOTADB:
        return because("crossgrain.db is not a database; use another --results directory");
    case SQLITE_CORRUPT:
        return because("crossgrain.db is damaged; move it away, or put back a copy of it");
    default:
        break;
    }
    const int cause = sqlite_ ? sqlite3_system_errno(sqlite_->getHandle()) : 0;
    return because(cause == 0 ? error.what()
                              : fmt::format("{} ({})", error.what(), std::strerror(cause)));
}

void Database::connect(const std::string& name, int flags) {
    sqlite_ = std::make_unique<SQLite::Database>(name, flags);
    sqlite3_busy_handler(sqlite_->getHandle(), &Wait::turn, wait_.get());
}

int Database::format() const {
    return sqlite_->execAndGet("PRAGMA user_version").getInt();
}

void Database::open_to_write() {
    std::error_code error;
    fs::create_directories(directory_, error);
    if (error) {
        throw StoreError(fmt::format("results directory {} cannot be made: {}", directory_.string(),
                                     error.message()));
    }
    connect(file_.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    if (format() != schema_version) make_current();
    use_write_ahead_log();
}

void Database::require_directory() const {
    std::error_code error;
    const auto found = fs::status(directory_, error).type();
    if (found == fs::file_type::directory) return;
    const std::string what = found == fs::file_type::not_found ? "does not exist"
                             : found == fs::file_type::none
                                 ? fmt::format("cannot be opened: {}", error.message())
                                 : "is no directory";
    throw StoreError(fmt::format("results directory {} {}; name one with --results in which cases "
                                 "were run, or run some first",
                                 directory_.string(), what));
}

/// Neither a pipe, which blocks, nor a link to where nothing is, which would be made there.
void Database::require_plain_file() const {
    std::error_code error;
    const bool there = fs::symlink_status(file_, error).type() != fs::file_type::not_found;
    if (error || !there || fs::is_regular_file(file_, error)) return;
    throw StoreError(
        fmt::format("results directory {}: crossgrain.db is no regular file", directory_.string()));
}

/// The log of a writer needs a file beside the database, even to read. Where none can be made
/// nobody writes either, and the file is read as it is.
void Database::open_to_read() {
    std::error_code error;
    if (!fs::exists(file_, error)) {
        connect(":memory:", SQLite::OPEN_READWRITE);
        make_current();
        return;
    }
    try {
        connect(file_.string(), SQLite::OPEN_READONLY);
        (void)format();
    } catch (const SQLite::Exception&) {
        if (has_write_ahead_log(file_)) throw;
        connect(immutable_uri(file_), SQLite::OPEN_READONLY | SQLite::OPEN_URI);
    }
    if (format() != schema_version) open_to_write();
}

/// Makes our tables in a new file, or converts those of an older format.
void Database::make_current() {
    SQLite::Transaction transaction(*sqlite_, SQLite::TransactionBehavior::IMMEDIATE);
    const int found = format();  // another process may have been faster
    if (found == schema_version) return;
    const bool is_new =
        found == 0 && sqlite_->execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0;
    if (!is_new && found != 1) {
        throw StoreError(fmt::format("{} has format {}, this program writes {}; use another "
                                     "--results directory",
                                     file_.string(), found, schema_version));
    }
    if (found == 1) note(fmt::format("converting {} from format 1", file_.string()));
    sqlite_->exec(is_new ? schema : conversion_from_1());
    sqlite_->exec(fmt::format("PRAGMA user_version = {}", schema_version));
    transaction.commit();
}

/// Lets others read while one writes. The file keeps the mode; to change it nobody else may be
/// there, and SQLite does not wait for that by itself.
void Database::use_write_ahead_log() {
    const auto until = Clock::now() + longest_wait;
    while (sqlite_->execAndGet("PRAGMA journal_mode").getString() != "wal") {
        try {
            (void)sqlite_->execAndGet("PRAGMA journal_mode = WAL");
            return;  // also where the file system cannot do it, and the mode stays what it was
        } catch (const SQLite::Exception& error) {
            if (error.getErrorCode() != SQLITE_BUSY || Clock::now() > until) throw;
            std::this_thread::sleep_for(20ms);
        }
    }
}

}  // namespace crossgrain::store
