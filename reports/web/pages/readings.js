// Which reading of a model's rules reproduces which figure of the paper: rows are the checks of the
// cases that sweep over readings, columns the readings.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing, definitions } = crossgrain.dom;
  const { describe, isExpected, badge, details, countByOutcome } = crossgrain.outcomes;
  const { list, groupBy, measurementOf } = crossgrain.data;
  const format = crossgrain.format;

  /** [{case, verdict, ...}] of the cases whose first key of the sweep is the reading. */
  function judged(report) {
    return list(report.cases)
      .filter((item) => list(item.sweep)[0] === "reading")
      .flatMap((item) =>
        list(item.verdicts)
          .filter((verdict) => verdict.reading)
          .map((verdict) => ({ item, verdict })),
      );
  }

  function valueText(item, verdict) {
    const m = measurementOf(item, verdict);
    if (m) return format.withError(m.value, m.stderr) + format.unit(m.unit);
    if (!format.isNumber(verdict.difference)) return "";
    return "difference " + format.withError(verdict.difference, verdict.uncertainty);
  }

  function measuredRows(item, verdict) {
    const m = measurementOf(item, verdict);
    return m
      ? [
          [
            "measured",
            format.exact(m.value) + " ± " + format.exact(m.stderr) + format.unit(m.unit),
          ],
          ["systematic", m.systematic ? "± " + format.exact(m.systematic) : ""],
          ["n", String(m.n)],
        ]
      : [];
  }

  /** One verdict in full; several as counts, with each in the tooltip. */
  function single({ item, verdict }) {
    const expected = isExpected(verdict);
    const node = el(
      "div",
      { class: "chip c-" + describe(verdict.verdict).name + (expected ? "" : " unexpected") },
      badge(verdict.verdict, expected),
      expected ? null : [" ", el("span", { class: "flag" }, "unexpected")],
      el("div", { class: "numbers" }, valueText(item, verdict)),
    );
    return crossgrain.tooltip.attach(node, () => details(verdict, measuredRows(item, verdict)));
  }

  function several(entries, outcome) {
    const members = entries.filter(({ verdict }) => verdict.verdict === outcome);
    const expected = members.every(({ verdict }) => isExpected(verdict));
    const node = el(
      "div",
      { class: "chip c-" + describe(outcome).name + (expected ? "" : " unexpected") },
      badge(outcome, expected),
      " " + members.length + " of " + entries.length,
    );
    return crossgrain.tooltip.attach(node, () =>
      definitions(
        members.map(({ item, verdict }) => [
          verdict.setting || verdict.reading,
          [valueText(item, verdict), verdict.reason].filter(Boolean).join("; ") || "no number",
        ]),
      ),
    );
  }

  function cell(entries, reading) {
    if (!entries)
      return el("td", { class: "empty", "data-label": reading, title: "not asked" }, "·");
    // What was reproduced comes first.
    const outcomes = countByOutcome(entries.map(({ verdict }) => verdict))
      .map(([outcome]) => outcome)
      .reverse();
    const shown =
      entries.length === 1
        ? single(entries[0])
        : outcomes.map((outcome) => several(entries, outcome));
    return el(
      "td",
      {
        "data-label": reading,
        "data-outcomes": outcomes.map((outcome) => describe(outcome).word).join(", "),
      },
      shown,
    );
  }

  function row(entries, readings) {
    const [{ item, verdict }] = entries;
    const byReading = groupBy(entries, (entry) => entry.verdict.reading);
    return el(
      "tr",
      { "data-case": item.case },
      el(
        "th",
        { scope: "row" },
        el("span", { class: "case-name" }, item.case),
        el("span", { class: "observable" }, verdict.observable),
        item.source ? el("span", { class: "setting" }, item.source) : null,
        el("span", { class: "reference" }, verdict.against),
      ),
      readings.map((reading) => cell(byReading.get(reading), reading)),
    );
  }

  function modelTable(model, entries) {
    const readings = [...new Set(entries.map(({ verdict }) => verdict.reading))];
    const checks = groupBy(entries, ({ item, verdict }) =>
      [item.case, verdict.code, verdict.observable, verdict.kind, verdict.against].join("\n"),
    );
    const caption =
      "Readings of " + model + ": value ± standard error, and what it says about the figure";
    return el(
      "div",
      { class: "scroll", tabindex: 0, role: "region", "aria-label": caption },
      el(
        "table",
        { class: "matrix readings", style: "--columns: " + readings.length },
        el("caption", {}, caption),
        el(
          "thead",
          {},
          el(
            "tr",
            {},
            el("th", { scope: "col" }, "figure, observable, reference"),
            readings.map((reading) => el("th", { scope: "col" }, reading)),
          ),
        ),
        el(
          "tbody",
          {},
          [...checks.values()].map((group) => row(group, readings)),
        ),
      ),
    );
  }

  crossgrain.readings = (report) => {
    const entries = judged(report);
    if (entries.length === 0) return [missing("No case in this report compares readings.")];
    return [...groupBy(entries, ({ item }) => item.model || "the model")].map(([model, members]) =>
      modelTable(model, members),
    );
  };
})(window.crossgrain);
