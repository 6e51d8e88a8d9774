// What the columns of a series mean when nothing but their names, units and values is known: which
// one is the abscissa, which are errors of others, which axes are best logarithmic.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { list, column, columnUnit } = crossgrain.data;

  const isError = (name) =>
    /^(err|error|stderr|standard_error)$|^err_|_(err|error|stderr)$/.test(name);
  const isBand = (name) => /^(experiment|band)\b/.test(name);
  const isArrows = (series) =>
    ["x", "y", "dx", "dy"].every((name) => list(series.columns).includes(name));

  /** The errors of a column stand in the column behind it. */
  function errorsOf(series, name) {
    const next = list(series.columns)[list(series.columns).indexOf(name) + 1];
    return next !== undefined && isError(next) ? column(series, next) : [];
  }

  /** Rows at which the abscissa falls back, with the first row and the end. */
  function breaks(x) {
    const inner = x.flatMap((value, i) => (i > 0 && value < x[i - 1] ? [i] : []));
    return [0, ...inner, x.length];
  }

  /**
   * A table in long form, whose second column is a key that stays the same while the abscissa runs
   * once: one series per key, named by its `part`. Others come back as they are.
   */
  function parts(series) {
    const [abscissa, key] = list(series.columns);
    const rows = breaks(column(series, abscissa));
    const keys = key === undefined ? [] : column(series, key);
    const segments = rows.slice(1).map((end, i) => keys.slice(rows[i], end));
    const isKey = segments.every(
      (segment) => segment.length > 1 && segment.every((value) => value === segment[0]),
    );
    if (rows.length < 3 || !isKey) return [series];
    const without = (all) => all.filter((_, i) => i !== 1);
    return segments.map((segment, i) => ({
      ...series,
      part: key + " = " + segment[0],
      columns: without(list(series.columns)),
      units: without(list(series.units)),
      values: without(list(series.values)).map((values) => values.slice(rows[i], rows[i + 1])),
    }));
  }

  /** Columns that can be drawn against the first one. */
  const quantities = (series) =>
    list(series.columns)
      .slice(1)
      .filter((name) => !isError(name) && !isBand(name));

  /** What a series is about: the first column with errors, or the first one. */
  function mainQuantity(series) {
    const all = quantities(series);
    return all.find((name) => errorsOf(series, name).length > 0) || all[0];
  }

  /** Columns that share a plot with `name`: the same unit. */
  const companions = (series, name) =>
    quantities(series).filter((other) => columnUnit(series, other) === columnUnit(series, name));

  /** Pairs of columns that bound a band: [[low, high]]. */
  function bands(series) {
    const names = list(series.columns).filter(isBand);
    return names.length === 2 ? [names] : [];
  }

  /** Values that span decades evenly want a log axis, those on an even grid do not. */
  function spansDecades(values, spacing) {
    const used = values.filter((value) => Number.isFinite(value));
    if (used.length < 4 || used.some((value) => value <= 0)) return false;
    const sorted = [...used].sort((a, b) => a - b);
    const highest = sorted[sorted.length - 1];
    const wide = highest / sorted[0] > 100;
    return wide && (!spacing || sorted[Math.floor(sorted.length / 2)] < 0.15 * highest);
  }

  /** "linear" or "log" for both axes: spectra and P(theta) as papers draw them, others by their values. */
  function axisTypes(series, name) {
    const x = column(series, list(series.columns)[0]);
    const y = column(series, name);
    const positive = (values) => values.some((value) => value > 0);
    const power = /spectrum|stagnation/.test(series.name || "") && positive(x) && positive(y);
    return {
      x: power || spansDecades(x, true) ? "log" : "linear",
      y: power || spansDecades(y, false) ? "log" : "linear",
    };
  }

  crossgrain.columns = {
    isArrows,
    parts,
    errorsOf,
    quantities,
    mainQuantity,
    companions,
    bands,
    axisTypes,
  };
})(window.crossgrain);
