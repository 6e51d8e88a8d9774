// The foot of the report: the command that made it.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing } = crossgrain.dom;
  const { list } = crossgrain.data;

  crossgrain.reproduce = (report) => {
    if (!report.command) return [missing("The command that made this report is not recorded.")];
    const versions = list(report.codes)
      .filter((entry) => entry.status === "ok")
      .map((entry) => entry.code + " " + (entry.version || "(version unknown)"));
    return [
      el("p", {}, "This report was made by"),
      el("pre", { class: "command" }, el("code", {}, report.command)),
      el(
        "p",
        { class: "soft" },
        "crossgrain " +
          (report.version || "(version not recorded)") +
          (versions.length ? " with " + versions.join(", ") : "") +
          ". The same seeds give the same bits on the same build; add --fresh to run again what is stored.",
      ),
    ];
  };
})(window.crossgrain);
