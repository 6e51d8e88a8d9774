// History of the test documents: twelve entries per series; one series leaves its band at the last
// entry, one has too few entries to be judged.

const wobble = (i) => Math.sin(12.9898 * (i + 1)) * Math.cos(4.1414 * i);

function points(count, value, scatter, version) {
  return Array.from({ length: count }, (_, i) => ({
    entry: i + 1,
    created: new Date(Date.UTC(2026, 9, 1 + 4 * i, 5)).toISOString(),
    value: value + scatter * wobble(i + value),
    stderr: 0.4 * scatter,
    version,
  }));
}

export function historySeries(codes, versions) {
  const quantities = [
    ["restitution", "1", "collision-normal", 0.8, 1e-5],
    ["cost", "particle-steps/CPU s", "bed-fluid", 1.4e7, 2e5],
    ["spectrum-exponent", "1", "bed-fluid", -1.66, 0.03],
  ];
  const series = codes.flatMap((code) =>
    quantities.map(([observable, unit, name, value, scatter]) => ({
      case: name,
      variant: "full",
      code,
      observable,
      unit,
      points: points(12, value, scatter, versions[code]),
      band: [value - 1.5 * scatter, value + 1.5 * scatter],
      status: "in_band",
    })),
  );
  const slowed = series.find((entry) => entry.code === "lammps" && entry.observable === "cost");
  slowed.points.at(-1).value = 0.9e7;
  slowed.status = "left_band";
  slowed.reason = "36 % fewer particle-steps per CPU second";
  const young = series.find((entry) => entry.code === "yade" && entry.observable === "restitution");
  Object.assign(young, { points: young.points.slice(0, 2), band: [null, null], status: "too_few" });
  return series;
}
