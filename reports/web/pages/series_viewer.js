// The viewer of a case's series: one plot, and drop-downs for series, variant, quantity and axes.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing, select } = crossgrain.dom;
  const { list, groupBy } = crossgrain.data;
  const { isArrows, parts, quantities, mainQuantity, companions, axisTypes } = crossgrain.columns;
  const { curves, arrows, styleOf, notes } = crossgrain.seriesPlot;

  const everything = "*";
  const mostCurves = 32; // colours times dashes
  const axesNames = {
    "linear linear": "linear",
    "log log": "log-log",
    "linear log": "y log",
    "log linear": "x log",
  };

  const isFit = (name) => name.endsWith("-fit");

  /** What tells the runs behind a group of series apart: code, variant and time step as needed. */
  function labeller(group) {
    const differ = (key) => new Set(group.map((series) => series[key] || "")).size > 1;
    const keys = ["code", "variant", "rung", "part"].filter(differ);
    return (series) =>
      keys
        .map((key) => (key === "rung" ? "time step " + ((series.rung || 0) + 1) : series[key]))
        .filter(Boolean)
        .join(", ") ||
      series.variant ||
      series.code ||
      "run";
  }

  /** Fits that belong to a series: "<name>-fit" of the same run. */
  const fitsOf = (all, series) =>
    all.filter(
      (other) =>
        other.name === series.name + "-fit" &&
        other.code === series.code &&
        (other.variant || "") === (series.variant || "") &&
        (other.rung || 0) === (series.rung || 0),
    );

  /** The curves of a choice: one quantity of all runs, or all quantities of one unit of one run. */
  function chosen(all, group, run, quantity) {
    const label = labeller(group);
    const runs = run === everything ? group.slice(0, mostCurves) : [group[Number(run)]];
    const [unit, single] = quantity.startsWith(everything)
      ? [quantity.slice(1), false]
      : ["", true];
    const entries = runs.flatMap((series) =>
      (single ? [quantity] : companions(series, unit)).map((name) => ({
        series,
        quantity: name,
        label: single ? label(series) : runs.length > 1 ? label(series) + ", " + name : name,
        fits: fitsOf(all, series),
      })),
    );
    return entries.slice(0, mostCurves).map((entry, i) => ({ ...entry, style: styleOf(i) }));
  }

  function runOptions(group) {
    const label = labeller(group);
    const each = group.map((series, i) => ({ value: String(i), text: label(series) }));
    const all = { value: everything, text: "all " + group.length };
    // Fields lie on top of each other, fits are looked at one by one.
    if (group.length < 2 || isArrows(group[0])) return each;
    return /fits$/.test(group[0].name) ? [...each, all] : [all, ...each];
  }

  function quantityOptions(series, run) {
    const main = mainQuantity(series);
    const single = quantities(series).map((name) => ({ value: name, text: name }));
    const together = companions(series, main);
    const names = together.length > 4 ? together.length + " quantities" : together.join(", ");
    const all = { value: everything + main, text: "all: " + names };
    const sorted = [...single].sort((a, b) => (b.value === main) - (a.value === main));
    if (together.length < 2) return sorted;
    return run === everything ? [...sorted, all] : [all, ...sorted];
  }

  function plotOf(item, all, choice) {
    const { group, run, quantity, axes } = choice;
    if (isArrows(group[0])) {
      const series = group[Number(run)];
      return crossgrain.plot.figure({
        name: "series",
        height: 520,
        notes: notes(series),
        label: series.name + " of " + item.case,
        build: () => arrows(series),
      });
    }
    const entries = chosen(all, group, run, quantity);
    if (entries.length === 0) return missing("This series has no column to draw.");
    const [x, y] = axes.split(" ");
    const left = run === everything ? group.length - mostCurves : 0;
    return crossgrain.plot.figure({
      name: "series",
      height: 380,
      label: group[0].name + " of " + item.case,
      notes: [
        left > 0 ? "The first " + mostCurves + " of " + group.length + " runs are drawn." : "",
        ...notes(entries[0].series),
      ].filter(Boolean),
      legend: entries.map((entry) => ({
        group: entry.label,
        text: entry.label,
        style: entry.style,
      })),
      build: () => curves(entries, { x, y }),
    });
  }

  const valueOf = (label) => label.querySelector("select").value;

  function setOptions(label, options, value) {
    const box = label.querySelector("select");
    box.replaceChildren(
      ...options.map((option) => el("option", { value: option.value }, option.text)),
    );
    if (options.some((option) => option.value === value)) box.value = value;
    label.hidden = options.length < 2;
  }

  function viewer(item, all) {
    const groups = groupBy(
      all
        .filter((series) => list(series.columns).length > 1 && !isFit(series.name || ""))
        .flatMap((series) => (isArrows(series) ? [series] : parts(series))),
      (series) => series.name,
    );
    if (groups.size === 0) return missing("No series of " + item.case + " can be drawn.");
    const id = (part) => "series-" + part + "-" + item.case;
    const bySeries = select(
      id("name"),
      "series",
      [...groups.keys()].map((name) => ({ value: name, text: name })),
    );
    const [byRun, byQuantity, byAxes] = ["run", "quantity", "axes"].map((part) =>
      select(id(part), part, []),
    );
    const place = el("div", {});
    const group = () => groups.get(valueOf(bySeries));
    const draw = () => {
      const choice = {
        group: group(),
        run: valueOf(byRun),
        quantity: valueOf(byQuantity),
        axes: valueOf(byAxes),
      };
      place.replaceChildren(plotOf(item, all, choice));
    };
    const chooseAxes = () => {
      const [series] = group();
      const quantity = valueOf(byQuantity).replace(/^\*/, "");
      const types = quantity && !isArrows(series) ? axisTypes(series, quantity) : null;
      const options = types
        ? Object.entries(axesNames).map(([value, text]) => ({ value, text }))
        : [];
      setOptions(byAxes, options, types ? types.x + " " + types.y : "");
      draw();
    };
    const chooseQuantity = () => {
      const [series] = group();
      setOptions(byQuantity, isArrows(series) ? [] : quantityOptions(series, valueOf(byRun)));
      chooseAxes();
    };
    const chooseRun = () => {
      setOptions(byRun, runOptions(group()));
      chooseQuantity();
    };
    bySeries.addEventListener("change", chooseRun);
    byRun.addEventListener("change", chooseQuantity);
    byQuantity.addEventListener("change", chooseAxes);
    byAxes.addEventListener("change", draw);
    chooseRun();
    return [el("div", { class: "filters" }, bySeries, byRun, byQuantity, byAxes), place];
  }

  /** The viewer of a case, or a place that fills itself when the case's file has been read. */
  crossgrain.seriesViewer = (item) => {
    if (!item.series_file) return [];
    const place = el("div", { class: "series-viewer" }, el("p", { class: "soft" }, "Loading …"));
    crossgrain
      .loadSeries(item.series_file)
      .then((all) => place.replaceChildren(...[viewer(item, all)].flat()))
      .catch((error) =>
        place.replaceChildren(missing("The series could not be drawn: " + error.message + ".")),
      );
    return [el("h4", {}, "Series"), place];
  };
})(window.crossgrain);
