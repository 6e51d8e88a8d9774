// The small chart of one series of the history: values with errors over the band of earlier values.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { list } = crossgrain.data;
  const { axis, figure, plain, variable } = crossgrain.plot;
  const format = crossgrain.format;

  const hasBand = (series) => list(series.band).length === 2 && series.band.every(format.isNumber);

  function bandShape(series) {
    if (!hasBand(series)) return [];
    return [
      {
        type: "rect",
        xref: "paper",
        x0: 0,
        x1: 1,
        y0: series.band[0],
        y1: series.band[1],
        fillcolor: variable("--band"),
        line: { width: 0 },
        layer: "below",
      },
    ];
  }

  function trace(series) {
    const points = list(series.points);
    const color = crossgrain.codes.color(series.code);
    const isLast = (i) => i === points.length - 1;
    return {
      type: "scatter",
      mode: "lines+markers",
      meta: "history",
      x: points.map((p) => p.entry),
      y: points.map((p) => p.value),
      error_y: {
        type: "data",
        array: points.map((p) => p.stderr || 0),
        thickness: 1,
        width: 2,
        color,
      },
      line: { color, width: 1.4 },
      marker: {
        color,
        size: points.map((_, i) => (isLast(i) ? 8 : 4)),
        symbol: points.map((_, i) =>
          isLast(i) && series.status === "left_band" ? "triangle-up" : "circle",
        ),
      },
      customdata: points.map((p) => [
        format.exact(p.value),
        format.exact(p.stderr ?? 0),
        plain(format.date(p.created)),
        plain(p.version || "version unknown"),
      ]),
      hovertemplate:
        "entry %{x}<br>%{customdata[0]} ± %{customdata[1]}" +
        plain(format.unit(series.unit)) +
        "<br>%{customdata[2]}<br>%{customdata[3]}<extra></extra>",
    };
  }

  /** The value axis names its two ends only; all charts have the same frame, so that they line up. */
  function axes(series) {
    const points = list(series.points);
    const ends = [
      ...points.flatMap((p) =>
        format.isNumber(p.value) ? [p.value - (p.stderr || 0), p.value + (p.stderr || 0)] : [],
      ),
      ...(hasBand(series) ? series.band : []),
    ];
    if (ends.length === 0) return { xaxis: axis(""), yaxis: axis("") };
    const low = Math.min(...ends);
    const high = Math.max(...ends);
    const margin = 0.18 * (high - low) || Math.abs(high) || 1;
    return {
      xaxis: axis("", {
        ticks: "",
        tickfont: { size: 10 },
        tick0: 0,
        dtick: Math.max(1, Math.ceil(points.length / 8)),
        automargin: false,
      }),
      yaxis: axis("", {
        ticks: "",
        tickfont: { size: 10 },
        range: [low - margin, high + margin],
        tickvals: [low, high],
        ticktext: format.range(low, high),
        automargin: false,
      }),
    };
  }

  function chart(series) {
    return figure({
      name: "history",
      label: "History of " + series.observable + " of " + series.code,
      height: 84,
      config: { displayModeBar: false },
      build: () => ({
        data: [trace(series)],
        layout: {
          shapes: bandShape(series),
          margin: { l: 84, r: 6, t: 3, b: 15 },
          ...axes(series),
        },
      }),
    });
  }

  crossgrain.historyChart = { chart, hasBand };
})(window.crossgrain);
