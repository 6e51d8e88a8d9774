// Curves of series the page has no section for, and displacement fields as arrows.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { list, column, columnUnit } = crossgrain.data;
  const { axis, logAxis, plain, variable } = crossgrain.plot;
  const { errorsOf, bands, isArrows } = crossgrain.columns;
  const format = crossgrain.format;

  const colours = [
    "native-dem",
    "lammps",
    "liggghts",
    "native-lga",
    "native-hopper",
    "yade",
    "other-2",
    "other-3",
  ];
  const dashes = ["solid", "6px,4px", "2px,3px", "9px,3px,2px,3px"];
  const mostRows = 1500; // per curve; a screen shows no more
  const mostArrows = 4000;

  const styleOf = (i) => ({
    variable: "--code-" + colours[i % colours.length],
    dash: dashes[Math.floor(i / colours.length) % dashes.length],
    width: 1.6,
  });

  /** Rows that are drawn: all, or as many as a screen can show, evenly on the axis. */
  function rowsOf(x, log) {
    const rows = x.map((_, i) => i);
    if (x.length <= mostRows) return rows;
    if (!log) return rows.filter((i) => i % Math.ceil(x.length / mostRows) === 0);
    const kept = new Set();
    for (let i = 0; i < mostRows; i += 1)
      kept.add(Math.floor(Math.pow(x.length, i / (mostRows - 1))) - 1);
    return rows.filter((i) => kept.has(i));
  }

  /** A table in long form repeats its abscissa: its curve begins anew where x falls back. */
  function broken(rows, x) {
    return rows.flatMap((row, i) => (i > 0 && x[row] < x[rows[i - 1]] ? [-1, row] : [row]));
  }

  /** Points for what was measured where the same table holds fits to it; else lines. */
  function modeOf(series, quantity, few) {
    const hasFits = list(series.columns).some((name) => /\bfit\b/.test(name));
    if (hasFits && !/\bfit\b/.test(quantity)) return "markers";
    return few && errorsOf(series, quantity).length ? "markers+lines" : "lines";
  }

  function curve({ series, quantity, label, style }, types) {
    const abscissa = list(series.columns)[0];
    const x = column(series, abscissa);
    const y = column(series, quantity);
    const errors = errorsOf(series, quantity);
    const rows = broken(rowsOf(x, types.x === "log"), x);
    const pick = (values) => rows.map((row) => (row < 0 ? null : (values[row] ?? null)));
    const color = variable(style.variable);
    const few = rows.length <= 80;
    return {
      type: "scatter",
      mode: y.length < 2 ? "markers" : modeOf(series, quantity, few),
      meta: "curve",
      name: plain(label),
      legendgroup: label,
      connectgaps: false,
      x: pick(x),
      y: pick(y),
      line: { color, width: style.width, dash: style.dash },
      marker: { color, size: 5 },
      error_y:
        few && errors.length
          ? {
              type: "data",
              array: pick(errors).map((value) => (format.isNumber(value) ? value : 0)),
              thickness: 1,
              width: 2,
              color,
            }
          : undefined,
      customdata: pick(errors).map((value) =>
        format.isNumber(value) ? " ± " + format.exact(value) : "",
      ),
      hovertemplate:
        plain(abscissa) +
        " = %{x}<br>" +
        plain(quantity) +
        " = %{y}%{customdata}<extra>%{fullData.name}</extra>",
    };
  }

  /** The band between two columns, below everything else. */
  function band(series, [low, high]) {
    const x = column(series, list(series.columns)[0]);
    const edge = { type: "scatter", mode: "lines", x, hoverinfo: "skip", line: { width: 0 } };
    return [
      { ...edge, meta: "band-edge", y: column(series, low) },
      {
        ...edge,
        meta: "band",
        y: column(series, high),
        fill: "tonexty",
        fillcolor: variable("--band"),
      },
    ];
  }

  /** Power laws of a series "<name>-fit" over their windows; see the README for its columns. */
  function fitLines(fits, quantity, style) {
    return fits.flatMap((fit) => {
      const names = list(fit.columns);
      const [from, to] = ["_min", "_max"].map((ending) =>
        names.find((name) => name.endsWith(ending)),
      );
      if (!from || !to) return [];
      const at = (name, row) => column(fit, name)[row];
      return column(fit, from).flatMap((low, row) => {
        const layers = names.includes("layer_first")
          ? at("layer_first", row) + "_" + at("layer_last", row)
          : "";
        if (layers && !quantity.endsWith(layers)) return [];
        const x = [low, at(to, row)];
        return [
          {
            type: "scatter",
            mode: "lines",
            meta: "fit",
            x,
            y: x.map((value) => at("amplitude", row) * Math.pow(value, at("exponent", row))),
            line: { color: variable(style.variable), width: 2.4, dash: "1px,2px" },
            hovertemplate:
              "exponent " +
              format.withError(at("exponent", row), at("exponent_err", row)) +
              "<extra></extra>",
          },
        ];
      });
    });
  }

  const scaled = (type, title, values) => (type === "log" ? logAxis(title, values) : axis(title));
  const titleOf = (series, name) => plain(name) + " (" + plain(columnUnit(series, name)) + ")";

  /** curves: [{series, quantity, label, style, fits}]; types: {x, y}, each "linear" or "log". */
  function curves(all, types) {
    const [first] = all;
    const abscissa = list(first.series.columns)[0];
    const outlines = all.length && bands(first.series).flatMap((pair) => band(first.series, pair));
    const lines = all.map((entry) => curve(entry, types));
    const fits = all.flatMap((entry) => fitLines(entry.fits || [], entry.quantity, entry.style));
    const several = new Set(all.map((entry) => entry.quantity)).size > 1;
    const unit = columnUnit(first.series, first.quantity);
    return {
      data: [...outlines, ...lines, ...fits],
      layout: {
        xaxis: scaled(
          types.x,
          titleOf(first.series, abscissa),
          lines.flatMap((line) => line.x),
        ),
        yaxis: scaled(
          types.y,
          several
            ? plain(first.series.name) + " (" + plain(unit) + ")"
            : titleOf(first.series, first.quantity),
          [...lines, ...outlines].flatMap((line) => line.y),
        ),
      },
    };
  }

  /** Arrows from (x, y) to (x + dx, y + dy), as one broken line with heads. */
  function arrows(series) {
    const [x, y, dx, dy] = ["x", "y", "dx", "dy"].map((name) => column(series, name));
    const head = 0.25;
    const every = Math.ceil(x.length / mostArrows);
    const line = { x: [], y: [] };
    x.forEach((_, i) => {
      if (i % every > 0 || ![x[i], y[i], dx[i], dy[i]].every(format.isNumber)) return;
      const end = [x[i] + dx[i], y[i] + dy[i]];
      const wing = (side) => [
        end[0] - head * (dx[i] + side * dy[i]),
        end[1] - head * (dy[i] - side * dx[i]),
      ];
      for (const point of [[x[i], y[i]], end, wing(0.6), end, wing(-0.6), [null, null]]) {
        line.x.push(point[0]);
        line.y.push(point[1]);
      }
    });
    return {
      data: [
        {
          type: "scatter",
          mode: "lines",
          meta: "arrows",
          ...line,
          connectgaps: false,
          hoverinfo: "skip",
          line: { color: variable("--text"), width: 0.9 },
        },
      ],
      layout: {
        xaxis: axis(titleOf(series, "x")),
        yaxis: axis(titleOf(series, "y"), { scaleanchor: "x", scaleratio: 1 }),
      },
    };
  }

  /** What a reader must know about the drawing of a series. */
  function notes(series) {
    const rows = column(series, list(series.columns)[0]).length;
    const every = Math.ceil(rows / mostArrows);
    if (isArrows(series)) return every > 1 ? ["One of " + every + " arrows is drawn."] : [];
    return [
      ...bands(series).map(([low, high]) => "Shaded: between " + low + " and " + high + "."),
      ...(rows > mostRows ? ["Drawn with at most " + mostRows + " of " + rows + " rows."] : []),
    ];
  }

  crossgrain.seriesPlot = { curves, arrows, styleOf, notes };
})(window.crossgrain);
