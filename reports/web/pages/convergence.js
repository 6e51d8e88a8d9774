// Error of the coefficient of restitution against the time step, per code and variant, with the
// fitted order: mean error and root mean square error side by side, log-log.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, table } = crossgrain.dom;
  const { list, column, columnUnit, seriesNamed, perCase } = crossgrain.data;
  const { logAxis, guideLabel, figure, plain, variable } = crossgrain.plot;
  const format = crossgrain.format;

  const measures = [
    { column: "mean_error", title: "|mean error|" },
    { column: "rms_error", title: "root mean square error" },
  ];
  const nameOf = (series) => series.code + (series.variant ? ", " + series.variant : "");

  function orderOf(item, series) {
    return list(item.measurements).find(
      (m) =>
        m.observable === "convergence-order" &&
        m.code === series.code &&
        (m.variant || "") === (series.variant || ""),
    );
  }

  /** Variants of one code share its colour; the dash tells them apart. */
  function styleOf(item, series) {
    const siblings = seriesNamed(item, "convergence").filter((other) => other.code === series.code);
    return {
      ...crossgrain.codes.look(series.code),
      width: 1.6,
      dash: ["solid", "5px,4px", "2px,3px"][siblings.indexOf(series) % 3],
    };
  }

  function trace(item, series, measure) {
    const look = styleOf(item, series);
    const values = column(series, measure.column);
    return {
      type: "scatter",
      mode: "lines+markers",
      meta: "convergence",
      name: plain(nameOf(series)),
      legendgroup: nameOf(series),
      x: column(series, "dt"),
      y: values.map((value) => Math.abs(value) || null),
      customdata: values.map(format.exact),
      line: { color: crossgrain.codes.color(series.code), dash: look.dash, width: look.width },
      marker: {
        color: crossgrain.codes.color(series.code),
        symbol: look.symbol,
        size: look.size,
        line: { width: 1.4 },
      },
      hovertemplate:
        "dt = %{x:.4g}<br>" + measure.title + ": %{customdata}<extra>%{fullData.name}</extra>",
    };
  }

  /** Slopes 1 and 2 from the largest time step down, to read orders by eye. */
  function guides(all, measure) {
    const dt = all.flatMap((series) => column(series, "dt")).filter((value) => value > 0);
    const errors = all
      .flatMap((series) => column(series, measure.column))
      .map(Math.abs)
      .filter((value) => value > 0);
    if (dt.length < 2 || errors.length === 0) return [];
    const x = [Math.min(...dt), Math.max(...dt)];
    return [1, 2].map((order) => ({
      type: "scatter",
      mode: "lines",
      meta: "guide",
      name: "order " + order,
      hoverinfo: "skip",
      x,
      y: x.map((value) => 2 * Math.max(...errors) * Math.pow(value / x[1], order)),
      line: { color: variable("--soft"), dash: "1px,3px", width: 1.6 },
    }));
  }

  function build(item, measure) {
    const all = seriesNamed(item, "convergence");
    const lines = guides(all, measure);
    const data = [...all.map((series) => trace(item, series, measure)), ...lines];
    return {
      data,
      layout: {
        xaxis: logAxis(
          "dt (" + plain(columnUnit(all[0], "dt")) + ")",
          all.flatMap((series) => column(series, "dt")),
        ),
        yaxis: logAxis(
          measure.title + " (" + plain(columnUnit(all[0], measure.column)) + ")",
          data.flatMap((entry) => entry.y),
        ),
        annotations: lines.map((entry) =>
          guideLabel(entry.name, entry.x[0], entry.y[0], { xanchor: "left", yanchor: "bottom" }),
        ),
      },
    };
  }

  function panel(item, measure) {
    return figure({
      name: "convergence",
      title: measure.title,
      height: 330,
      label: measure.title + " against time step, " + item.case,
      legend: seriesNamed(item, "convergence").map((series) => ({
        group: nameOf(series),
        text: nameOf(series),
        style: styleOf(item, series),
      })),
      build: () => build(item, measure),
    });
  }

  function orders(item) {
    const columns = [
      { title: "code, variant" },
      { title: "fitted order", numeric: true },
      { title: "time steps", numeric: true },
      { title: "fit" },
    ];
    const rows = seriesNamed(item, "convergence").map((series) => {
      const order = orderOf(item, series);
      return [
        nameOf(series),
        order ? format.withError(order.value, order.stderr) : "not recorded",
        String(column(series, "dt").length),
        order ? format.settings(order.settings) : "",
      ];
    });
    return table({
      caption: "Order of convergence, " + item.case,
      columns,
      rows,
      className: "compact",
    });
  }

  crossgrain.convergence = (report) =>
    perCase(report, "convergence", (item, absent) => [
      el("h3", {}, item.case),
      absent.length ? el("p", { class: "note" }, absent.join("; ") + ".") : null,
      el(
        "div",
        { class: "panels" },
        measures.map((measure) => panel(item, measure)),
      ),
      orders(item),
    ]);
})(window.crossgrain);
