// Series of the test documents, from formulas.

const range = (count, f) => Array.from({ length: count }, (_, i) => f(i));
/** A smooth stand-in for scatter, between -1 and 1. */
const wobble = (i) => Math.sin(12.9898 * (i + 1)) * Math.cos(4.1414 * i);

function lidHeight(code, k) {
  const t = range(400, (i) => 0.05 * i);
  const bottom = t.map((time) => 0.3 * Math.sin((2 * Math.PI * time) / 10));
  // Codes separate exponentially from the last bit on; the first samples are identical.
  const h = t.map(
    (time, i) =>
      12 +
      0.25 * Math.sin((2 * Math.PI * time) / 10 - 0.4) +
      0.4 * Math.exp(-time / 6) +
      (k === 0 || i < 4 ? 0 : 2e-15 * k * Math.exp(1.35 * time) * (1 + 0.5 * wobble(i))),
  );
  return {
    code,
    variant: "full",
    replica: 0,
    name: "lid-height",
    columns: ["t", "h", "bottom", "spacing"],
    units: ["reduced time", "grain diameters", "grain diameters", "grain diameters"],
    values: [t, h, bottom, h.map((value, i) => value - bottom[i])],
  };
}

const layerGroups = [
  { id: "1_5", exponent: -1.66, level: 0.02 },
  { id: "6_10", exponent: -1.1, level: 0.006 },
  { id: "11_20", exponent: -0.4, level: 0.002 },
];

function spectrum(code, k) {
  const K = range(32, (i) => i + 1);
  const columns = ["K"];
  const values = [K];
  for (const { id, exponent, level } of layerGroups) {
    const S = K.map(
      (value, i) =>
        level * Math.pow(value, exponent) * (1 + 0.12 * wobble(i + 40 * k)) + level * 3e-3,
    );
    columns.push("S_" + id, "err_" + id);
    values.push(
      S,
      S.map((value) => 0.15 * value),
    );
  }
  return {
    code,
    variant: "full",
    replica: 0,
    name: "spectrum",
    columns,
    values,
    units: ["2π/L", ...columns.slice(1).map(() => "d²")],
  };
}

function spectrumFit(code, k) {
  const rows = layerGroups.map(({ id, exponent, level }) => [
    ...id.split("_").map(Number),
    1,
    16,
    exponent + 0.02 * k,
    0.04,
    level,
  ]);
  const columns = [
    "layer_first",
    "layer_last",
    "k_min",
    "k_max",
    "exponent",
    "exponent_err",
    "amplitude",
  ];
  return {
    code,
    variant: "full",
    replica: 0,
    name: "spectrum-fit",
    columns,
    values: columns.map((_, i) => rows.map((row) => row[i])),
  };
}

export function bedSeries(codes) {
  return codes.flatMap((code, k) => [lidHeight(code, k), spectrum(code, k), spectrumFit(code, k)]);
}

export function convergenceSeries(codes) {
  const orders = { "native-dem": 2, lammps: 1.98, liggghts: 0.99, yade: 1.01 };
  return codes.map((code, k) => {
    const dt = range(7, (i) => 2e-3 / 2 ** i);
    const rms = dt.map((value) => (3 + 0.4 * k) * Math.pow(value * 40, orders[code]) * 0.1);
    return {
      code,
      variant: "full",
      replica: 0,
      name: "convergence",
      columns: ["dt", "mean_error", "rms_error"],
      units: ["contact times", "1", "1"],
      values: [dt, rms.map((value) => -0.7 * value), rms],
    };
  });
}
