// Every run behind the report, and above the table what failed, with the tail of its log.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing, table } = crossgrain.dom;
  const { describe } = crossgrain.outcomes;
  const { list } = crossgrain.data;
  const format = crossgrain.format;

  function runsOf(report) {
    return list(report.cases).flatMap((item) =>
      list(item.runs).map((run) => ({ ...run, case: item.case })),
    );
  }

  /** A run that ended well is plain text: green is kept for verdicts. */
  function status(run) {
    if (run.status === "ok") return run.cached ? "ok, cached" : "ok";
    return crossgrain.outcomes.badge(run.status, true);
  }

  function failures(runs) {
    const failed = runs.filter((run) => run.status === "run_failed");
    if (failed.length === 0) return null;
    return el(
      "div",
      { class: "failures" },
      el("h3", {}, format.plural(failed.length, "run") + " failed"),
      failed.map((run) =>
        el(
          "details",
          { open: true, class: "failure" },
          el(
            "summary",
            {},
            describe("run_failed").symbol +
              " " +
              run.case +
              ", " +
              run.code +
              (run.variant ? ", " + run.variant : "") +
              (run.replica !== undefined ? ", replica " + run.replica : "") +
              ": ",
            el("strong", {}, run.reason || "no reason recorded"),
          ),
          run.log_tail
            ? el("pre", { tabindex: 0, "aria-label": "end of the log" }, run.log_tail)
            : el("p", { class: "soft" }, "No log was kept."),
        ),
      ),
    );
  }

  function runsTable(runs) {
    const columns = [
      { title: "case" },
      { title: "code" },
      { title: "version" },
      { title: "variant" },
      { title: "replica", numeric: true },
      { title: "seed", numeric: true },
      { title: "status" },
      { title: "CPU (s)", numeric: true },
      { title: "settings or reason" },
    ];
    const rows = runs.map((run) => [
      run.case,
      crossgrain.codes.label(run.code),
      run.version || "–",
      run.variant || "–",
      String(run.replica ?? "–"),
      String(run.seed ?? "–"),
      status(run),
      format.seconds(run.cpu_s),
      [
        run.reason ? el("span", { class: "reason" }, run.reason) : null,
        el("span", { class: "soft" }, format.settings(run.settings)),
      ],
    ]);
    const rowAttributes = (i) => ({ "data-status": runs[i].status });
    return table({
      caption: format.plural(runs.length, "run"),
      columns,
      rows,
      className: "compact runs",
      rowAttributes,
    });
  }

  /** Some thousand rows that few readers want: built when they are first asked for. */
  function folded(runs) {
    const details = el(
      "details",
      { class: "all-runs" },
      el("summary", {}, "all " + format.plural(runs.length, "run")),
    );
    details.addEventListener("toggle", () => details.append(runsTable(runs)), { once: true });
    return details;
  }

  crossgrain.runs = (report) => {
    const runs = runsOf(report);
    if (runs.length === 0) return [missing("No run in this report.")];
    return [failures(runs), folded(runs)];
  };
})(window.crossgrain);
