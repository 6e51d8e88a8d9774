// SQLite history of everything that was ever run: runs with their measurements, curves, snapshots
// and costs, and the verdicts of every call. A run is found again by its key, so that nothing is
// computed twice; an entry is one call of the program and refers to the runs it used.
#pragma once

#include "cases/measure/results.hpp"
#include "reference/compare/verdict.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::store {

/// A run as it is stored. `status` is "ok" or one of the outcomes that are no result.
struct RunRecord {
    std::int64_t id = 0;  ///< 0 before it is stored
    std::string key;      ///< identifies scene, settings, observables, code and version
    std::string case_name, variant;
    std::size_t rung = 0;
    std::string code, version;
    std::int64_t replica = 0;
    std::uint64_t seed = 0;
    std::string status, reason, log_tail;
    std::string settings_json;  ///< what a reader wants to see: dt, law variant, N, ...
    double cpu_s = 0;
    double wall_s = 0;
    double work = 0;  ///< in work_unit
    std::string work_unit = "particle-steps";
    std::string created;  ///< UTC, ISO 8601
    bool cached = false;  ///< found in the store instead of computed
    measure::Results results;
};

/// One call of the program.
struct Entry {
    std::int64_t id = 0;
    std::string created, command, version, machine;
};

/// One value of one observable (or of "cpu_s") in one stored run.
struct HistoryPoint {
    std::int64_t run_id = 0;
    std::string case_name, variant, code, observable, unit, version, created, settings_json;
    std::uint64_t seed = 0;
    double value = 0;
    double standard_error = 0;
};

/// All functions throw StoreError with one line when the file cannot be read or written.
class StoreError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

class Store {
  public:
    /// Opens or creates <directory>/crossgrain.db; creates the directory.
    explicit Store(const std::filesystem::path& directory);
    ~Store();
    Store(const Store&) = delete;
    Store& operator=(const Store&) = delete;

    /// The newest successful run with this key.
    [[nodiscard]] std::optional<RunRecord> find(const std::string& key) const;
    /// The newest run with this key that failed.
    [[nodiscard]] std::optional<RunRecord> find_failed(const std::string& key) const;
    /// Stores the run in one transaction and returns its id.
    std::int64_t add(const RunRecord& run);

    [[nodiscard]] Entry begin_entry(Entry entry);
    void add_verdicts(const Entry& entry, const std::string& case_name,
                      const std::vector<compare::Verdict>& verdicts);

    /// Every measurement and every cost of every successful run, oldest first.
    [[nodiscard]] std::vector<HistoryPoint> history() const;

    [[nodiscard]] const std::filesystem::path& directory() const noexcept { return directory_; }

  private:
    struct Database;
    [[nodiscard]] std::optional<RunRecord> newest(const std::string& key,
                                                  const std::string& status) const;
    std::filesystem::path directory_;
    std::unique_ptr<Database> database_;
};

/// Now, as "2026-01-31T12:00:00Z".
[[nodiscard]] std::string utc_now();

}  // namespace crossgrain::store
