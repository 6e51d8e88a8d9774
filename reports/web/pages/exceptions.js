// Everything that is not `agree`, unexpected first, with reasons in full: what a tooltip holds must
// also be on paper. Verdicts on a code with the same outcome and reason share a row.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, table } = crossgrain.dom;
  const { order, isExpected, badge } = crossgrain.outcomes;
  const { allVerdicts, groupBy } = crossgrain.data;

  const mostListed = 4; // questions of a row
  const mostRows = 30;
  const keyOf = (verdict) =>
    [verdict.code, verdict.verdict, isExpected(verdict), verdict.reason].join("\n");

  /** "bed-fluid: spectrum-exponent against lammps (full, layers 1–5)". */
  function question(verdict) {
    const against = verdict.against ? " against " + verdict.against : "";
    return (
      verdict.case +
      ": " +
      verdict.observable +
      against +
      (verdict.setting ? " (" + verdict.setting + ")" : "")
    );
  }

  function questions(group) {
    if (group.length <= mostListed) return group.map((verdict) => el("div", {}, question(verdict)));
    const cases = [...new Set(group.map((verdict) => verdict.case))];
    return group.length + " verdicts in " + cases.join(", ");
  }

  function row(group) {
    const [first] = group;
    const flag = isExpected(first) ? null : [" ", el("span", { class: "flag" }, "unexpected")];
    return [
      first.code,
      [badge(first.verdict, isExpected(first)), flag],
      questions(group),
      first.reason || "no reason recorded",
    ];
  }

  function exceptionsTable(caption, groups) {
    const columns = ["code", "outcome", "question", "reason"].map((title) => ({ title }));
    return table({ caption, columns, rows: groups.map(row), className: "exceptions", cards: true });
  }

  crossgrain.exceptions = (report) => {
    const rest = allVerdicts(report).filter(
      (verdict) => verdict.verdict !== "agree" || !isExpected(verdict),
    );
    if (rest.length === 0) return [];
    const groups = [...groupBy(rest, keyOf).values()].sort(
      ([a], [b]) =>
        isExpected(a) - isExpected(b) || order.indexOf(a.verdict) - order.indexOf(b.verdict),
    );
    const first = groups.filter(([verdict], i) => i < mostRows || !isExpected(verdict));
    const others = groups.slice(first.length);
    const caption = "Everything that is not “agree”, unexpected first";
    return [
      exceptionsTable(caption, first),
      others.length
        ? el(
            "details",
            {},
            el("summary", {}, others.length + " more, all of them expected"),
            exceptionsTable("Expected, continued", others),
          )
        : null,
    ];
  };
})(window.crossgrain);
