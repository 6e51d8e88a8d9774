// Filters of the verdict matrix: by case and by outcome.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, select } = crossgrain.dom;
  const { order, describe } = crossgrain.outcomes;
  const { list, allVerdicts } = crossgrain.data;
  const format = crossgrain.format;

  function matches(chipNode, wanted) {
    if (wanted === "all") return true;
    if (wanted === "unexpected") return chipNode.dataset.expected === "false";
    if (wanted === "not-agree") return chipNode.dataset.verdict !== "agree";
    return chipNode.dataset.verdict === wanted;
  }

  /** Hides rows without a matching verdict and fades the other cells of the rows that stay. */
  function applyFilter(table, caseName, outcome, status) {
    let shown = 0;
    let total = 0;
    // Who filters wants to see every match, also in folded cases.
    table.classList.toggle("filtered", caseName !== "all" || outcome !== "all");
    for (const body of table.tBodies) {
      const inCase = caseName === "all" || body.dataset.case === caseName;
      let any = false;
      for (const row of [...body.rows].slice(1)) {
        let hit = outcome === "all" && row.classList.contains("no-verdict");
        for (const node of row.querySelectorAll(".chip")) {
          const match = inCase && matches(node, outcome);
          node.classList.toggle("faded", !match);
          shown += match;
          total += 1;
          hit = hit || match;
        }
        row.hidden = !hit;
        any = any || hit;
      }
      body.hidden = !inCase || !any;
    }
    status.textContent =
      shown === total
        ? format.plural(total, "verdict")
        : shown + " of " + format.plural(total, "verdict");
  }

  /** The drop-downs above the matrix `table`. */
  crossgrain.matrixFilter = (report, table) => {
    const present = order.filter((outcome) =>
      allVerdicts(report).some((verdict) => verdict.verdict === outcome),
    );
    const byCase = select("filter-case", "case", [
      { value: "all", text: "all cases" },
      ...list(report.cases).map((item) => ({ value: item.case, text: item.case })),
    ]);
    const byOutcome = select("filter-outcome", "outcome", [
      { value: "all", text: "all outcomes" },
      { value: "unexpected", text: "unexpected only" },
      { value: "not-agree", text: "all but agree" },
      ...present.map((outcome) => ({ value: outcome, text: describe(outcome).word })),
    ]);
    const status = el("output", { id: "filter-status", "aria-live": "polite" });
    const apply = () =>
      applyFilter(
        table,
        byCase.querySelector("select").value,
        byOutcome.querySelector("select").value,
        status,
      );
    byCase.addEventListener("change", apply);
    byOutcome.addEventListener("change", apply);
    apply();
    return el("div", { class: "filters" }, byCase, byOutcome, status);
  };
})(window.crossgrain);
