#include "adapters/run/store/store.hpp"

#include "adapters/run/store/database.hpp"
#include "adapters/run/store/picture_fault.hpp"
#include "adapters/run/store/results_json.hpp"
#include "native/base/bounded_json.hpp"
#include "native/base/printable.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <utility>

namespace crossgrain::store {
namespace {

/// What is wrong with a stored run.
class Damaged : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

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
    auto blob = nlohmann::json::to_cbor(to_json(results));
    constexpr std::size_t most = 1'000'000'000;  // of SQLite
    if (blob.size() > most)
        throw StoreError(fmt::format("results of {} bytes are too large to store", blob.size()));
    return blob;
}

measure::Results results_of(const SQLite::Column& column) {
    const auto* bytes = static_cast<const std::uint8_t*>(column.getBlob());
    return results_from_json(bounded_cbor({bytes, static_cast<std::size_t>(column.getBytes())}));
}

std::uint64_t seed_of(const std::string& text) {
    std::uint64_t seed = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, seed);
    if (error != std::errc() || stop != end)
        throw Damaged(fmt::format("its seed is '{}'", printable(text)));
    return seed;
}

/// Of the runs without a result only those that were started are stored.
RunStatus status_of(const std::string& text) {
    const auto status = from_word<RunStatus>(text);
    if (status && (*status == RunStatus::ok || has_failed(*status))) return *status;
    throw Damaged(fmt::format("its status is '{}'", printable(text)));
}

/// Columns of a run, in the order of `run_of`.
constexpr const char* run_columns =
    "id, key, case_name, variant, rung, code, version, program, digest, replica, seed, status, "
    "reason, log_tail, settings, cpu_s, wall_s, work, work_unit, created";

RunRecord run_of(SQLite::Statement& row) {
    int at = 0;
    const auto text = [&] { return row.getColumn(at++).getString(); };
    const auto number = [&] { return row.getColumn(at++).getDouble(); };
    const auto whole = [&] { return row.getColumn(at++).getInt64(); };
    RunRecord run;
    run.id = whole();
    for (auto* field : {&run.key, &run.case_name, &run.variant})
        *field = text();
    run.rung = static_cast<std::size_t>(whole());
    for (auto* field : {&run.code, &run.version, &run.program, &run.digest})
        *field = text();
    run.replica = whole();
    run.seed = seed_of(text());
    run.status = status_of(text());
    for (auto* field : {&run.reason, &run.log_tail, &run.settings_json})
        *field = text();
    for (auto* field : {&run.cpu_s, &run.wall_s, &run.work})
        *field = number();
    for (auto* field : {&run.work_unit, &run.created})
        *field = text();
    (void)bounded_json(run.settings_json);
    run.results = results_of(row.getColumn(at));
    return run;
}

/// The run that a row of `Store::history` belongs to.
HistoryPoint point_of(SQLite::Statement& row) {
    return {.run_id = row.getColumn(0).getInt64(),
            .case_name = row.getColumn(1).getString(),
            .variant = row.getColumn(2).getString(),
            .code = row.getColumn(3).getString(),
            .observable = {},
            .unit = {},
            .version = row.getColumn(4).getString(),
            .created = row.getColumn(5).getString(),
            .settings_json = row.getColumn(6).getString()};
}

/// A cost is an observable like the others; it has no error of its own.
HistoryPoint cost_of(HistoryPoint run, double cpu_s) {
    run.observable = "cpu_s";
    run.unit = "s";
    run.value = cpu_s;
    return run;
}

}  // namespace

std::string utc_now() {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

Store::Store(const std::filesystem::path& directory, Access access, Note note)
    : directory_(directory), note_(std::move(note)) {
    if (access == Access::write_later) return;
    std::call_once(opened_,
                   [&] { database_ = std::make_unique<const Database>(directory, access, note_); });
}

const Database& Store::database() const {
    std::call_once(opened_, [&] {
        database_ = std::make_unique<const Database>(directory_, Access::write, note_);
    });
    return *database_;
}

Store::~Store() = default;

std::optional<RunRecord> Store::find(const std::string& key) const {
    return database().guarded([&]() -> std::optional<RunRecord> {
        SQLite::Statement query(
            database().sqlite(),
            fmt::format("SELECT {}, results FROM run LEFT JOIN result ON run_id = id "
                        "WHERE key = ? AND status IN ('ok', 'run_failed', 'timed_out') "
                        "ORDER BY id DESC LIMIT 1",
                        run_columns));
        query.bind(1, key);
        if (!query.executeStep()) return std::nullopt;
        try {
            RunRecord run = run_of(query);
            run.cached = true;
            return run;
        } catch (const SQLite::Exception&) {
            throw;
        } catch (const std::exception& damage) {  // what reads JSON throws several kinds
            database().note(fmt::format("a stored run of {} ({}) is damaged and not used: {}",
                                        printable(query.getColumn(2).getString()),
                                        printable(query.getColumn(5).getString()),
                                        printable(damage.what())));
            return std::nullopt;
        }
    });
}

std::optional<std::string> Store::last_digest(const std::string& code,
                                              const std::string& version) const {
    return database().guarded([&]() -> std::optional<std::string> {
        SQLite::Statement query(database().sqlite(),
                                "SELECT digest FROM run WHERE code = ? AND version = ? AND "
                                "digest <> '' ORDER BY id DESC LIMIT 1");
        SQLite::bind(query, code, version);
        if (!query.executeStep()) return std::nullopt;
        return query.getColumn(0).getString();
    });
}

std::int64_t Store::add(const RunRecord& run) {
    require_finite(run.results);
    for (const auto& picture : run.results.pictures)
        require_complete(picture);
    const std::vector<std::uint8_t> blob = blob_of(run.results);
    return database().guarded([&] {
        auto& db = database().sqlite();
        SQLite::Transaction transaction(db, SQLite::TransactionBehavior::IMMEDIATE);
        SQLite::Statement insert(
            db, "INSERT INTO run VALUES (NULL,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
        SQLite::bind(insert, run.key, run.case_name, run.variant,
                     static_cast<std::int64_t>(run.rung), run.code, run.version, run.program,
                     run.digest, run.replica, std::to_string(run.seed), to_string(run.status),
                     run.reason, run.log_tail, run.settings_json, run.cpu_s, run.wall_s, run.work,
                     run.work_unit, run.created);
        insert.exec();
        const std::int64_t id = db.getLastInsertRowid();
        SQLite::Statement result(db, "INSERT INTO result VALUES (?,?)");
        result.bind(1, id);
        result.bindNoCopy(2, blob.data(), static_cast<int>(blob.size()));
        result.exec();
        SQLite::Statement measurement(db, "INSERT INTO measurement VALUES (?,?,?,?,?,?,?)");
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
    return database().guarded([&] {
        entry.created = utc_now();
        SQLite::Statement insert(
            database().sqlite(),
            "INSERT INTO entry (created, command, version, machine) VALUES (?,?,?,?)");
        SQLite::bind(insert, entry.created, entry.command, entry.version, entry.machine);
        insert.exec();
        entry.id = database().sqlite().getLastInsertRowid();
        return entry;
    });
}

void Store::add_verdicts(const Entry& entry, const std::string& case_name,
                         const std::vector<VerdictRow>& verdicts) {
    database().guarded([&] {
        SQLite::Transaction transaction(database().sqlite());
        SQLite::Statement insert(database().sqlite(),
                                 "INSERT INTO verdict VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?)");
        for (const auto& v : verdicts) {
            SQLite::bind(insert, entry.id, case_name, v.code, v.observable, v.kind, v.against,
                         v.setting, v.difference, v.uncertainty, v.limit, v.outcome,
                         v.expected ? 1 : 0, v.reason);
            insert.exec();
            insert.reset();
        }
        transaction.commit();
    });
}

std::vector<HistoryPoint> Store::history() const {
    return database().guarded([&] {
        SQLite::Statement query(database().sqlite(), R"(
            SELECT id, case_name, variant, code, version, created, settings, seed, cpu_s,
                   m.observable, m.unit, m.value, m.stderr
              FROM run LEFT JOIN measurement m ON m.run_id = id
             WHERE status = 'ok' ORDER BY id)");
        std::vector<HistoryPoint> points;
        std::int64_t last = 0, damaged = 0;
        while (query.executeStep()) {
            HistoryPoint point = point_of(query);
            try {
                point.seed = seed_of(query.getColumn(7).getString());
            } catch (const Damaged&) {
                ++damaged;
                continue;
            }
            if (point.run_id != last) {
                last = point.run_id;
                points.push_back(cost_of(point, query.getColumn(8).getDouble()));
            }
            if (query.getColumn(9).isNull()) continue;  // a run that only costs
            point.observable = query.getColumn(9).getString();
            point.unit = query.getColumn(10).getString();
            point.value = query.getColumn(11).getDouble();
            point.standard_error = query.getColumn(12).getDouble();
            points.push_back(std::move(point));
        }
        if (damaged > 0) {
            database().note(
                fmt::format("{} stored measurements are damaged and left out", damaged));
        }
        return points;
    });
}

}  // namespace crossgrain::store
