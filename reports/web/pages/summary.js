// The head of the report: what was compared, where, with which codes, and how it went in one sentence.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing } = crossgrain.dom;
  const { describe, isExpected, countByOutcome } = crossgrain.outcomes;
  const { list, allVerdicts } = crossgrain.data;
  const format = crossgrain.format;

  function provenance(report) {
    const machine = report.machine || {};
    const parts = [
      "version " + (report.version || "not recorded"),
      el("time", { datetime: report.created }, format.date(report.created)),
      machine.cpu || "machine not recorded",
      machine.cores ? format.plural(machine.cores, "core") : null,
      machine.os,
    ].filter(Boolean);
    return el(
      "p",
      { class: "provenance" },
      parts.map((part, i) => [i > 0 ? " · " : "", part]),
    );
  }

  function nameOf(verdict) {
    return (
      verdict.case +
      ", " +
      verdict.observable +
      ", " +
      verdict.code +
      (verdict.against ? " against " + verdict.against : "") +
      " (" +
      describe(verdict.verdict).word +
      ")"
    );
  }

  function certified(report) {
    return list((report.certificate || {}).pairs).map((pair) => ({
      ...pair,
      observable: "certificate",
      code: pair.a,
      against: pair.b,
    }));
  }

  const countTexts = (verdicts) =>
    countByOutcome(verdicts)
      .reverse()
      .map(([outcome, count]) =>
        el(
          "span",
          { class: "count t-" + describe(outcome).name },
          count + " " + describe(outcome).word,
        ),
      )
      .map((count, i) => [i > 0 ? ", " : "", count]);

  /** "; certificate of 3 pairs: 2 agree, 1 disagree; 1 of 12 runs failed." */
  function ending(report) {
    const pairs = certified(report);
    const runs = list(report.cases).flatMap((item) => list(item.runs));
    const failed = runs.filter((run) => run.status === "run_failed").length;
    return [
      pairs.length
        ? ["; certificate of " + format.plural(pairs.length, "pair") + ": ", countTexts(pairs)]
        : null,
      failed
        ? [
            "; ",
            el(
              "span",
              { class: "count t-run_failed" },
              failed + " of " + format.plural(runs.length, "run") + " failed",
            ),
          ]
        : null,
      ".",
    ];
  }

  /** Unexpected verdicts by name, as many as one sentence can carry. */
  function unexpectedPart(unexpected) {
    const named = unexpected.slice(0, 3).map(nameOf).join("; ");
    const rest = unexpected.length > 3 ? "; and " + (unexpected.length - 3) + " more" : "";
    return el(
      "strong",
      { class: "alarm" },
      format.plural(unexpected.length, "verdict is", "verdicts are") +
        " unexpected: " +
        named +
        rest,
    );
  }

  function sentence(report) {
    const verdicts = allVerdicts(report);
    if (verdicts.length === 0) return missing("No verdict in this report: nothing was compared.");
    const unexpected = [...verdicts, ...certified(report)].filter(
      (verdict) => !isExpected(verdict),
    );
    const reached = verdicts.some((verdict) =>
      ["agree", "disagree", "undecided"].includes(verdict.verdict),
    );
    const quiet = reached ? "Nothing is unexpected" : "Nothing could be compared";
    const total = ". Of " + format.plural(verdicts.length, "verdict") + ": ";
    return el(
      "p",
      { id: "outcome", class: unexpected.length ? "bad" : "quiet" },
      unexpected.length ? [unexpectedPart(unexpected), total] : [quiet, total],
      countTexts(verdicts),
      ending(report),
    );
  }

  function codes(report) {
    const known = list(report.codes);
    if (known.length === 0) return missing("No code is recorded in this report.");
    return el(
      "ul",
      { class: "codes", "aria-label": "Codes" },
      known.map((entry) =>
        el(
          "li",
          { class: entry.status === "ok" ? null : "absent" },
          crossgrain.codes.label(entry.code),
          " ",
          entry.status === "ok"
            ? el("span", { class: "soft" }, entry.version || "version unknown")
            : el(
                "span",
                {},
                describe(entry.status).symbol +
                  " " +
                  describe(entry.status).word +
                  (entry.reason ? " – " + entry.reason : ""),
              ),
          list(entry.expresses).length
            ? el("span", { class: "soft expresses" }, list(entry.expresses).join(", "))
            : null,
        ),
      ),
    );
  }

  crossgrain.summary = (report) => [provenance(report), sentence(report), codes(report)];
})(window.crossgrain);
