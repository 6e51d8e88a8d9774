// The tables of the store. Results, which are large, have a table of their own, so that nothing
// that looks through runs reads them.
#pragma once

#include <string>

namespace crossgrain::store {

inline constexpr int schema_version = 2;

inline constexpr const char* schema = R"(
CREATE TABLE run (
    id INTEGER PRIMARY KEY, key TEXT NOT NULL, case_name TEXT NOT NULL, variant TEXT NOT NULL,
    rung INTEGER NOT NULL, code TEXT NOT NULL, version TEXT NOT NULL, program TEXT NOT NULL,
    digest TEXT NOT NULL, replica INTEGER NOT NULL, seed TEXT NOT NULL, status TEXT NOT NULL,
    reason TEXT NOT NULL, log_tail TEXT NOT NULL, settings TEXT NOT NULL, cpu_s REAL NOT NULL,
    wall_s REAL NOT NULL, work REAL NOT NULL, work_unit TEXT NOT NULL, created TEXT NOT NULL);
CREATE INDEX run_by_key ON run (key);
CREATE INDEX run_by_program ON run (code, version);
CREATE TABLE result (run_id INTEGER PRIMARY KEY REFERENCES run (id), results BLOB NOT NULL);
CREATE TABLE measurement (
    run_id INTEGER NOT NULL REFERENCES run (id), observable TEXT NOT NULL, value REAL NOT NULL,
    stderr REAL NOT NULL, systematic REAL NOT NULL, n INTEGER NOT NULL, unit TEXT NOT NULL);
CREATE INDEX measurement_by_run ON measurement (run_id);
CREATE TABLE entry (
    id INTEGER PRIMARY KEY, created TEXT NOT NULL, command TEXT NOT NULL, version TEXT NOT NULL,
    machine TEXT NOT NULL);
CREATE TABLE verdict (
    entry_id INTEGER NOT NULL REFERENCES entry (id), case_name TEXT NOT NULL, code TEXT NOT NULL,
    observable TEXT NOT NULL, kind TEXT NOT NULL, against TEXT NOT NULL, setting TEXT NOT NULL,
    difference REAL, uncertainty REAL, limit_value REAL, outcome TEXT NOT NULL,
    expected INTEGER NOT NULL, reason TEXT NOT NULL);
)";

/// Statements that turn tables of format 1, which had results in `run` and knew a program by its
/// stated version only, into those above.
[[nodiscard]] inline std::string conversion_from_1() {
    const std::string move = R"(
INSERT INTO run SELECT id, key, case_name, variant, rung, code, version, '', '', replica, seed,
    status, reason, log_tail, settings, cpu_s, wall_s, work, work_unit, created FROM run_1;
INSERT INTO result SELECT id, results FROM run_1;
INSERT INTO measurement SELECT * FROM measurement_1;
INSERT INTO entry SELECT * FROM entry_1;
INSERT INTO verdict SELECT * FROM verdict_1;
)";
    std::string statements = "DROP INDEX IF EXISTS run_key;";
    for (const char* table : {"run", "measurement", "entry", "verdict"})
        statements += std::string("ALTER TABLE ") + table + " RENAME TO " + table + "_1;";
    statements += schema + move;
    for (const char* table : {"measurement", "verdict", "entry", "run"})
        statements += std::string("DROP TABLE ") + table + "_1;";
    return statements;
}

}  // namespace crossgrain::store
