// Every observable and cost of every code over the entries of the store: one row per series with its
// latest value, the band of earlier values, a flag when it left the band, and a small chart.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing, table } = crossgrain.dom;
  const { list } = crossgrain.data;
  const { chart, hasBand } = crossgrain.historyChart;
  const format = crossgrain.format;

  const mostRows = 200;

  const states = {
    left_band: { symbol: "▲", word: "left the band" },
    in_band: { symbol: "–", word: "in the band" },
    too_few: { symbol: "…", word: "too few entries" },
  };
  const stateOf = (series) =>
    states[series.status] || { symbol: "!", word: series.status || "not judged" };

  function state(series) {
    const { symbol, word } = stateOf(series);
    const style = "badge h-" + (states[series.status] ? series.status : "unknown");
    return [
      el("span", { class: style }, el("span", { "aria-hidden": "true" }, symbol), " ", word),
      series.reason ? el("span", { class: "reason" }, series.reason) : null,
    ];
  }

  function latest(series) {
    const last = list(series.points).at(-1);
    if (!last) return "no entry";
    const text = format.withError(last.value, last.stderr) + format.unit(series.unit);
    return el(
      "span",
      { title: format.exact(last.value) + " ± " + format.exact(last.stderr ?? 0) },
      text,
    );
  }

  function row(series) {
    const points = list(series.points);
    const where = series.case + (series.variant ? ", " + series.variant : "");
    return [
      [
        el("span", { class: "observable" }, series.observable),
        el("span", { class: "setting" }, where),
      ],
      crossgrain.codes.label(series.code),
      String(points.length),
      latest(series),
      hasBand(series) ? format.range(...series.band).join(" … ") : "–",
      state(series),
      points.length ? chart(series) : missing("No entry."),
    ];
  }

  function sentence(all) {
    const left = all.filter((series) => series.status === "left_band");
    const names = left
      .slice(0, 3)
      .map((series) => series.observable + " of " + series.code + " in " + series.case)
      .join("; ");
    const few = all.filter((series) => series.status === "too_few").length;
    const rest = few ? " " + few + " of " + all.length + " have too few entries to judge." : "";
    if (left.length === 0)
      return el("p", { id: "drift" }, "No series left the band of its earlier values." + rest);
    return el(
      "p",
      { id: "drift", class: "bad" },
      el(
        "strong",
        { class: "alarm" },
        format.plural(left.length, "series", "series") +
          " left the band: " +
          names +
          (left.length > 3 ? "; and " + (left.length - 3) + " more" : "") +
          ".",
      ),
      rest,
    );
  }

  const columns = [
    { title: "observable, case" },
    { title: "code" },
    { title: "n", numeric: true },
    { title: "latest", numeric: true },
    { title: "band of earlier values", numeric: true },
    { title: "state" },
    { title: "value against entry" },
  ];
  const caption =
    "Latest value ± standard error; shaded in the charts: the band of earlier values. " +
    "Series that left it come first.";

  /** The first rows of what fits, and a button for the others: a store may hold thousands. */
  function historyTable(fitting, most) {
    const shown = fitting.slice(0, most);
    const rowAttributes = (i) => ({ "data-status": shown[i].status || "unknown" });
    const rows = shown.map(row);
    const part = table({
      caption,
      columns,
      rows,
      className: "history",
      cards: true,
      rowAttributes,
    });
    if (fitting.length <= most) return [part];
    const more = el(
      "button",
      { type: "button", class: "fold" },
      "show all " + fitting.length + " series",
    );
    more.addEventListener("click", () => {
      part.parentElement.replaceChildren(...historyTable(fitting, fitting.length));
    });
    return [part, more];
  }

  crossgrain.history = (report) => {
    const all = list((report.history || {}).series);
    if (all.length === 0)
      return [missing("No history in this store: it begins with the second entry of a case.")];
    const sorted = [...all].sort((a, b) => (b.status === "left_band") - (a.status === "left_band"));
    const place = el("div", {});
    const show = (fitting) => place.replaceChildren(...historyTable(fitting, mostRows));
    const filter = crossgrain.historyFilter(sorted, show, (status) => stateOf({ status }).word);
    return [sentence(all), filter, place];
  };
})(window.crossgrain);
