#!/usr/bin/env bash
# Compares what two results directories say, bit by bit: the newest run of each case, variant, time
# step, code and replica with its measurements, series, snapshots and pictures, and the verdicts of
# the newest call that judged each case. For changes that must not change a number.
# Usage: tools/same-answers.sh OLD_RESULTS NEW_RESULTS
# Exit code: 0 the same, 1 something differs or is on one side only, 2 no such store.
set -euo pipefail

[[ $# -eq 2 ]] || { sed -n 's/^# Usage: /usage: /p' "$0" >&2; exit 2; }
schema_version=$(sed -nE 's/.*schema_version = ([0-9]+);/\1/p' \
    "$(dirname "$0")/../adapters/run/store/schema.hpp")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for side in 1 2; do
    # A copy, which needs no write access to the directory, by fixed names for SQL.
    store=${!side}/crossgrain.db
    [[ -f $store ]] || { echo "same-answers: there is no store in ${!side}" >&2; exit 2; }
    for file in "$store" "$store"-wal; do
        [[ ! -f $file ]] || cp -- "$file" "$work/$side.db${file#"$store"}"
    done
    format=$(sqlite3 "$work/$side.db" 'PRAGMA user_version')
    [[ $format == "$schema_version" ]] || {
        echo "same-answers: $store has format $format, not $schema_version;" \
            "'crossgrain --results ... report' converts it" >&2
        exit 2
    }
done

cd "$work"
sqlite3 -bail -noheader -separator '  ' :memory: >report <<'SQL'
ATTACH '1.db' AS old;
ATTACH '2.db' AS new;
CREATE TEMP VIEW old_run AS SELECT max(id) AS id, case_name, variant, rung, code, replica, seed,
    status FROM old.run GROUP BY case_name, variant, rung, code, replica, seed;
CREATE TEMP VIEW new_run AS SELECT max(id) AS id, case_name, variant, rung, code, replica, seed,
    status FROM new.run GROUP BY case_name, variant, rung, code, replica, seed;
CREATE TEMP TABLE pair AS SELECT o.id AS old_id, n.id AS new_id, o.status AS old_status,
    n.status AS new_status, format('%s %s step %d %s replica %d seed %s', o.case_name, o.variant,
    o.rung + 1, o.code, o.replica + 1, o.seed) AS name
    FROM old_run o JOIN new_run n USING (case_name, variant, rung, code, replica, seed);
-- A measurement of a run is named by its observable, unit and how many of that name came before.
CREATE TEMP TABLE value AS SELECT 1 AS side, run_id, observable, unit, value, stderr, systematic, n,
    row_number() OVER (PARTITION BY run_id, observable, unit ORDER BY rowid) AS nth
    FROM old.measurement WHERE run_id IN (SELECT old_id FROM pair);
INSERT INTO value SELECT 2, run_id, observable, unit, value, stderr, systematic, n,
    row_number() OVER (PARTITION BY run_id, observable, unit ORDER BY rowid)
    FROM new.measurement WHERE run_id IN (SELECT new_id FROM pair);
CREATE INDEX temp.value_by_run ON value (run_id, side, observable, unit, nth);

SELECT 'run in the old store only', case_name, variant, code, 'replica', replica + 1 FROM
    (SELECT case_name, variant, rung, code, replica, seed FROM old_run
     EXCEPT SELECT case_name, variant, rung, code, replica, seed FROM new_run);
SELECT 'run in the new store only', case_name, variant, code, 'replica', replica + 1 FROM
    (SELECT case_name, variant, rung, code, replica, seed FROM new_run
     EXCEPT SELECT case_name, variant, rung, code, replica, seed FROM old_run);
SELECT 'status', name, old_status, new_status FROM pair WHERE old_status <> new_status;
SELECT 'measurement', name, o.observable,
    format('%.17g +- %.17g, %.17g +- %.17g, differs by %.2g of itself', o.value, o.stderr, n.value,
           n.stderr, abs(n.value - o.value)/max(abs(o.value), 1e-300))
    FROM pair JOIN value o ON o.side = 1 AND o.run_id = old_id
    JOIN value n ON n.side = 2 AND n.run_id = new_id
        AND n.observable = o.observable AND n.unit = o.unit AND n.nth = o.nth
    WHERE (o.value, o.stderr, o.systematic, o.n) IS NOT (n.value, n.stderr, n.systematic, n.n);
SELECT 'measurement in the old store only', name, observable FROM pair
    JOIN value o ON o.side = 1 AND o.run_id = old_id WHERE NOT EXISTS
    (SELECT 1 FROM value n WHERE n.side = 2 AND n.run_id = new_id AND n.observable = o.observable
     AND n.unit = o.unit AND n.nth = o.nth);
SELECT 'measurement in the new store only', name, observable FROM pair
    JOIN value n ON n.side = 2 AND n.run_id = new_id WHERE NOT EXISTS
    (SELECT 1 FROM value o WHERE o.side = 1 AND o.run_id = old_id AND o.observable = n.observable
     AND o.unit = n.unit AND o.nth = n.nth);
SELECT 'series, settings, snapshots or pictures', name FROM pair
    JOIN old.result o ON o.run_id = old_id JOIN new.result n ON n.run_id = new_id
    WHERE o.results <> n.results;

CREATE TEMP TABLE old_verdict AS SELECT v.* FROM old.verdict v JOIN
    (SELECT case_name AS judged, max(entry_id) AS last FROM old.verdict GROUP BY case_name)
    ON v.case_name = judged AND v.entry_id = last;
CREATE TEMP TABLE new_verdict AS SELECT v.* FROM new.verdict v JOIN
    (SELECT case_name AS judged, max(entry_id) AS last FROM new.verdict GROUP BY case_name)
    ON v.case_name = judged AND v.entry_id = last;
CREATE TEMP VIEW old_said AS SELECT case_name, code, observable, kind, against, setting, outcome,
    CASE expected WHEN 1 THEN 'expected' ELSE 'unexpected' END, difference, uncertainty,
    limit_value, reason, count(*) FROM old_verdict GROUP BY 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12;
CREATE TEMP VIEW new_said AS SELECT case_name, code, observable, kind, against, setting, outcome,
    CASE expected WHEN 1 THEN 'expected' ELSE 'unexpected' END, difference, uncertainty,
    limit_value, reason, count(*) FROM new_verdict GROUP BY 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12;
SELECT 'verdict in the old store only', * FROM
    (SELECT * FROM old_said EXCEPT SELECT * FROM new_said);
SELECT 'verdict in the new store only', * FROM
    (SELECT * FROM new_said EXCEPT SELECT * FROM old_said);
.once compared
SELECT format('%d runs, %d measurements and %d verdicts compared', (SELECT count(*) FROM pair),
    (SELECT count(*) FROM value WHERE side = 1), (SELECT count(*) FROM old_verdict));
SQL
cat report
echo "same-answers: $(<compared): $(wc -l <report) differences"
[[ ! -s report && $(<compared) != 0\ runs* ]]
