// Makes report documents for the tests of the pages: shaped like real ones, from formulas, so that
// every number is known and the same on every machine.
//   node make_document.mjs rich OUT.json     every kind of verdict, series and history
//   node make_document.mjs absent OUT.json   nothing is installed, nothing ran
import { writeFileSync } from "node:fs";
import { historySeries } from "./make_history.mjs";
import { bedSeries, convergenceSeries } from "./make_series.mjs";

const codes = ["native-dem", "lammps", "liggghts", "yade"];
const versions = {
  "native-dem": "0.1.0",
  lammps: "29 Sep 2021 - Update 2",
  liggghts: "3.8.0",
  yade: "2023.02a",
};
const rates = { "native-dem": 1.5e8, lammps: 1.4e7, liggghts: 6.2e6, yade: 9.1e5 };

function run(code, work, extra) {
  const cpu = work / rates[code];
  return {
    code,
    version: versions[code],
    variant: "full",
    replica: 0,
    seed: 1,
    status: "ok",
    reason: "",
    log_tail: "",
    settings: { dt: 5e-4, grains: 400 },
    cpu_s: cpu,
    wall_s: 1.07 * cpu + 0.2,
    work,
    work_unit: "particle-steps",
    cached: code === "lammps",
    ...extra,
  };
}

function absentRun(code, status, reason, log_tail = "") {
  return run(code, 1, { status, reason, log_tail, cpu_s: null, wall_s: null, work: null, cached: false });
}

function verdict(code, observable, kind, against, numbers, verdictWord, extra) {
  const [difference, uncertainty, limit] = numbers;
  return {
    code,
    observable,
    kind,
    against,
    setting: "",
    difference,
    uncertainty,
    limit,
    limit_reason: "",
    verdict: verdictWord,
    expected: true,
    reason: "",
    ...extra,
  };
}

function collisionNormal() {
  const reason = "error of a second order scheme at dt = contact time / 100";
  const exact = (code, difference, word = "agree", extra = {}) =>
    verdict(code, "restitution", "exact", "analytic:restitution", [difference, 0, 1e-3], word, {
      setting: "full, dt = t_c/100",
      limit_reason: reason,
      unit: "1",
      ...extra,
    });
  return {
    case: "collision-normal",
    title: "two discs, head on",
    source: "closed form of the damped oscillator",
    text: "One normal collision of two discs with a linear spring and dashpot; restitution and contact time have closed forms.",
    figures: ["convergence"],
    runs: codes.map((code) => run(code, 2.0e5)),
    measurements: [
      ...codes.map((code, i) => ({
        code,
        observable: "restitution",
        variant: "full",
        value: 0.8 + 1e-4 * i,
        stderr: 0,
        systematic: 0,
        ci95: [0.8, 0.8],
        n: 1,
        unit: "1",
        settings: { dt: 5e-4 },
      })),
      ...[
        ["native-dem", 2.0],
        ["lammps", 1.98],
        ["liggghts", 0.99],
        ["yade", 1.01],
      ].map(([code, order]) => ({
        code,
        observable: "convergence-order",
        variant: "full",
        value: order,
        stderr: 0.02,
        systematic: 0,
        ci95: [order - 0.04, order + 0.04],
        n: 7,
        unit: "1",
        settings: { dt_min: 3.1e-5, dt_max: 2e-3 },
      })),
    ],
    verdicts: [
      exact("native-dem", 2.1e-5),
      exact("lammps", 2.2e-5),
      exact("liggghts", 3.31e-3, "disagree", {
        reason: "uses the force of the previous step in its first half step: first order in dt",
      }),
      exact("yade", 4.7e-3, "disagree", {
        expected: false,
        reason: "error grows linearly with dt; the catalogue expects second order",
      }),
      verdict("native-dem", "contact-time", "exact", "analytic:contact-time", [1.2e-6, 0, 1e-5], "agree", {
        setting: "full, dt = t_c/100",
      }),
      verdict("lammps", "contact-time", "exact", "analytic:contact-time", [1.2e-6, 0, 1e-5], "agree", {
        setting: "full, dt = t_c/100",
      }),
      verdict("liggghts", "contact-time", "exact", "analytic:contact-time", [-8.0e-6, 0, 1e-5], "agree", {
        setting: "full, dt = t_c/100",
      }),
      verdict("yade", "contact-time", "exact", "analytic:contact-time", [9.1e-6, 0, 1e-5], "agree", {
        setting: "full, dt = t_c/100",
      }),
      verdict("native-dem", "restitution", "parity", "lammps", [1.1e-15, 0, 1e-12], "agree", {
        setting: "full, dt = t_c/100",
        limit_reason: "round-off of 10 steps in contact",
      }),
    ],
    series: convergenceSeries(codes),
  };
}

function gasParity() {
  const parity = (against, setting, numbers, word = "agree", extra = {}) =>
    verdict("native-dem", "max-displacement-difference", "parity", against, numbers, word, {
      setting,
      limit_reason: "round-off times the growth of a hard-disc gas",
      ...extra,
    });
  return {
    case: "gas-parity",
    title: "periodic gas of 256 discs",
    text: "The same initial state in all codes, until chaos takes over.",
    source: "",
    runs: [
      run("native-dem", 2.56e6),
      run("lammps", 2.56e6),
      run("liggghts", 2.56e6),
      absentRun("yade", "not_expressible", "yade has no full-vector damping"),
    ],
    measurements: [],
    verdicts: [
      parity("lammps", "after 1 contact time", [2e-16, 0, 1e-13]),
      parity("lammps", "after 10 contact times", [4e-13, 0, 1e-11]),
      parity("lammps", "after 100 contact times", [1.2e-8, 0, 1e-6]),
      parity("liggghts", "after 1 contact time", [0, 0, 1e-13]),
      parity("liggghts", "after 10 contact times", [7e-13, 0, 1e-11]),
      parity("liggghts", "after 100 contact times", [3e-6, 0, 1e-6], "undecided", {
        reason: "left the limit late, as chaos does; no replica to tell",
      }),
      parity("yade", "after 10 contact times", [null, null, 1e-11], "not_expressible", {
        reason: "yade has no full-vector damping",
      }),
    ],
    series: [],
  };
}

function bedFluid() {
  const slope = (code, value) => ({
    code,
    observable: "spectrum-exponent",
    variant: "full",
    value,
    stderr: 0.04,
    systematic: 0.05,
    ci95: [value - 0.08, value + 0.08],
    n: 12,
    unit: "1",
    settings: { k_min: 1, k_max: 16 },
  });
  const margin = { limit_reason: "half the spread of fit windows", setting: "full, layers 1–5" };
  return {
    case: "bed-fluid",
    title: "vibrated bed, fluidised surface",
    source: "Taguchi 1992, figure 3",
    text: "A deep bed on a plate that vibrates vertically; the spectrum of displacements follows a power law near the surface.",
    figures: ["lid-height", "spectrum"],
    runs: [
      run("native-dem", 4.0e8, { settings: { dt: 1e-3, grains: 1200, periods: 40 } }),
      run("lammps", 4.0e8),
      run("liggghts", 4.0e8),
      absentRun(
        "yade",
        "run_failed",
        "killed at the time limit of 60 s",
        "step 18000\nstep 19000\nKilled <script>alert(1)</script> & more",
      ),
    ],
    measurements: [slope("native-dem", -1.66), slope("lammps", -1.68), slope("liggghts", -1.63)],
    verdicts: [
      verdict(
        "native-dem",
        "spectrum-exponent",
        "published",
        "published:taguchi-1992",
        [0.007, 0.08, 0.15],
        "agree",
        margin,
      ),
      verdict(
        "lammps",
        "spectrum-exponent",
        "published",
        "published:taguchi-1992",
        [-0.013, 0.08, 0.15],
        "agree",
        margin,
      ),
      verdict(
        "liggghts",
        "spectrum-exponent",
        "published",
        "published:taguchi-1992",
        [0.037, 0.14, 0.15],
        "undecided",
        { ...margin, reason: "the interval reaches beyond the limit: 12 replicas are too few" },
      ),
      verdict(
        "yade",
        "spectrum-exponent",
        "published",
        "published:taguchi-1992",
        [null, null, 0.15],
        "run_failed",
        { ...margin, reason: "killed at the time limit of 60 s" },
      ),
      verdict("native-dem", "spectrum-exponent", "agree", "lammps", [0.02, 0.06, 0.15], "agree", margin),
      verdict("native-dem", "spectrum-exponent", "agree", "liggghts", [-0.03, 0.07, 0.15], "agree", margin),
      verdict(
        "native-dem",
        "surface-flux",
        "published",
        "published:clement-1993",
        [null, null, null],
        "no_reference",
        { reason: "the reference has no number yet" },
      ),
    ],
    series: bedSeries(["native-dem", "lammps", "liggghts"]),
  };
}

function certificate() {
  const times = Array.from({ length: 60 }, (_, i) => 0.01 * Math.pow(10, i / 19.67));
  const curve = (rate) => ({
    columns: ["t", "max_dx"],
    values: [times, times.map((t) => Math.min(2.0, 2e-16 * (1 + 40 * t) * Math.exp(rate * t)))],
  });
  const pair = (name, b, max_dx, digits, extra) => ({
    case: name,
    a: "native-dem",
    b,
    contact_time: 0.1,
    max_dx,
    digits,
    limits: { 1: 1e-13, 10: 1e-11, 100: 1e-6 },
    max_dh: {},
    verdict: "agree",
    expected: true,
    reason: "",
    ...extra,
  });
  return {
    length_unit: "grain diameters",
    pairs: [
      pair(
        "gas-parity",
        "lammps",
        { 1: 2e-16, 10: 4e-13, 100: 1.2e-8 },
        { 1: 15.7, 10: 12.4, 100: 7.9 },
        { curve: curve(1.6) },
      ),
      pair(
        "gas-parity",
        "liggghts",
        { 1: 0, 10: 7e-13, 100: 3e-6 },
        { 1: 16, 10: 12.2, 100: 5.5 },
        { verdict: "undecided", reason: "left the limit late, as chaos does", curve: curve(2.2) },
      ),
      pair(
        "bed-fluid",
        "lammps",
        { 1: 1e-15, 10: 3e-14 },
        { 1: 15, 10: 13.5 },
        {
          max_dh: { "period 1": 1e-13, "period 2": 3e-13 },
          limits_dh: { "period 1": 1e-10, "period 2": 1e-9 },
        },
      ),
      pair(
        "bed-fluid",
        "liggghts",
        { 1: 1e-15, 10: 8e-6 },
        { 1: 15, 10: 5.1 },
        { verdict: "disagree", expected: false, reason: "apart from the first clip of the damping force on" },
      ),
    ],
  };
}

function rich() {
  return {
    version: "0.1.0 (source 1a2b3c4d)",
    created: "2026-11-22T05:00:00Z",
    command: "crossgrain validate --suite quick",
    machine: { cpu: "Example CPU 3.0 GHz", cores: 2, os: "Debian GNU/Linux 12" },
    codes: codes.map((code) => ({
      code,
      version: versions[code],
      status: "ok",
      reason: "",
      expresses:
        code === "yade"
          ? ["normal damping", "spins"]
          : ["full damping", "normal damping", "clipping", "spins", "lids"],
    })),
    cases: [
      collisionNormal(),
      gasParity(),
      bedFluid(),
      {
        case: "bed-deep",
        title: "vibrated bed, 40 layers",
        text: "",
        source: "",
        figures: ["lid-height"],
        runs: [],
        measurements: [],
        verdicts: [],
        series: [],
      },
    ],
    certificate: certificate(),
    history: { series: historySeries(codes, versions) },
  };
}

/** The same questions on a machine without any of the codes. */
function absent() {
  const report = rich();
  const reason = "program not found on this machine";
  for (const entry of report.codes) Object.assign(entry, { status: "not_installed", version: "", reason });
  for (const item of report.cases) {
    item.runs = item.runs.map((entry) => absentRun(entry.code, "not_installed", reason));
    item.measurements = [];
    item.series = [];
    item.verdicts = item.verdicts.map((entry) => ({
      ...entry,
      difference: null,
      uncertainty: null,
      verdict: "not_installed",
      expected: true,
      reason,
    }));
  }
  return { ...report, certificate: { pairs: [] }, history: { series: [] } };
}

const [kind, out] = process.argv.slice(2);
writeFileSync(out, JSON.stringify({ rich, absent }[kind]()));
