// What several models say of one curve, in one pair of axes: the figures of a phenomenon.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { list } = crossgrain.data;
  const { axis, figure, plain } = crossgrain.plot;
  const format = crossgrain.format;

  function trace(curve) {
    const look = crossgrain.codes.look(curve.code);
    const color = crossgrain.codes.color(curve.code);
    const errors = list(curve.stderr);
    const few = list(curve.x).length <= 40;
    return {
      type: "scatter",
      mode: few ? "lines+markers" : "lines",
      meta: "model",
      name: plain(curve.title),
      legendgroup: curve.title,
      x: curve.x,
      y: curve.y,
      line: { color, width: 1.6 },
      marker: { color, symbol: look.symbol, size: look.size, line: { width: 1.4 } },
      error_y:
        few && errors.some((error) => error > 0)
          ? { type: "data", array: errors, thickness: 1, width: 2, color }
          : undefined,
      customdata: errors.map((error) => (error > 0 ? " ± " + format.exact(error) : "")),
      hovertemplate: "%{x}: %{y}%{customdata}<extra>%{fullData.name}</extra>",
    };
  }

  const build = (item) => ({
    data: list(item.curves).map(trace),
    layout: { xaxis: axis(plain(item.x)), yaxis: axis(plain(item.y)) },
  });

  /** The figures of a phenomenon, one below the other. */
  crossgrain.modelsFigures = (phenomenon) =>
    list(phenomenon.figures).map((item) =>
      figure({
        name: "models",
        title: item.title,
        height: 380,
        label: item.title + ", " + phenomenon.title,
        legend: list(item.curves).map((curve) => ({
          group: curve.title,
          text: curve.title,
          style: crossgrain.codes.look(curve.code),
        })),
        build: () => build(item),
      }),
    );
})(window.crossgrain);
