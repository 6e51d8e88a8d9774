// What each code costs: CPU seconds, wall seconds and work per CPU second, as bars and as a table.
// Sums over the runs of a case; only runs that finished count.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing, table } = crossgrain.dom;
  const { list, groupBy } = crossgrain.data;
  const { axis, logAxis, figure, plain, variable } = crossgrain.plot;
  const format = crossgrain.format;

  const total = (runs, key) =>
    runs.reduce((sum, run) => sum + (format.isNumber(run[key]) ? run[key] : 0), 0);

  const mostVariants = 4; // with more, a case has one entry for all of them

  /** One entry per case, variant, code and unit of work. */
  function costs(report) {
    return list(report.cases).flatMap((item) => {
      const done = list(item.runs).filter(
        (run) => run.status === "ok" && format.isNumber(run.cpu_s),
      );
      const variants = new Set(done.map((run) => run.variant || "")).size;
      const variantOf = (run) =>
        variants > mostVariants ? format.plural(variants, "variant") : run.variant || "";
      const groups = groupBy(done, (run) =>
        [run.code, variantOf(run), run.work_unit || ""].join("\n"),
      );
      return [...groups.values()].map((runs) => {
        const cpu = total(runs, "cpu_s");
        const work = total(runs, "work");
        return {
          case: item.case,
          code: runs[0].code,
          label: item.case + (variants > 1 && variantOf(runs[0]) ? ", " + variantOf(runs[0]) : ""),
          runs: runs.length,
          cpu,
          wall: total(runs, "wall_s"),
          work,
          unit: runs[0].work_unit || "work",
          rate: cpu > 0 && work > 0 ? work / cpu : null,
          cached: runs.filter((run) => run.cached).length,
        };
      });
    });
  }

  const rowName = (entry) => plain(entry.label);

  function bars(entries, key, unit) {
    return [...groupBy(entries, (entry) => entry.code)].map(([code, members]) => ({
      type: "bar",
      orientation: "h",
      meta: "cost",
      name: plain(code),
      legendgroup: code,
      y: members.map(rowName),
      x: members.map((entry) => entry[key]),
      text: members.map((entry) => format.number(entry[key], 2)),
      textposition: "outside",
      textangle: 0,
      textfont: { size: 10.5 },
      cliponaxis: false,
      marker: { color: crossgrain.codes.color(code) },
      customdata: members.map((entry) => format.exact(entry[key])),
      hovertemplate: "%{y}<br>%{customdata} " + plain(unit) + "<extra>%{fullData.name}</extra>",
    }));
  }

  function panel(entries, key, title, unit) {
    const usable = entries.filter((entry) => entry[key] > 0);
    const rows = new Set(usable.map(rowName)).size;
    const codes = new Set(usable.map((entry) => entry.code)).size;
    return figure({
      name: "cost",
      title,
      height: 64 + rows * (12 + 16 * codes),
      label: title,
      legend: [...new Set(usable.map((entry) => entry.code))].map((code) => ({
        group: code,
        text: code,
        style: { variable: crossgrain.codes.look(code).variable, width: 10 },
      })),
      build: () => ({
        data: bars(usable, key, unit),
        layout: {
          barmode: "group",
          bargap: 0.25,
          bargroupgap: 0.08,
          xaxis: logAxis(
            plain(unit),
            usable.map((entry) => entry[key]),
            { range: barRange(usable.map((entry) => entry[key])) },
          ),
          yaxis: axis("", {
            autorange: "reversed",
            ticks: "",
            gridcolor: variable("--plot-background"),
          }),
        },
      }),
    });
  }

  /** Bars on a log axis start at a power of ten below the smallest value: lengths compare ratios. */
  function barRange(values) {
    const low = Math.floor(Math.log10(Math.min(...values))) - 1;
    const high = Math.log10(Math.max(...values));
    return [low, high + 0.3 * (high - low)]; // room for the numbers behind the bars
  }

  function costTable(entries) {
    const columns = [
      { title: "case" },
      { title: "code" },
      { title: "runs", numeric: true },
      { title: "CPU (s)", numeric: true },
      { title: "wall (s)", numeric: true },
      { title: "work", numeric: true },
      { title: "work per CPU second", numeric: true },
    ];
    const rows = entries.map((entry) => [
      entry.label,
      crossgrain.codes.label(entry.code),
      entry.runs + (entry.cached ? " (" + entry.cached + " cached)" : ""),
      format.seconds(entry.cpu),
      format.seconds(entry.wall),
      entry.work > 0 ? format.number(entry.work) + " " + entry.unit : "–",
      entry.rate ? format.number(entry.rate) + " " + entry.unit + "/s" : "–",
    ]);
    return table({
      caption: "Cost of finished runs; cached runs show what they cost when they ran.",
      columns,
      rows,
      className: "compact",
    });
  }

  crossgrain.cost = (report) => {
    const entries = costs(report);
    if (entries.length === 0)
      return [missing("No finished run with a recorded cost in this report.")];
    const units = [
      ...groupBy(
        entries.filter((entry) => entry.rate),
        (entry) => entry.unit,
      ),
    ];
    return [
      el(
        "div",
        { class: "panels three" },
        panel(entries, "cpu", "CPU time", "CPU seconds"),
        panel(entries, "wall", "wall time", "wall seconds"),
        units.map(([unit, members]) =>
          panel(members, "rate", unit + " per CPU second", unit + " / CPU second"),
        ),
      ),
      costTable(entries),
    ];
  };
})(window.crossgrain);
