// Makes report documents for the tests of the pages: shaped like real ones, from formulas, so that
// every number is known and the same on every machine.
//   node make_document.mjs rich OUT.json     every kind of verdict, series and history
//   node make_document.mjs absent OUT.json   nothing is installed, nothing ran
//   node make_document.mjs models OUT.json   readings, sweeps, findings, pictures, other series
//   node make_document.mjs many OUT.json     40 cases of 24 variants
//   node make_document.mjs broken OUT.json   nothing is finite, outcomes no page has heard of
import { writeFileSync } from "node:fs";
import { allCases } from "./make_cases.mjs";
import { certificate } from "./make_certificate.mjs";
import { absentRun, codes, versions } from "./make_entries.mjs";
import { historySeries } from "./make_history.mjs";
import { manyCases, modelCases } from "./make_models.mjs";
import { attribution, phenomena } from "./make_phenomena.mjs";

function codeEntry(code) {
  const all = ["full damping", "normal damping", "clipping", "spins", "lids"];
  const expresses = code === "yade" ? ["normal damping", "spins"] : all;
  return { code, version: versions[code], status: "ok", reason: "", expresses };
}

function rich() {
  return {
    version: "0.1.0 (source 1a2b3c4d)",
    created: "2026-11-22T05:00:00Z",
    command: "crossgrain validate --suite quick",
    machine: { cpu: "Example CPU 3.0 GHz", cores: 2, os: "Debian GNU/Linux 12" },
    codes: codes.map(codeEntry),
    cases: allCases(),
    certificate: certificate(),
    history: { series: historySeries(codes, versions) },
  };
}

/** The same questions on a machine without any of the codes. */
function absent() {
  const report = rich();
  const reason = "program not found on this machine";
  const unanswered = {
    difference: null,
    uncertainty: null,
    verdict: "not_installed",
    expected: true,
    reason,
  };
  for (const entry of report.codes)
    Object.assign(entry, { status: "not_installed", version: "", reason });
  for (const item of report.cases) {
    item.runs = item.runs.map((entry) => absentRun(entry.code, "not_installed", reason));
    item.verdicts = item.verdicts.map((entry) => ({ ...entry, ...unanswered }));
    Object.assign(item, { measurements: [], series: [] });
  }
  return { ...report, certificate: { pairs: [] }, history: { series: [] } };
}

/** Numbers that are not finite arrive as null; a newer writer may know outcomes these pages do not. */
function broken() {
  const report = rich();
  const nothing = (values) => values.map((column) => column.map(() => null));
  report.cases.push(...modelCases());
  for (const item of report.cases) {
    for (const series of item.series) series.values = nothing(series.values);
    item.verdicts = item.verdicts.map(({ expected, ...entry }) => ({
      ...entry,
      difference: null,
      verdict: "agreeable",
    }));
    for (const run of item.runs) Object.assign(run, { cpu_s: null, settings: null });
    for (const picture of item.pictures || []) Object.assign(picture, { palette: null });
    for (const finding of item.findings || [])
      Object.assign(finding, { label: null, detail: null });
  }
  for (const pair of report.certificate.pairs)
    Object.assign(pair, {
      max_dx: { 1: null },
      digits: {},
      curve: undefined,
      verdict: "agreeable",
      expected: undefined,
    });
  for (const series of report.history.series)
    series.points = series.points.map((point) => ({ ...point, value: null }));
  return report;
}

const withCases = (cases) => ({
  ...rich(),
  cases,
  certificate: { pairs: [] },
  history: { series: [] },
});
const models = () => ({
  ...withCases(modelCases()),
  phenomena: phenomena(),
  attribution: attribution(),
});
const many = () => withCases(manyCases(40, ["P", "D", "M", "std"], 6));

const [kind, out] = process.argv.slice(2);
writeFileSync(out, JSON.stringify({ rich, absent, models, many, broken }[kind]()));
