// Models against molecular dynamics: a phenomenon's table and figure, and what conventions of
// friction are worth.
const cell = (column, value, stderr, more = {}) => ({
  column,
  source: "wave_over_speed",
  case: "pipe-grains",
  variant: "",
  reason: "",
  measured_nothing: false,
  verdict: null,
  value,
  stderr,
  ...more,
});

const columns = [
  { name: "gas", title: "lattice <gas>", code: "native-lga", case: "pipe-gas-fig6", variant: "P" },
  { name: "native", title: "native DEM", code: "native-dem", case: "pipe-grains", variant: "" },
  { name: "yade", title: "YADE", code: "yade", case: "pipe-grains", variant: "" },
];

const row = (quantity, verdict, cells, left_out) => ({
  quantity,
  against: "native",
  margin: 0.05,
  relative: true,
  reason: "5 % between codes",
  left_out,
  verdict,
  cells,
});

export const phenomena = () => [
  {
    phenomenon: "pipe",
    title: "density waves in a pipe",
    text: "Free of units.",
    columns,
    rows: [
      row(
        "V_w/V",
        "disagree",
        [
          cell("gas", 0.459, 0.004, { verdict: "disagree" }),
          cell("native", 1.391, 0.005),
          cell("yade", 1.428, 0.01, { verdict: "agree" }),
        ],
        "movers of the lattice gas have one speed",
      ),
      row(
        "k^-a",
        "agree",
        [cell("native", 1, 0), cell("yade", 1, 0, { verdict: "agree" })],
        "nothing",
      ),
    ],
    pictures: [],
    figures: [
      {
        title: "P, over the angle",
        x: "theta",
        y: "P",
        curves: [
          {
            title: "automaton",
            code: "native-hopper",
            x: [10, 30, 90],
            y: [1, 0.3, 0.02],
            stderr: [0, 0.1, 0.01],
          },
          { title: "YADE", code: "yade", x: [30, 60], y: [0.4, 0.05], stderr: [0, 0] },
        ],
      },
    ],
  },
];

const told = (value, significant = true) => ({ value, stderr: 0.02, significant });

export const attribution = () => [
  {
    case: "attribution-friction",
    a: "lammps",
    b: "liggghts",
    code: "native-dem",
    switches: [
      { switch: "velocity_lever", from: "radius", to: "overlap" },
      { switch: "limit", from: "rescaled", to: "kept" },
    ],
    observables: [
      {
        observable: "mean_square_spin",
        unit: "1/t^2",
        a: told(10),
        b: told(11),
        difference: told(1),
        significant: true,
        contributions: [
          { switch: "velocity_lever", average: told(0.7), significant: true },
          { switch: "limit", average: told(0.2), significant: false },
        ],
        interaction: told(0.1),
      },
    ],
  },
];
