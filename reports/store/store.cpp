#include "reports/store/store.hpp"

#include "reports/store/picture_fault.hpp"
#include "reports/store/results_json.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <ctime>

namespace crossgrain::store {
namespace {

constexpr int schema_version = 1;

constexpr const char* schema = R"(
CREATE TABLE IF NOT EXISTS run (
    id INTEGER PRIMARY KEY, key TEXT NOT NULL, case_name TEXT NOT NULL, variant TEXT NOT NULL,
    rung INTEGER NOT NULL, code TEXT NOT NULL, version TEXT NOT NULL, replica INTEGER NOT NULL,
    seed TEXT NOT NULL, status TEXT NOT NULL, reason TEXT NOT NULL, log_tail TEXT NOT NULL,
    settings TEXT NOT NULL, cpu_s REAL NOT NULL, wall_s REAL NOT NULL, work REAL NOT NULL,
    work_unit TEXT NOT NULL, created TEXT NOT NULL, results BLOB NOT NULL);
CREATE INDEX IF NOT EXISTS run_key ON run (key, status);
CREATE TABLE IF NOT EXISTS measurement (
    run_id INTEGER NOT NULL REFERENCES run (id), observable TEXT NOT NULL, value REAL NOT NULL,
    stderr REAL NOT NULL, systematic REAL NOT NULL, n INTEGER NOT NULL, unit TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS entry (
    id INTEGER PRIMARY KEY, created TEXT NOT NULL, command TEXT NOT NULL, version TEXT NOT NULL,
    machine TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS verdict (
    entry_id INTEGER NOT NULL REFERENCES entry (id), case_name TEXT NOT NULL, code TEXT NOT NULL,
    observable TEXT NOT NULL, kind TEXT NOT NULL, against TEXT NOT NULL, setting TEXT NOT NULL,
    difference REAL, uncertainty REAL, limit_value REAL, outcome TEXT NOT NULL,
    expected INTEGER NOT NULL, reason TEXT NOT NULL);
)";

/// Runs a database operation; every failure becomes one clear line.
template <class Operation>
auto guarded(const std::filesystem::path& directory, Operation operation) {
    try {
        return operation();
    } catch (const SQLite::Exception& error) {
        throw StoreError(fmt::format("results directory {}: {} (is it full or read-only?)",
                                     directory.string(), error.what()));
    } catch (const nlohmann::json::exception& error) {
        throw StoreError(fmt::format("results directory {}: a stored run cannot be read ({})",
                                     directory.string(), error.what()));
    } catch (const std::logic_error& error) {  // std::stoull of what is no seed
        throw StoreError(fmt::format("results directory {}: a stored run cannot be read ({})",
                                     directory.string(), error.what()));
    }
}

void require_finite(const measure::Results& results) {
    for (const auto& m : results.measurements) {
        if (std::isfinite(m.value) && std::isfinite(m.standard_error) &&
            std::isfinite(m.systematic))
            continue;
        throw StoreError(fmt::format("measurement '{}' is not a finite number", m.observable));
    }
}

void require_complete(const measure::Picture& picture) {
    if (const auto fault = picture_fault(picture))
        throw StoreError(fmt::format("picture '{}' {}", picture.name, *fault));
}

std::vector<std::uint8_t> blob_of(const measure::Results& results) {
    return nlohmann::json::to_cbor(to_json(results));
}

measure::Results results_of(const SQLite::Column& column) {
    const auto* bytes = static_cast<const std::uint8_t*>(column.getBlob());
    return results_from_json(nlohmann::json::from_cbor(bytes, bytes + column.getBytes()));
}

RunRecord run_of(SQLite::Statement& row) {
    RunRecord run;
    run.id = row.getColumn("id").getInt64();
    run.key = row.getColumn("key").getString();
    run.case_name = row.getColumn("case_name").getString();
    run.variant = row.getColumn("variant").getString();
    run.rung = static_cast<std::size_t>(row.getColumn("rung").getInt64());
    run.code = row.getColumn("code").getString();
    run.version = row.getColumn("version").getString();
    run.replica = row.getColumn("replica").getInt64();
    run.seed = std::stoull(row.getColumn("seed").getString());
    run.status = row.getColumn("status").getString();
    run.reason = row.getColumn("reason").getString();
    run.log_tail = row.getColumn("log_tail").getString();
    run.settings_json = row.getColumn("settings").getString();
    run.cpu_s = row.getColumn("cpu_s").getDouble();
    run.wall_s = row.getColumn("wall_s").getDouble();
    run.work = row.getColumn("work").getDouble();
    run.work_unit = row.getColumn("work_unit").getString();
    run.created = row.getColumn("created").getString();
    run.results = results_of(row.getColumn("results"));
    return run;
}

}  // namespace

struct Store::Database {
    explicit Database(const std::filesystem::path& file)
        : sqlite(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, 10'000) {}
    mutable SQLite::Database sqlite;
};

std::string utc_now() {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

Store::Store(const std::filesystem::path& directory) : directory_(directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) {
        throw StoreError(fmt::format("results directory {} cannot be made: {}", directory.string(),
                                     error.message()));
    }
    guarded(directory_, [&] {
        database_ = std::make_unique<Database>(directory / "crossgrain.db");
        auto& db = database_->sqlite;
        const int found = db.execAndGet("PRAGMA user_version").getInt();
        if (found != 0 && found != schema_version) {
            throw StoreError(fmt::format("{}/crossgrain.db has format {}, this program writes {}; "
                                         "use another --results directory",
                                         directory.string(), found, schema_version));
        }
        db.exec(schema);
        db.exec(fmt::format("PRAGMA user_version = {}", schema_version));
    });
}

Store::~Store() = default;

std::optional<RunRecord> Store::find(const std::string& key) const {
    return newest(key, "ok");
}

std::optional<RunRecord> Store::find_failed(const std::string& key) const {
    return newest(key, "run_failed");
}

std::optional<RunRecord> Store::newest(const std::string& key, const std::string& status) const {
    return guarded(directory_, [&]() -> std::optional<RunRecord> {
        SQLite::Statement query(
            database_->sqlite,
            "SELECT * FROM run WHERE key = ? AND status = ? ORDER BY id DESC LIMIT 1");
        query.bind(1, key);
        query.bind(2, status);
        if (!query.executeStep()) return std::nullopt;
        RunRecord run = run_of(query);
        run.cached = true;
        return run;
    });
}

std::int64_t Store::add(const RunRecord& run) {
    require_finite(run.results);
    for (const auto& picture : run.results.pictures)
        require_complete(picture);
    return guarded(directory_, [&] {
        SQLite::Transaction transaction(database_->sqlite);
        SQLite::Statement insert(
            database_->sqlite, "INSERT INTO run (key, case_name, variant, rung, code, version, "
                               "replica, seed, status, reason, log_tail, settings, cpu_s, wall_s, "
                               "work, work_unit, created, results) "
                               "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
        const std::vector<std::uint8_t> blob = blob_of(run.results);
        int at = 0;
        for (const auto& text : {run.key, run.case_name, run.variant})
            insert.bind(++at, text);
        insert.bind(++at, static_cast<std::int64_t>(run.rung));
        for (const auto& text : {run.code, run.version})
            insert.bind(++at, text);
        insert.bind(++at, run.replica);
        for (const auto& text :
             {std::to_string(run.seed), run.status, run.reason, run.log_tail, run.settings_json}) {
            insert.bind(++at, text);
        }
        for (const double number : {run.cpu_s, run.wall_s, run.work})
            insert.bind(++at, number);
        for (const auto& text : {run.work_unit, run.created})
            insert.bind(++at, text);
        insert.bind(++at, blob.data(), static_cast<int>(blob.size()));
        insert.exec();
        const std::int64_t id = database_->sqlite.getLastInsertRowid();
        SQLite::Statement measurement(database_->sqlite,
                                      "INSERT INTO measurement VALUES (?,?,?,?,?,?,?)");
        for (const auto& m : run.results.measurements) {
            SQLite::bind(measurement, id, m.observable, m.value, m.standard_error, m.systematic,
                         static_cast<std::int64_t>(m.n), m.unit);
            measurement.exec();
            measurement.reset();
        }
        transaction.commit();
        return id;
    });
}

Entry Store::begin_entry(Entry entry) {
    return guarded(directory_, [&] {
        entry.created = utc_now();
        SQLite::Statement insert(
            database_->sqlite,
            "INSERT INTO entry (created, command, version, machine) VALUES (?,?,?,?)");
        SQLite::bind(insert, entry.created, entry.command, entry.version, entry.machine);
        insert.exec();
        entry.id = database_->sqlite.getLastInsertRowid();
        return entry;
    });
}

void Store::add_verdicts(const Entry& entry, const std::string& case_name,
                         const std::vector<compare::Verdict>& verdicts) {
    guarded(directory_, [&] {
        SQLite::Transaction transaction(database_->sqlite);
        SQLite::Statement insert(database_->sqlite,
                                 "INSERT INTO verdict VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?)");
        for (const auto& v : verdicts) {
            SQLite::bind(insert, entry.id, case_name, v.code, v.observable,
                         compare::to_string(v.kind), v.against, v.setting, v.difference,
                         v.uncertainty, v.limit, compare::to_string(v.outcome), v.expected ? 1 : 0,
                         v.reason);
            insert.exec();
            insert.reset();
        }
        transaction.commit();
    });
}

std::vector<HistoryPoint> Store::history() const {
    return guarded(directory_, [&] {
        // A cost is an observable like the others; it has no error of its own.
        SQLite::Statement query(database_->sqlite, R"(
            SELECT run.*, m.observable AS observable, m.unit AS unit, m.value AS value,
                   m.stderr AS error
              FROM run JOIN measurement m ON m.run_id = run.id WHERE run.status = 'ok'
            UNION ALL
            SELECT run.*, 'cpu_s', 's', run.cpu_s, 0 FROM run WHERE run.status = 'ok'
            ORDER BY 1)");
        std::vector<HistoryPoint> points;
        while (query.executeStep()) {
            points.push_back({.run_id = query.getColumn("id").getInt64(),
                              .case_name = query.getColumn("case_name").getString(),
                              .variant = query.getColumn("variant").getString(),
                              .code = query.getColumn("code").getString(),
                              .observable = query.getColumn("observable").getString(),
                              .unit = query.getColumn("unit").getString(),
                              .version = query.getColumn("version").getString(),
                              .created = query.getColumn("created").getString(),
                              .settings_json = query.getColumn("settings").getString(),
                              .seed = std::stoull(query.getColumn("seed").getString()),
                              .value = query.getColumn("value").getDouble(),
                              .standard_error = query.getColumn("error").getDouble()});
        }
        return points;
    });
}

}  // namespace crossgrain::store
