// The building blocks of the test documents: codes, runs, measurements, verdicts.

export const codes = ["native-dem", "lammps", "liggghts", "yade"];
export const versions = {
  "native-dem": "0.1.0",
  lammps: "29 Sep 2021 - Update 2",
  liggghts: "3.8.0",
  yade: "2023.02a",
};
const rates = { "native-dem": 1.5e8, lammps: 1.4e7, liggghts: 6.2e6, yade: 9.1e5 };

export function run(code, work, extra) {
  const cpu = work / rates[code];
  const identity = { code, version: versions[code], variant: "full", replica: 0, seed: 1 };
  const outcome = { status: "ok", reason: "", log_tail: "", settings: { dt: 5e-4, grains: 400 } };
  const cost = { cpu_s: cpu, wall_s: 1.07 * cpu + 0.2, work, work_unit: "particle-steps" };
  return { ...identity, ...outcome, ...cost, cached: code === "lammps", ...extra };
}

export function absentRun(code, status, reason, log_tail = "") {
  return run(code, 1, {
    status,
    reason,
    log_tail,
    cpu_s: null,
    wall_s: null,
    work: null,
    cached: false,
  });
}

export function measurement(code, observable, value, stderr, extra) {
  const ci95 = [value - 2 * stderr, value + 2 * stderr];
  const kind = { code, observable, variant: "full", unit: "1" };
  return { ...kind, value, stderr, systematic: 0, ci95, n: 1, settings: {}, ...extra };
}

/** question: {code, observable, kind, against, setting, limit_reason}; numbers: difference, uncertainty, limit. */
export function verdict(question, numbers, outcome = "agree", extra = {}) {
  const [difference, uncertainty, limit] = numbers;
  const defaults = { setting: "", limit_reason: "", expected: true, reason: "" };
  return { ...defaults, ...question, difference, uncertainty, limit, verdict: outcome, ...extra };
}
