// Filters of the history: by case, code, state and text.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, select } = crossgrain.dom;
  const format = crossgrain.format;

  const textOf = (series) =>
    [series.case, series.variant, series.code, series.observable].join(" ").toLowerCase();
  const statusOf = (series) => series.status || "unknown";

  /** The controls above the table; `show` gets the series that fit; `stateWord` names a status. */
  crossgrain.historyFilter = (all, show, stateWord) => {
    const options = (key, any) => [
      { value: "all", text: any },
      ...[...new Set(all.map((series) => series[key]))].map((value) => ({ value, text: value })),
    ];
    const byCase = select("history-case", "case", options("case", "all cases"));
    const byCode = select("history-code", "code", options("code", "all codes"));
    const present = [...new Set(all.map(statusOf))].map((value) => ({
      value,
      text: stateWord(value),
    }));
    const byState = select("history-status", "state", [
      { value: "all", text: "all states" },
      ...present,
    ]);
    const search = el(
      "label",
      { class: "filter", for: "history-text" },
      el("span", {}, "contains"),
      el("input", { id: "history-text", type: "search", placeholder: "observable, variant …" }),
    );
    const status = el("output", { id: "history-shown", "aria-live": "polite" });
    const chosen = (label) => label.querySelector("select").value;
    const fits = (wanted, value) => wanted === "all" || wanted === value;
    const apply = () => {
      const text = search.querySelector("input").value.trim().toLowerCase();
      const fitting = all.filter(
        (series) =>
          fits(chosen(byCase), series.case) &&
          fits(chosen(byCode), series.code) &&
          fits(chosen(byState), statusOf(series)) &&
          textOf(series).includes(text),
      );
      show(fitting);
      status.textContent = fitting.length + " of " + format.plural(all.length, "series", "series");
    };
    for (const control of [byCase, byCode, byState, search])
      control.addEventListener("input", apply);
    apply();
    return el("div", { class: "filters" }, byCase, byCode, byState, search, status);
  };
})(window.crossgrain);
