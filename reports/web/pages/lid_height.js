// Height of the lid against time, all codes over each other with the bottom plate, and below it on a
// log axis how far each code is from the native engine.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el } = crossgrain.dom;
  const { column, columnUnit, seriesNamed, perCase, groupBy } = crossgrain.data;
  const { axis, logAxis, figure, plain, variable } = crossgrain.plot;

  const reference = "native-dem";
  const nameOf = (series) =>
    series.code + (series.replica > 0 ? ", replica " + series.replica : "");
  const replicaOf = (series) => series.replica || 0;

  function line(series, y, extra) {
    const look = crossgrain.codes.look(series.code);
    return {
      type: "scatter",
      mode: "lines",
      name: plain(nameOf(series)),
      legendgroup: series.code,
      x: column(series, "t"),
      y,
      opacity: replicaOf(series) > 0 ? 0.5 : 1,
      line: { color: crossgrain.codes.color(series.code), dash: look.dash, width: look.width },
      hovertemplate:
        "t = %{x:.6g}<br>" + extra.label + " = %{y:.10g}<extra>%{fullData.name}</extra>",
      ...extra.trace,
    };
  }

  function bottom(group) {
    const series = group.find((candidate) => column(candidate, "bottom").length > 0);
    if (!series) return [];
    return [
      {
        type: "scatter",
        mode: "lines",
        meta: "bottom",
        name: "bottom plate",
        yaxis: "y3",
        x: column(series, "t"),
        y: column(series, "bottom"),
        line: { color: variable("--soft"), width: 1.2 },
        hovertemplate: "t = %{x:.6g}<br>bottom plate = %{y:.6g}<extra></extra>",
      },
    ];
  }

  /** Heights can be subtracted only where both were sampled at the same times. */
  function sameTimes(a, b) {
    const ta = column(a, "t");
    const tb = column(b, "t");
    return (
      ta.length === tb.length &&
      ta.every((t, i) => Math.abs(t - tb[i]) <= 1e-9 * Math.max(1, Math.abs(t)))
    );
  }

  function differenceTrace(series, apart) {
    const style = {
      color: crossgrain.codes.color(series.code),
      dash: crossgrain.codes.look(series.code).dash,
    };
    // Zero has no place on a log axis: gaps, counted in the notes.
    const y = apart.map((value) => value || null);
    const trace = {
      meta: "difference",
      yaxis: "y2",
      connectgaps: false,
      line: { ...style, width: 1.6 },
    };
    return line(series, y, { label: "|h − h_native|", trace });
  }

  /** {trace, note} of one foreign series: its curve of |h - h_native|, or why there is none. */
  function difference(series, group) {
    const native = group.find(
      (other) => other.code === reference && replicaOf(other) === replicaOf(series),
    );
    if (!native) return { note: nameOf(series) + ": no " + reference + " run to compare with" };
    if (!sameTimes(series, native))
      return { note: nameOf(series) + ": sampled at other times than " + reference };
    const h = column(native, "h");
    const apart = column(series, "h").map((value, i) =>
      value === null || h[i] === null ? null : Math.abs(value - h[i]),
    );
    const zeros = apart.filter((value) => value === 0).length;
    const share = zeros + " of " + apart.length + " samples are identical to the last bit (gaps)";
    return {
      trace: differenceTrace(series, apart),
      note: zeros > 0 ? nameOf(series) + ": " + share : null,
    };
  }

  function differences(group) {
    const all = group
      .filter((series) => series.code !== reference)
      .map((series) => difference(series, group));
    return {
      traces: all.map(({ trace }) => trace).filter(Boolean),
      notes: all.map(({ note }) => note).filter(Boolean),
    };
  }

  /** From top to bottom: heights, bottom plate (on its own scale), distances from the native run. */
  function build(group) {
    const { traces } = differences(group);
    const plate = bottom(group);
    const unit = "<br>(" + plain(columnUnit(group[0], "h")) + ")";
    const floor = traces.length > 0 ? 0.35 : 0;
    const ceiling = plate.length > 0 ? floor + 0.21 : floor;
    const lowest = traces.length > 0 ? "y2" : plate.length > 0 ? "y3" : "y";
    return {
      data: [
        ...group.map((series) =>
          line(series, column(series, "h"), { label: "h", trace: { meta: "height" } }),
        ),
        ...plate,
        ...traces,
      ],
      layout: {
        xaxis: axis("t (" + plain(columnUnit(group[0], "t")) + ")", {
          anchor: lowest,
          mirror: "all",
        }),
        yaxis: axis("h" + unit, { domain: [ceiling + (ceiling > 0 ? 0.05 : 0), 1] }),
        ...(traces.length > 0
          ? {
              yaxis2: logAxis(
                "|h − h<sub>native</sub>|" + unit,
                traces.flatMap((trace) => trace.y),
                { domain: [0, 0.3] },
              ),
            }
          : {}),
        ...(plate.length > 0
          ? { yaxis3: axis("bottom plate" + unit, { domain: [floor, ceiling], nticks: 5 }) }
          : {}),
        margin: { l: 76, r: 14, t: 10, b: 44 },
      },
    };
  }

  function panels(item, absent) {
    const groups = groupBy(seriesNamed(item, "lid-height"), (series) => series.variant || "");
    return [
      el(
        "div",
        { class: "panels wide" },
        [...groups].map(([variant, group]) =>
          figure({
            name: "lid-height",
            title: item.case + (variant ? ", " + variant : ""),
            height: 560,
            label: "Lid height against time, " + item.case + " " + variant,
            notes: [...absent, ...differences(group).notes].map((note) => note + "."),
            legend: [...new Set(group.map((series) => series.code))].map((code) => ({
              group: code,
              text: code,
              style: { ...crossgrain.codes.look(code), glyph: "" },
            })),
            build: () => build(group),
          }),
        ),
      ),
    ];
  }

  crossgrain.lidHeight = (report) => perCase(report, "lid-height", panels);
})(window.crossgrain);
