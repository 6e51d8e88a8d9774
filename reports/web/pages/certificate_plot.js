// Growth of the distance between two codes: max |dx| against time in contact times, log-log, one
// panel per case. A ledge far below the limit is round-off; the climb is chaos.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing } = crossgrain.dom;
  const { list, column, groupBy } = crossgrain.data;
  const { logAxis, figure, plain, variable } = crossgrain.plot;
  const format = crossgrain.format;

  // Zero has no place on a log axis: shown on this floor with its own symbol, named in the note.
  const floor = 1e-18;

  /** The recorded curve, or else the certified points: {t (contact times), dx}. */
  function pointsOf(pair) {
    const curve = pair.curve || {};
    const t = column(curve, "t");
    if (t.length > 0 && pair.contact_time > 0)
      return { t: t.map((value) => value / pair.contact_time), dx: column(curve, "max_dx") };
    const times = Object.keys(pair.max_dx || {})
      .map(Number)
      .sort((a, b) => a - b);
    return { t: times, dx: times.map((time) => pair.max_dx[String(time)]) };
  }

  const nameOf = (pair) =>
    pair.a + " : " + pair.b + (pair.variant ? " (" + pair.variant + ")" : "");

  /** A pair has the colour of its second code; pairs without a native engine are dashed finely. */
  function styleOf(pair) {
    const look = crossgrain.codes.look(pair.b);
    return pair.a.startsWith("native")
      ? { ...look, width: 2 }
      : { ...look, width: 1.4, dash: "3px,3px" };
  }

  function trace(pair, unit) {
    const { t, dx } = pointsOf(pair);
    const style = styleOf(pair);
    const sparse = t.length < 30;
    return {
      type: "scatter",
      mode: sparse ? "lines+markers" : "lines",
      meta: "pair",
      name: plain(nameOf(pair)),
      legendgroup: nameOf(pair),
      x: t,
      y: dx.map((value) => (value === 0 ? floor : value)),
      customdata: dx.map(format.exact),
      line: { color: crossgrain.codes.color(pair.b), dash: style.dash, width: style.width },
      marker: {
        color: crossgrain.codes.color(pair.b),
        size: 8,
        symbol: dx.map((value) => (value === 0 ? "triangle-down" : style.symbol)),
      },
      hovertemplate:
        "%{x:.4g} contact times<br>max |Δx| = %{customdata} " +
        plain(unit) +
        "<extra>%{fullData.name}</extra>",
    };
  }

  /** [[time, limit]] of the certified times. */
  function limitsOf(pairs) {
    const certified = new Set(pairs.flatMap((pair) => Object.keys(pair.max_dx || {})));
    const limits = new Map(pairs.flatMap((pair) => Object.entries(pair.limits || {})));
    return [...limits]
      .filter(([time, value]) => value > 0 && certified.has(time))
      .map(([time, value]) => [Number(time), value]);
  }

  /** Short bars at the certified times: the distance must stay below them. */
  function limitShapes(pairs) {
    return limitsOf(pairs).map(([time, value]) => ({
      type: "line",
      x0: time / 1.35,
      x1: time * 1.35,
      y0: value,
      y1: value,
      line: { color: variable("--text"), width: 2 },
    }));
  }

  function panel(name, pairs, unit) {
    const zeros = pairs.some((pair) => pointsOf(pair).dx.includes(0));
    const notes = ["Short bars: limits"];
    if (zeros) notes.push("▼ exactly 0 (bit for bit), drawn at " + format.limit(floor));
    return figure({
      name: "certificate",
      title: name,
      label: "Distance between codes against time, " + name,
      height: 300,
      notes: [notes.join("; ") + "."],
      legend: pairs.map((pair) => ({
        group: nameOf(pair),
        text: nameOf(pair),
        style: styleOf(pair),
      })),
      build: () => ({
        data: pairs.map((pair) => trace(pair, unit)),
        layout: {
          shapes: limitShapes(pairs),
          xaxis: logAxis("time (contact times)", [
            ...pairs.flatMap((pair) => pointsOf(pair).t),
            ...limitsOf(pairs).flatMap(([time]) => [time / 1.35, time * 1.35]),
          ]),
          yaxis: logAxis("max |Δx| (" + plain(unit) + ")", [
            ...pairs.flatMap((pair) =>
              pointsOf(pair).dx.map((value) => (value === 0 ? floor : value)),
            ),
            ...limitsOf(pairs).map(([, value]) => value),
          ]),
        },
      }),
    });
  }

  crossgrain.certificatePlots = (pairs, unit) => {
    const drawable = pairs.filter((pair) => pointsOf(pair).t.length > 0);
    if (drawable.length === 0)
      return [missing("No distance against time is recorded for the certified pairs.")];
    const panels = [...groupBy(drawable, (pair) => pair.case)].map(([name, members]) =>
      panel(name, members, unit),
    );
    return [el("div", { class: "panels" }, panels)];
  };
})(window.crossgrain);
