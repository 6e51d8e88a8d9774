// SQLite history of everything that was ever run: runs with their measurements, curves, snapshots
// and costs, and the verdicts of every call. A run is found again by its key, so that nothing is
// computed twice; an entry is one call of the program.
#pragma once

#include "adapters/run/store/access.hpp"
#include "cases/measure/results.hpp"
#include "native/base/enum_words.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::store {

/// `planned` and `not_run` are of runs that are not stored.
enum class RunStatus {
    planned,
    ok,
    run_failed,
    timed_out,
    not_installed,
    not_expressible,
    not_run
};
constexpr auto words(RunStatus /*of*/) {
    return std::array{"planned",         "ok",     "run_failed", "timed_out", "not_installed",
                      "not_expressible", "not_run"};
}

/// Whether it was started and has no result.
[[nodiscard]] constexpr bool has_failed(RunStatus status) noexcept {
    return status == RunStatus::run_failed || status == RunStatus::timed_out;
}

/// As documents have it: one word for both kinds of failure.
[[nodiscard]] inline std::string document_word(RunStatus status) {
    return to_string(has_failed(status) ? RunStatus::run_failed : status);
}

/// A run as it is stored.
struct RunRecord {
    std::int64_t id = 0;  ///< 0 before it is stored
    std::string key;      ///< identifies scene, settings, observables, code and version
    std::string case_name, variant;
    std::size_t rung = 0;
    std::string code, version;
    std::string program, digest;  ///< path and SHA-256 of a foreign program; empty for native codes
    std::int64_t replica = 0;
    std::uint64_t seed = 0;
    RunStatus status = RunStatus::planned;
    std::string reason, log_tail;
    std::string settings_json;  ///< what a reader wants to see: dt, law variant, N, ...
    double cpu_s = 0;
    double wall_s = 0;
    double work = 0;  ///< in work_unit
    std::string work_unit = "particle-steps";
    std::string created;  ///< UTC, ISO 8601
    bool cached = false;  ///< found in the store instead of computed
    /// By this call, from the frames of an earlier run, whose cost it has.
    bool measured_again = false;
    measure::Results results;
};

/// One call of the program.
struct Entry {
    std::int64_t id = 0;
    std::string created, command, version, machine;
};

/// A verdict as it is kept: texts and numbers, whose meaning is the judge's.
struct VerdictRow {
    std::string code, observable, kind, against, setting;
    double difference = 0, uncertainty = 0, limit = 0;
    std::string outcome;
    bool expected = true;
    std::string reason;
};

/// One value of one observable (or of "cpu_s") in one stored run.
struct HistoryPoint {
    std::int64_t run_id = 0;
    std::string case_name, variant, code, observable, unit, version, created, settings_json;
    std::uint64_t seed = 0;
    double value = 0;
    double standard_error = 0;
};

class Database;

/// All functions throw StoreError. A stored run that is damaged counts as not stored: `note` is
/// told of it.
class Store {
  public:
    /// Opens <directory>/crossgrain.db (database.hpp).
    explicit Store(const std::filesystem::path& directory, Access access = Access::write,
                   Note note = {});
    ~Store();
    Store(const Store&) = delete;
    Store& operator=(const Store&) = delete;

    /// Opens what was to be opened later; otherwise nothing.
    void open() const { (void)database(); }
    /// The newest run with this key, whether it succeeded or failed.
    [[nodiscard]] std::optional<RunRecord> find(const std::string& key) const;
    /// Digest of the program that made the newest run of this code and version; nothing if there is
    /// none, or none that is known.
    [[nodiscard]] std::optional<std::string> last_digest(const std::string& code,
                                                         const std::string& version) const;
    /// Stores the run in one transaction and returns its id.
    std::int64_t add(const RunRecord& run);

    [[nodiscard]] Entry begin_entry(Entry entry);
    void add_verdicts(const Entry& entry, const std::string& case_name,
                      const std::vector<VerdictRow>& verdicts);

    /// Every measurement and every cost of every successful run, oldest first.
    [[nodiscard]] std::vector<HistoryPoint> history() const;

    [[nodiscard]] const std::filesystem::path& directory() const noexcept { return directory_; }

  private:
    [[nodiscard]] const Database& database() const;

    std::filesystem::path directory_;
    Note note_;
    mutable std::once_flag opened_;
    mutable std::unique_ptr<const Database> database_;
};

/// Now, as "2026-01-31T12:00:00Z".
[[nodiscard]] std::string utc_now();

}  // namespace crossgrain::store
