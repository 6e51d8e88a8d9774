// Reading the report document: what is absent is an empty list, and every absence has a sentence.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { missing } = crossgrain.dom;
  const { describe } = crossgrain.outcomes;

  const list = (value) => (Array.isArray(value) ? value : []);

  function column(series, name) {
    const i = list(series.columns).indexOf(name);
    return i < 0 ? [] : list(list(series.values)[i]);
  }

  /** "t (reduced units)": the unit of a column, as far as the document has it. */
  function columnUnit(series, name) {
    const i = list(series.columns).indexOf(name);
    const unit = list(series.units)[i];
    return unit === undefined || unit === "" ? "reduced units" : unit;
  }

  function seriesNamed(item, name) {
    return list(item.series).filter((series) => series.name === name);
  }

  function allVerdicts(report) {
    return list(report.cases).flatMap((item) =>
      list(item.verdicts).map((verdict) => ({ ...verdict, case: item.case })),
    );
  }

  /** The measurement behind a verdict, when the document leaves no doubt which one it is. */
  function measurementOf(item, verdict) {
    const found = list(item.measurements).filter(
      (m) => m.code === verdict.code && m.observable === verdict.observable,
    );
    const same = found.filter((m) => (m.variant || "") === (verdict.setting || ""));
    if (same.length === 1) return same[0];
    return found.length === 1 ? found[0] : null;
  }

  /** Why codes that were asked to run this case are not in a figure: "yade: not installed (...)". */
  function absences(item, name) {
    const present = new Set(
      seriesNamed(item, name).map((series) => series.code + "\n" + (series.variant || "")),
    );
    const notes = new Set();
    for (const run of list(item.runs)) {
      if (present.has(run.code + "\n" + (run.variant || ""))) continue;
      const who = run.code + (run.variant ? " (" + run.variant + ")" : "");
      const why =
        run.status === "ok"
          ? "ran, left no " + name
          : describe(run.status).word + (run.reason ? " – " + run.reason : "");
      notes.add(who + ": " + why);
    }
    return [...notes];
  }

  /**
   * One block per case that has, or is meant to have, a series of this name. `build` returns nodes;
   * where a case has none, or no case has any, a sentence stands in its place.
   */
  function perCase(report, name, build) {
    const cases = list(report.cases).filter(
      (item) => seriesNamed(item, name).length > 0 || list(item.figures).includes(name),
    );
    if (cases.length === 0) return [missing("No case in this report has a “" + name + "” series.")];
    return cases.flatMap((item) => {
      const notes = absences(item, name);
      if (seriesNamed(item, name).length > 0) return build(item, notes);
      if (list(item.runs).length === 0)
        return [missing("No run of " + item.case + " in this store.")];
      return [missing("No “" + name + "” series of " + item.case + ": " + notes.join("; ") + ".")];
    });
  }

  function groupBy(items, keyOf) {
    const groups = new Map();
    for (const item of items) {
      const key = keyOf(item);
      if (!groups.has(key)) groups.set(key, []);
      groups.get(key).push(item);
    }
    return groups;
  }

  crossgrain.data = {
    list,
    column,
    columnUnit,
    seriesNamed,
    allVerdicts,
    measurementOf,
    absences,
    perCase,
    groupBy,
  };
})(window.crossgrain);
