// The seven outcomes of a verdict: word, symbol and style class. Only `agree` is green.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, definitions } = crossgrain.dom;
  const format = crossgrain.format;

  const outcomes = {
    agree: { word: "agree", symbol: "✓" },
    disagree: { word: "disagree", symbol: "✗" },
    undecided: { word: "undecided", symbol: "?" },
    not_expressible: { word: "not expressible", symbol: "⊘" },
    not_installed: { word: "not installed", symbol: "–" },
    run_failed: { word: "run failed", symbol: "!" },
    no_reference: { word: "no reference", symbol: "∅" },
  };
  const order = [
    "disagree",
    "run_failed",
    "undecided",
    "no_reference",
    "not_expressible",
    "not_installed",
    "agree",
  ];

  /** A word the pages do not know is shown as it is and styled like a failure, never as `agree`. */
  function describe(outcome) {
    return outcomes[outcome]
      ? { ...outcomes[outcome], name: outcome }
      : { word: outcome || "no verdict", symbol: "!", name: "run_failed" };
  }

  /** The writer says what is expected; where it does not, only `agree` goes without saying. */
  function isExpected(verdict) {
    if (typeof verdict.expected === "boolean") return verdict.expected;
    return ["agree", "not_installed", "not_expressible"].includes(verdict.verdict);
  }

  function badge(outcome, expected) {
    const { word, symbol, name } = describe(outcome);
    return el(
      "span",
      { class: "badge v-" + name + (expected ? "" : " unexpected") },
      el("span", { class: "symbol", "aria-hidden": "true" }, symbol),
      " ",
      word,
    );
  }

  function units(verdict, value) {
    return format.isNumber(value)
      ? format.exact(value) + format.unit(verdict.unit)
      : value === null
        ? "not finite"
        : "";
  }

  /** Everything the document says about a verdict, with all digits. */
  function details(verdict, measured) {
    return definitions([
      [
        "verdict",
        describe(verdict.verdict).word + (isExpected(verdict) ? " (as expected)" : " (UNEXPECTED)"),
      ],
      ["check", verdict.kind + ": " + verdict.code + " against " + verdict.against],
      ["setting", verdict.setting],
      ["difference", units(verdict, verdict.difference)],
      ["± (95 %)", units(verdict, verdict.uncertainty)],
      ["limit", units(verdict, verdict.limit)],
      ["why this limit", verdict.limit_reason],
      ["reason", verdict.reason],
      ...(measured || []),
    ]);
  }

  function countByOutcome(verdicts) {
    const counts = new Map();
    for (const verdict of verdicts) {
      const name = verdict.verdict || "no verdict";
      counts.set(name, (counts.get(name) || 0) + 1);
    }
    return [...counts].sort(([a], [b]) => order.indexOf(a) - order.indexOf(b));
  }

  crossgrain.outcomes = { order, describe, isExpected, badge, details, countByOutcome };
})(window.crossgrain);
