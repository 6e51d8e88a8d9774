// Speed against accuracy: the error of one run against its CPU seconds for every rung of a case's
// ladder, the front of what no cheaper rung beats, and under each chart what failed and why.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing, table } = crossgrain.dom;
  const { list, groupBy } = crossgrain.data;
  const { logAxis, figure, plain, variable } = crossgrain.plot;
  const format = crossgrain.format;

  const costOf = (point) => point.cpu_s + point.start_s;
  /** An error that came out as zero has no place on a log axis: it is drawn at the axis' foot. */
  const floorOf = (charted) =>
    0.3 *
    list(charted.points)
      .map((point) => point.error)
      .filter((error) => error > 0)
      .reduce((a, b) => Math.min(a, b), charted.margin);

  function describe(point) {
    return (
      plain(point.variant || point.code) +
      (point.drops ? ", without " + plain(point.drops) : "") +
      "<br>bias " +
      format.withError(point.bias, point.bias_stderr) +
      ", scatter of a run " +
      format.exact(point.scatter) +
      "<br>" +
      format.plural(point.runs, "run", "runs")
    );
  }

  function cloud(charted, code, points) {
    const look = crossgrain.codes.look(code);
    return {
      type: "scatter",
      mode: "markers",
      meta: "chart",
      name: plain(code),
      legendgroup: code,
      x: points.map(costOf),
      y: points.map((point) => point.error || floorOf(charted)),
      customdata: points.map(describe),
      marker: {
        color: crossgrain.codes.color(code),
        symbol: points.map((point) =>
          point.on_front ? look.symbol.replace("-open", "") : look.symbol,
        ),
        size: look.size,
        line: { width: 1.4 },
      },
      hovertemplate:
        "%{customdata}<br>%{x:.3g} CPU s, error %{y:.3g}<extra>%{fullData.name}</extra>",
    };
  }

  /** What a rung is without the numbers of its sweep: rungs of one method make a ladder. */
  const methodOf = (point) =>
    (point.variant || "")
      .split("/")
      .filter((part) => !part.includes("="))
      .join(", ");

  /** Thin lines along the ladders, so that their slopes are seen. */
  function ladders(charted, code, points) {
    const look = crossgrain.codes.color(code);
    return [...groupBy(points, methodOf)]
      .filter(([, rungs]) => rungs.length > 2)
      .map(([method, rungs]) => {
        const sorted = [...rungs].sort((a, b) => costOf(a) - costOf(b));
        return {
          type: "scatter",
          mode: "lines",
          meta: "ladder",
          name: plain(code + " " + method),
          legendgroup: code,
          hoverinfo: "name",
          opacity: 0.45,
          x: sorted.map(costOf),
          y: sorted.map((point) => point.error || floorOf(charted)),
          line: { color: look, width: 1 },
        };
      });
  }

  function front(charted) {
    const points = list(charted.points).filter((point) => point.on_front);
    return {
      type: "scatter",
      mode: "lines",
      meta: "front",
      name: "front",
      legendgroup: "front",
      hoverinfo: "skip",
      x: points.map(costOf),
      y: points.map((point) => point.error || floorOf(charted)),
      line: { color: variable("--text"), width: 1.4, shape: "hv" },
    };
  }

  /** Horizontal lines: the margin, and how well the reference itself is known. */
  function level(value, name, data) {
    const x = data.flatMap((entry) => entry.x);
    return {
      type: "scatter",
      mode: "lines",
      meta: "guide",
      name,
      hoverinfo: "name",
      x: [Math.min(...x), Math.max(...x)],
      y: [value, value],
      line: {
        color: variable("--soft"),
        dash: name === "margin" ? "6px,4px" : "1px,3px",
        width: 1.4,
      },
    };
  }

  function build(charted) {
    const byCode = groupBy(list(charted.points), (point) => point.code);
    const data = [...byCode].flatMap(([code, points]) => [
      ...ladders(charted, code, points),
      cloud(charted, code, points),
    ]);
    data.push(front(charted));
    const guides = [level(charted.margin, "margin", data)];
    if (charted.reference.stderr > 0) {
      guides.push(level(charted.reference.stderr, "standard error of the reference", data));
    }
    const all = [...guides, ...data];
    const unit = charted.unit && charted.unit !== "1" ? " (" + plain(charted.unit) + ")" : "";
    return {
      data: all,
      layout: {
        xaxis: logAxis(
          "CPU seconds of one run",
          all.flatMap((entry) => entry.x),
        ),
        yaxis: logAxis(
          "error of one run" + unit,
          all.flatMap((entry) => entry.y),
        ),
      },
    };
  }

  function frontTable(charted) {
    const points = list(charted.points).filter((point) => point.on_front);
    const columns = [
      { title: "code" },
      { title: "rung" },
      { title: "CPU s", numeric: true },
      { title: "of these to start", numeric: true },
      { title: "error", numeric: true },
      { title: "bias", numeric: true },
      { title: "within the margin" },
    ];
    const rows = points.map((point) => [
      crossgrain.codes.label(point.code),
      point.variant || "–",
      format.number(costOf(point)),
      format.number(point.start_s),
      format.number(point.error),
      format.withError(point.bias, point.bias_stderr),
      point.accurate ? "yes" : "no",
    ]);
    return table({
      caption: "The front, " + charted.observable,
      columns,
      rows,
      className: "compact",
    });
  }

  function chart(item, charted) {
    const title = charted.observable + " against " + charted.against;
    if (list(charted.points).length === 0)
      return [
        el("h3", {}, title),
        missing("No point: " + (charted.problem || "no run in this store") + "."),
      ];
    const codes = [...groupBy(charted.points, (point) => point.code).keys()];
    return [
      figure({
        name: "chart",
        title,
        height: 380,
        label: title + ", " + item.case,
        legend: codes.map((code) => ({
          group: code,
          text: code,
          style: crossgrain.codes.look(code),
        })),
        build: () => build(charted),
      }),
      el(
        "p",
        { class: "note" },
        "Reference " +
          format.withError(charted.reference.value, charted.reference.stderr) +
          "; margin " +
          format.number(charted.margin) +
          ": " +
          charted.reason +
          ". Filled points and the line are the front: no cheaper one has a smaller error.",
      ),
      frontTable(charted),
    ];
  }

  function failures(item) {
    const all = list(item.failures);
    if (all.length === 0) return el("p", { class: "note" }, "Nothing of this ladder failed.");
    const columns = [
      { title: "code" },
      { title: "status" },
      { title: "reason" },
      { title: "rungs" },
    ];
    const rows = all.map((failure) => [
      crossgrain.codes.label(failure.code),
      crossgrain.outcomes.describe(failure.status).word,
      failure.reason,
      failure.variants[0] +
        (failure.variants.length > 1 ? " and " + (failure.variants.length - 1) + " more" : ""),
    ]);
    return table({
      caption: "Not in the charts of " + item.case,
      columns,
      rows,
      className: "compact",
    });
  }

  const stamp = (item) =>
    item.created ? " (" + format.date(item.created) + ", version " + item.version + ")" : "";

  crossgrain.charts = (report) => {
    const all = list(report.charts);
    if (all.length === 0) return [missing("No chart: “crossgrain chart” writes them.")];
    return all.map((item) => [
      el("h2", { id: item.case }, item.case),
      el("p", {}, item.title + stamp(item)),
      list(item.observables).map((charted) => chart(item, charted)),
      failures(item),
    ]);
  };
})(window.crossgrain);
