// The cases of the test documents, with every kind of verdict.
import { absentRun, codes, measurement, run, verdict } from "./make_entries.mjs";
import { bedSeries, convergenceSeries } from "./make_series.mjs";

const setting = "full, dt = t_c/100";

function collisionVerdicts() {
  const limit_reason = "error of a second order scheme at dt = contact time / 100";
  const restitution = {
    observable: "restitution",
    kind: "exact",
    against: "analytic:restitution",
    setting,
    limit_reason,
    unit: "1",
  };
  const time = {
    observable: "contact-time",
    kind: "exact",
    against: "analytic:contact-time",
    setting,
  };
  const parity = {
    observable: "restitution",
    kind: "parity",
    setting,
    limit_reason: "round-off of 10 steps in contact",
  };
  return [
    verdict({ code: "native-dem", ...restitution }, [2.1e-5, 0, 1e-3]),
    verdict({ code: "lammps", ...restitution }, [2.2e-5, 0, 1e-3]),
    verdict({ code: "liggghts", ...restitution }, [3.31e-3, 0, 1e-3], "disagree", {
      reason: "uses the force of the previous step in its first half step: first order in dt",
    }),
    verdict({ code: "yade", ...restitution }, [4.7e-3, 0, 1e-3], "disagree", {
      expected: false,
      reason: "error grows linearly with dt; the catalogue expects second order",
    }),
    ...codes.map((code, i) =>
      verdict({ code, ...time }, [[1.2e-6, 1.2e-6, -8.0e-6, 9.1e-6][i], 0, 1e-5]),
    ),
    verdict({ code: "native-dem", against: "lammps", ...parity }, [1.1e-15, 0, 1e-12]),
  ];
}

function collisionNormal() {
  const fit = { n: 7, settings: { dt_min: 3.1e-5, dt_max: 2e-3 } };
  return {
    case: "collision-normal",
    title: "two discs, head on",
    source: "closed form of the damped oscillator",
    text: "One normal collision of two discs with a linear spring and dashpot.",
    figures: ["convergence"],
    runs: codes.map((code) => run(code, 2.0e5)),
    measurements: codes.flatMap((code, i) => [
      measurement(code, "restitution", 0.8 + 1e-4 * i, 0, { settings: { dt: 5e-4 } }),
      measurement(code, "convergence-order", [2.0, 1.98, 0.99, 1.01][i], 0.02, fit),
    ]),
    verdicts: collisionVerdicts(),
    series: convergenceSeries(codes),
  };
}

function gasParity() {
  const question = {
    code: "native-dem",
    observable: "max-displacement-difference",
    kind: "parity",
  };
  const limit_reason = "round-off times the growth of a hard-disc gas";
  const parity = (against, after, numbers, ...rest) =>
    verdict({ ...question, against, limit_reason, setting: "after " + after }, numbers, ...rest);
  const inexpressible = "yade has no full-vector damping";
  return {
    case: "gas-parity",
    title: "periodic gas of 256 discs",
    text: "The same initial state in all codes, until chaos takes over.",
    source: "",
    runs: [
      ...codes.slice(0, 3).map((code) => run(code, 2.56e6)),
      absentRun("yade", "not_expressible", inexpressible),
    ],
    measurements: [],
    verdicts: [
      parity("lammps", "1 contact time", [2e-16, 0, 1e-13]),
      parity("lammps", "10 contact times", [4e-13, 0, 1e-11]),
      parity("lammps", "100 contact times", [1.2e-8, 0, 1e-6]),
      parity("liggghts", "1 contact time", [0, 0, 1e-13]),
      parity("liggghts", "10 contact times", [7e-13, 0, 1e-11]),
      parity("liggghts", "100 contact times", [3e-6, 0, 1e-6], "undecided", {
        reason: "left the limit late, as chaos does",
      }),
      parity("yade", "10 contact times", [null, null, 1e-11], "not_expressible", {
        reason: inexpressible,
      }),
    ],
    series: [],
  };
}

function bedVerdicts() {
  const about = {
    observable: "spectrum-exponent",
    limit_reason: "half the spread of fit windows",
    setting: "full, layers 1–5",
  };
  const published = { ...about, kind: "published", against: "published:taguchi-1992" };
  const pair = { ...about, code: "native-dem", kind: "agree" };
  const flux = {
    code: "native-dem",
    observable: "surface-flux",
    kind: "published",
    against: "published:clement-1993",
  };
  return [
    verdict({ code: "native-dem", ...published }, [0.007, 0.08, 0.15]),
    verdict({ code: "lammps", ...published }, [-0.013, 0.08, 0.15]),
    verdict({ code: "liggghts", ...published }, [0.037, 0.14, 0.15], "undecided", {
      reason: "the interval reaches beyond the limit: 12 replicas are too few",
    }),
    verdict({ code: "yade", ...published }, [null, null, 0.15], "run_failed", {
      reason: "killed at the time limit of 60 s",
    }),
    verdict({ ...pair, against: "lammps" }, [0.02, 0.06, 0.15]),
    verdict({ ...pair, against: "liggghts" }, [-0.03, 0.07, 0.15]),
    verdict(flux, [null, null, null], "no_reference", {
      reason: "the reference has no number yet",
    }),
  ];
}

function bedFluid() {
  const ran = codes.slice(0, 3);
  const log = "step 18000\nstep 19000\nKilled <script>alert(1)</script> & more";
  const window = { n: 12, systematic: 0.05, settings: { k_min: 1, k_max: 16 } };
  return {
    case: "bed-fluid",
    title: "vibrated bed, fluidised surface",
    source: "Taguchi 1992, figure 3",
    text: "A deep bed on a plate that vibrates vertically; displacements near the surface follow a power law.",
    figures: ["lid-height", "spectrum"],
    runs: [
      ...ran.map((code) => run(code, 4.0e8)),
      absentRun("yade", "run_failed", "killed at the time limit of 60 s", log),
    ],
    measurements: ran.map((code, i) =>
      measurement(code, "spectrum-exponent", [-1.66, -1.68, -1.63][i], 0.04, window),
    ),
    verdicts: bedVerdicts(),
    series: bedSeries(ran),
  };
}

/** In the catalogue, but never run. */
function bedDeep() {
  const nothing = { runs: [], measurements: [], verdicts: [], series: [] };
  return {
    case: "bed-deep",
    title: "vibrated bed, 40 layers",
    text: "",
    source: "",
    figures: ["lid-height"],
    ...nothing,
  };
}

export const allCases = () => [collisionNormal(), gasParity(), bedFluid(), bedDeep()];
