// Where methods stop working: thresholds against theory, and maps of the states that runs were
// found in, one per code and per word of the sweep, with the line that theory draws across them.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing, table } = crossgrain.dom;
  const { list, groupBy } = crossgrain.data;
  const { axis, logAxis, figure, plain, variable } = crossgrain.plot;
  const format = crossgrain.format;

  const symbols = ["circle", "x", "triangle-up", "diamond", "square", "cross", "star", "hexagon"];
  const words = (named) => Object.values(named || {}).join(", ");
  const same = (a, b) =>
    Object.entries(a || {}).every(([key, value]) => !(key in b) || b[key] === value);

  function thresholds(item) {
    const all = list(item.thresholds);
    if (all.length === 0) return [];
    const columns = [
      { title: "code" },
      { title: "method" },
      { title: "works up to", numeric: true },
      { title: "fails from", numeric: true },
      { title: "theory", numeric: true },
      { title: "measured / theory", numeric: true },
      { title: "" },
    ];
    const rows = all.map((entry) => [
      crossgrain.codes.label(entry.code),
      entry.method,
      format.number(entry.works),
      format.number(entry.fails),
      entry.theory ? format.number(entry.theory) : "–",
      entry.theory ? format.number(entry.measured / entry.theory) : "–",
      entry.theory ? (entry.agrees ? "agrees" : "disagrees") : "",
    ]);
    const caption = "Largest stable time step, " + item.case;
    return [table({ caption, columns, rows, className: "compact" })];
  }

  /** Keys of numbers that change, the parameter that theory limits first. */
  function axes(points, theory) {
    const values = new Map();
    for (const point of points)
      for (const [key, value] of Object.entries(point.at || {}))
        values.set(key, (values.get(key) || new Set()).add(value));
    const changing = [...values].filter(([, seen]) => seen.size > 1).map(([key]) => key);
    const limited = theory.length > 0 ? theory[0].parameter : changing[0];
    return changing.sort((a, b) => (b === limited) - (a === limited));
  }

  function cloud(state, points, [y, x], rank) {
    return {
      type: "scatter",
      mode: "markers",
      meta: "states",
      name: plain(state),
      legendgroup: state,
      x: points.map((point) => (x ? point.at[x] : 1)),
      y: points.map((point) => point.at[y]),
      customdata: points.map((point) => plain(point.detail || "")),
      marker: {
        symbol: symbols[rank % symbols.length],
        size: 11,
        color: crossgrain.states.color(state),
        line: { width: 1.4, color: variable("--text") },
      },
      hovertemplate: "%{fullData.name}: %{customdata}<extra></extra>",
    };
  }

  function theoryTrace(theory, x) {
    const sorted = [...theory].sort((a, b) => (x ? a.at[x] - b.at[x] : 0));
    return {
      type: "scatter",
      mode: "lines+markers",
      meta: "theory",
      name: "theory",
      legendgroup: "theory",
      hovertemplate: "theory: stable up to %{y:.4g}<extra></extra>",
      x: sorted.map((line) => (x ? line.at[x] : 1)),
      y: sorted.map((line) => line.limit),
      marker: { size: 5, color: variable("--text") },
      line: { width: 1.6, color: variable("--text") },
    };
  }

  /** Where values stand along an axis: by logarithm, evenly, or one after the other beside a zero. */
  function scaleOf(key, values) {
    const distinct = [...new Set(values)].sort((one, other) => one - other);
    const positive = distinct.filter((value) => value > 0);
    const wide = positive.length > 1 && positive[positive.length - 1] > 5 * positive[0];
    const place = (value) => value;
    if (!wide) return { place, axis: axis(key) };
    if (positive.length === distinct.length) return { place, axis: logAxis(key, values) };
    const places = distinct.map((_, i) => i);
    const labels = { tickvals: places, ticktext: distinct.map((value) => format.number(value)) };
    return { place: (value) => distinct.indexOf(value), axis: axis(key, labels) };
  }

  function build(points, theory, keys, states) {
    const [y, x] = keys;
    const byState = groupBy(points, (point) => point.state);
    const data = [...byState].map(([state, found]) =>
      cloud(state, found, keys, states.indexOf(state)),
    );
    if (theory.length > 0) data.push(theoryTrace(theory, x));
    const values = (name) => data.flatMap((trace) => trace[name]);
    const along = x
      ? scaleOf(x, values("x"))
      : { place: (value) => value, axis: axis("", { showticklabels: false }) };
    const up = scaleOf(y, values("y"));
    for (const trace of data) {
      trace.x = trace.x.map(along.place);
      trace.y = trace.y.map(up.place);
    }
    return { data, layout: { xaxis: along.axis, yaxis: up.axis } };
  }

  /** One map: a code, and one word for every key that is named. */
  function map(item, points, keys, states) {
    const [first] = points;
    const theory = list(item.theory).filter(
      (line) =>
        line.parameter === keys[0] &&
        same(line.in, first.in) &&
        same(restOf(line.at, keys), first.at),
    );
    const title = [first.code, words(first.in)].filter(Boolean).join(", ");
    const present = states.filter((state) => points.some((point) => point.state === state));
    return figure({
      name: "stability-map",
      title,
      height: 260,
      label: title + ", " + item.case,
      notes: [present.join(", ") + (theory.length > 0 ? "; line: theory" : "")],
      build: () => build(points, theory, keys, states),
    });
  }

  const restOf = (at, keys) =>
    Object.fromEntries(Object.entries(at || {}).filter(([key]) => !keys.includes(key)));

  function maps(item) {
    const reached = list(item.points).filter((point) => point.state !== "not_expressible");
    if (reached.length === 0) return [];
    const keys = axes(reached, list(item.theory)).slice(0, 2);
    if (keys.length === 0) return [stateTable(item, reached)];
    const states = [...groupBy(reached, (point) => point.state).keys()];
    const groups = groupBy(
      reached,
      (point) => point.code + "|" + words(point.in) + "|" + JSON.stringify(restOf(point.at, keys)),
    );
    return [
      el("h3", {}, "States"),
      crossgrain.states.legend(reached.map((point) => point.state)),
      el(
        "div",
        { class: "stability-maps" },
        [...groups.values()].map((points) => map(item, points, keys, states)),
      ),
    ];
  }

  function stateTable(item, points) {
    const columns = [
      { title: "code" },
      { title: "where" },
      { title: "state" },
      { title: "detail" },
    ];
    const rows = points.map((point) => [
      crossgrain.codes.label(point.code),
      [
        words(point.in),
        ...Object.entries(point.at).map(([key, value]) => key + " = " + value),
      ].join(", "),
      crossgrain.states.state(point.state),
      point.detail,
    ]);
    return table({ caption: "States, " + item.case, columns, rows, className: "compact" });
  }

  function refused(item) {
    const all = list(item.points).filter((point) => point.state === "not_expressible");
    if (all.length === 0) return [];
    const columns = [{ title: "code" }, { title: "reason" }, { title: "points", numeric: true }];
    const rows = [...groupBy(all, (point) => point.code + "|" + point.detail).values()].map(
      (points) => [crossgrain.codes.label(points[0].code), points[0].detail, String(points.length)],
    );
    return [
      table({ caption: "Not in the maps of " + item.case, columns, rows, className: "compact" }),
    ];
  }

  crossgrain.stability = (report) => {
    const all = list(report.stability);
    if (all.length === 0) return [missing("No map: “crossgrain stability” writes them.")];
    return all.map((item) => [
      el("h2", { id: item.case }, item.case),
      thresholds(item),
      maps(item),
      refused(item),
    ]);
  };
})(window.crossgrain);
