// Cases of the models beside the grains: readings, sweeps, findings, pictures, series without a
// section of their own.
import { deflateSync } from "node:zlib";
import { measurement, run, verdict } from "./make_entries.mjs";

const range = (count, f) => Array.from({ length: count }, (_, i) => f(i));

/** All variants of a sweep {key: values}; text plain, numbers as key=value, first key slowest. */
export function variantsOf(sweep) {
  let variants = [{ name: "", parameters: {} }];
  for (const [key, values] of Object.entries(sweep))
    variants = variants.flatMap(({ name, parameters }) =>
      values.map((value) => ({
        name: (name ? name + "/" : "") + (typeof value === "string" ? value : key + "=" + value),
        parameters: { ...parameters, [key]: String(value) },
      })),
    );
  return variants;
}

export const swept = (sweep) => ({ sweep: Object.keys(sweep), variants: variantsOf(sweep) });

export function modelRun(code, variant) {
  return { ...run("native-dem", 1e8), code, variant, version: "0.1.0", work_unit: "site-updates" };
}

function picture(code, variant, name, width, height) {
  const pixels = Buffer.from(range(width * height, (i) => (i * 7 + Math.floor(i / width)) % 3));
  return {
    code,
    variant,
    name,
    title: "time upwards; white: empty, blue: 1, red: 2 <particles>",
    width,
    height,
    palette: [
      [255, 255, 255],
      [15, 85, 216],
      [163, 17, 47],
    ],
    pixels: deflateSync(pixels).toString("base64"),
  };
}

export const finding = (code, variant, name, label, detail = "") => ({
  code,
  variant,
  replica: 0,
  rung: 0,
  name,
  label,
  detail,
});

/** P(f) with exponent -alpha, and the contrast with its errors and its white-noise value. */
export function gasSeries(variant, alpha, rows) {
  const f = range(rows, (i) => (i + 1) / (2 * rows));
  const t = range(rows, (i) => 100 * i);
  const common = { code: "native-lga", variant, replica: 0, rung: 0 };
  return [
    {
      ...common,
      name: "spectrum",
      columns: ["f", "P"],
      units: ["1/step", "step"],
      values: [f, f.map((x) => Math.pow(x, -alpha))],
    },
    {
      ...common,
      name: "contrast",
      columns: ["t", "C", "err", "C_white"],
      units: ["steps", "1", "1", "1"],
      values: [t, t.map((x) => 1 + Math.tanh(x / 2000)), t.map(() => 0.05), t.map(() => 1)],
    },
  ];
}

const fig6 = { reading: ["P", "D", "std"], dissipation: [0.1, 0.5] };

function alphaVerdict({ name, parameters }, i) {
  const question = {
    code: "native-lga",
    observable: "alpha",
    kind: "published",
    against: "published:peng-herrmann-1994/fig6-alpha",
    setting: name,
    reading: parameters.reading,
  };
  const outcome = ["agree", "agree", "agree", "disagree", "undecided", "disagree"][i];
  return verdict(question, [0.02 * i, 0.03, 0.1], outcome, { reason: "reason of " + name });
}

function pipeGasFig6() {
  const { sweep, variants } = swept(fig6);
  const code = "native-lga";
  const trend = {
    code,
    observable: "alpha",
    kind: "published",
    against: "published:peng-herrmann-1994/fig6-constant",
  };
  return {
    case: "pipe-gas-fig6",
    title: "alpha against dissipation",
    source: "Peng and Herrmann 1994, figure 6",
    text: "",
    model: "lattice-gas",
    figures: [],
    sweep,
    variants,
    runs: variants.map(({ name }) => modelRun(code, name)),
    measurements: variants.map(({ name }, i) =>
      measurement(code, "alpha", 1.33 + 0.02 * i, 0.015, { variant: name }),
    ),
    verdicts: [
      ...variants.map(alphaVerdict),
      ...["P", "D"].map((reading) =>
        verdict({ ...trend, setting: reading, reading }, [0.01, 0.02, 0.1]),
      ),
    ],
    series: variants.flatMap(({ name }, i) => gasSeries(name, 1.33 + 0.02 * i, 200)),
    pictures: [
      picture(code, "P/dissipation=0.1", "space-time", 20, 400),
      picture(code, "P/dissipation=0.5", "space-time", 20, 400),
      { ...picture(code, "D/dissipation=0.1", "space-time", 20, 400), pixels: "damaged" },
    ],
    findings: variants.map(({ name }, i) =>
      finding(code, name, "state", i % 2 ? "ageing" : "steady", "drift " + i),
    ),
  };
}

/** One number and two names: readings take the other side, variants beside the sweep make maps. */
function pipeGasLimits() {
  const code = "native-lga";
  const { variants } = swept({
    reading: ["P", "D"],
    density: [7, 0.8],
    variant: ["rough", "smooth"],
  });
  const named = variants.map(({ parameters }) => ({
    name: parameters.reading + "/density=" + parameters.density + "/" + parameters.variant,
    parameters,
  }));
  return {
    ...pipeGasFailure(),
    case: "pipe-gas-limits",
    sweep: ["reading", "density", "variant"],
    variants: named,
    runs: named.map(({ name }) => modelRun(code, name)),
    findings: named.map(({ name }) => finding(code, name, "state", name)),
  };
}

const mapStates = [
  "steady",
  "ageing",
  "absorbing",
  "saturated",
  "clogged",
  "no steady state",
  "melted",
];

/** Two numbers and a name: one map per reading. */
function pipeGasFailure() {
  const { sweep, variants } = swept({
    reading: ["P", "D"],
    density: [0.5, 1, 10],
    gravity: [0.01, 0.5],
  });
  const code = "native-lga";
  const some = variants.slice(0, -1); // the last one has not run
  return {
    case: "pipe-gas-failure",
    title: "where the gas stops making sense",
    text: "",
    source: "",
    model: "lattice-gas",
    figures: [],
    sweep,
    variants,
    runs: some.map(({ name }) => modelRun(code, name)),
    measurements: [],
    verdicts: [],
    series: [],
    pictures: [],
    findings: some.map(({ name }, i) =>
      finding(code, name, "state", mapStates[i % mapStates.length], "at " + name),
    ),
  };
}

function hopperAutomaton() {
  const code = "native-hopper";
  const theta = range(78, (i) => 13 + i);
  const law = (a, scale) => theta.map((x) => scale * Math.pow(x, a));
  const common = { code, variant: "", replica: 0, rung: 0 };
  return {
    case: "hopper-automaton",
    title: "share of stagnant grains",
    text: "",
    source: "",
    model: "hopper-automaton",
    figures: [],
    sweep: [],
    variants: [{ name: "", parameters: {} }],
    runs: [modelRun(code, "")],
    measurements: [],
    verdicts: [],
    series: [
      {
        ...common,
        name: "stagnation-fits",
        columns: ["theta", "1/P", "unweighted fit", "log fit", "experiment 2.1", "experiment 2.3"],
        units: ["degrees", "1", "1", "1", "1", "1"],
        values: [theta, law(2.2, 1), law(2.5, 0.5), law(2.1, 1.3), law(2.1, 1.4), law(2.3, 0.7)],
      },
      {
        ...common,
        name: "stagnation",
        columns: ["theta", "iteration", "left", "P", "standard_error"],
        units: ["degrees", "iterations", "1", "1", "1"],
        values: [
          [...theta, ...theta],
          [...theta.map(() => 50), ...theta.map(() => 500)],
          ...[1, 1, 0.1].map((scale) => [...law(-2.2, scale), ...law(-2.5, scale)]),
        ],
      },
    ],
    pictures: [picture(code, "", "orientation-1000", 40, 30)],
    findings: [
      finding(code, "", "state", "bands"),
      { ...finding(code, "", "state", "patches", "vertical share .74"), replica: 1 },
    ],
  };
}

function bedSolid() {
  const places = range(60, (i) => [
    i % 10,
    Math.floor(i / 10),
    0.3 * Math.cos(i),
    0.3 * Math.sin(i),
  ]);
  const values = range(4, (column) => places.map((place) => place[column]));
  const field = {
    code: "native-dem",
    variant: "",
    replica: 0,
    rung: 0,
    name: "displacement-field",
  };
  return {
    case: "bed-solid",
    title: "bed below fluidisation",
    text: "",
    source: "",
    model: "grains",
    figures: [],
    runs: [run("native-dem", 1e8, { variant: "" })],
    measurements: [],
    verdicts: [],
    series: [{ ...field, columns: ["x", "y", "dx", "dy"], units: ["l", "l", "l", "l"], values }],
    pictures: [],
    findings: [],
  };
}

export const modelCases = () => [
  pipeGasFig6(),
  pipeGasFailure(),
  pipeGasLimits(),
  hopperAutomaton(),
  bedSolid(),
];

/** Many cases of many variants, to see that the page stays light. */
export function manyCases(cases, readings, values) {
  const code = "native-lga";
  return range(cases, (c) => {
    const { sweep, variants } = swept({
      reading: readings,
      dissipation: range(values, (i) => 0.1 * (i + 1)),
    });
    const questions = ["alpha", "velocity", "contrast"];
    return {
      ...pipeGasFig6(),
      case: "case-" + (c + 1),
      sweep,
      variants,
      runs: variants.flatMap(({ name }) =>
        [0, 1].map((replica) => ({ ...modelRun(code, name), replica })),
      ),
      measurements: variants.flatMap(({ name }, i) =>
        questions.map((observable) =>
          measurement(code, observable, 1 + 0.01 * i, 0.01, { variant: name }),
        ),
      ),
      verdicts: variants.flatMap((variant, i) =>
        questions.map((observable) => ({
          ...alphaVerdict(variant, i % 4),
          observable,
          expected: true,
        })),
      ),
      series: variants.flatMap(({ name }) => gasSeries(name, 1.3, 300)),
      pictures: variants.map(({ name }) => picture(code, name, "space-time", 40, 60)),
      findings: variants.map(({ name }, i) =>
        finding(code, name, "state", mapStates[i % mapStates.length]),
      ),
    };
  });
}
