// The certificate of the test documents: with and without a recorded curve, with a bed, with a zero.

const times = Array.from({ length: 60 }, (_, i) => 0.01 * Math.pow(10, i / 19.67));

function curve(rate) {
  const distance = times.map((t) => Math.min(2.0, 2e-16 * (1 + 40 * t) * Math.exp(rate * t)));
  return { columns: ["t", "max_dx"], values: [times, distance] };
}

function pair(name, b, max_dx, digits, extra) {
  const verdict = { verdict: "agree", expected: true, reason: "" };
  const limits = { 1: 1e-13, 10: 1e-11, 100: 1e-6 };
  return {
    case: name,
    a: "native-dem",
    b,
    contact_time: 0.1,
    max_dx,
    digits,
    limits,
    max_dh: {},
    ...verdict,
    ...extra,
  };
}

const gas = [
  pair(
    "gas-parity",
    "lammps",
    { 1: 2e-16, 10: 4e-13, 100: 1.2e-8 },
    { 1: 15.7, 10: 12.4, 100: 7.9 },
    {
      curve: curve(1.6),
    },
  ),
  pair(
    "gas-parity",
    "liggghts",
    { 1: 0, 10: 7e-13, 100: 3e-6 },
    { 1: 16, 10: 12.2, 100: 5.5 },
    {
      verdict: "undecided",
      reason: "left the limit late, as chaos does",
      curve: curve(2.2),
    },
  ),
];

const bed = [
  pair(
    "bed-fluid",
    "lammps",
    { 1: 0, 10: 3e-14 },
    { 1: 16, 10: 13.5 },
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
    {
      verdict: "disagree",
      expected: false,
      reason: "apart from the first clip of the damping force on",
    },
  ),
];

export const certificate = () =>
  structuredClone({ length_unit: "grain diameters", pairs: [...gas, ...bed] });
