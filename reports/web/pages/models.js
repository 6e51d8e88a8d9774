// Models against molecular dynamics: one table per phenomenon, a column per model, code and source, a
// row per quantity that has no units, and the pictures side by side.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing, table, definitions } = crossgrain.dom;
  const { list } = crossgrain.data;
  const format = crossgrain.format;
  const { badge, describe } = crossgrain.outcomes;

  const isValue = (cell) => format.isNumber(cell.value) || Boolean(cell.word);

  function text(cell) {
    if (cell.word) return cell.word;
    const error = cell.stderr > 0 ? " ± " + Number(cell.stderr.toPrecision(1)) : "";
    return Number(cell.value.toPrecision(3)) + error;
  }

  /** Where a value comes from, with all digits, and what its verdict rests on. */
  function details(cell) {
    const pairs = [
      ["value", format.isNumber(cell.value) ? format.exact(cell.value) : cell.word],
      ["standard error", format.isNumber(cell.stderr) ? format.exact(cell.stderr) : ""],
      ["measured", cell.source],
      ["case", [cell.case, cell.variant].filter(Boolean).join(", ")],
      ["verdict", cell.verdict ? describe(cell.verdict).word : ""],
      ["reason", cell.reason],
    ];
    return pairs.filter(([, value]) => value).map(([term, value]) => term + ": " + value);
  }

  function content(cell, row) {
    if (!cell.source) return "";
    if (!isValue(cell))
      return el(
        "span",
        { class: "note", title: cell.reason || null },
        cell.measured_nothing ? "–" : "not run",
      );
    const symbol =
      cell.column === row.against ? "reference" : cell.verdict ? describe(cell.verdict).symbol : "";
    return el(
      "span",
      { title: details(cell).join("\n") },
      text(cell),
      symbol ? el("span", { class: "note" }, " " + symbol) : null,
    );
  }

  function margin(row) {
    if (!format.isNumber(row.margin)) return "";
    return row.relative ? format.exact(100 * row.margin) + " %" : format.exact(row.margin);
  }

  function modelsTable(item, rows) {
    const columns = list(item.columns);
    return table({
      caption: item.title,
      columns: [
        { title: "quantity" },
        ...columns.map((column) => ({ title: column.title })),
        { title: "margin" },
        { title: "verdict" },
      ],
      rows: rows.map((row) => [
        row.quantity,
        ...columns.map((column) =>
          content(list(row.cells).find((cell) => cell.column === column.name) || {}, row),
        ),
        el("span", { title: row.reason || null }, margin(row)),
        badge(row.verdict, row.verdict !== "disagree"),
      ]),
      className: "models",
    });
  }

  /** What the model leaves out, for the rows that differ. */
  function differences(rows) {
    const told = rows.filter((row) => row.verdict === "disagree" && row.left_out);
    if (told.length === 0) return null;
    return [
      el("h4", {}, "Where they differ"),
      definitions(told.map((row) => [row.quantity, row.left_out])),
    ];
  }

  function sideBySide(item, report) {
    const found = list(item.pictures).flatMap((wanted) => {
      const owner = list(report.cases).find((one) => one.case === wanted.case);
      const picture = list((owner || {}).pictures).find(
        (one) =>
          one.code === wanted.code && one.variant === wanted.variant && one.name === wanted.name,
      );
      return picture ? [{ ...picture, variant: wanted.title }] : [];
    });
    return crossgrain.pictures({ pictures: found });
  }

  const conventions = ["velocity_lever", "torque_lever", "rotation", "limit"];
  const words = (name) => name.replaceAll("_", " ");

  /** A mean in percent of both codes' mean, with all digits and its unit in the tooltip. */
  function percent(mean, observable, significant) {
    const scale = Math.abs(observable.a.value + observable.b.value) / 200;
    const exact = [
      format.exact(mean.value) + " ± " + format.exact(mean.stderr),
      observable.unit,
    ].join(" ");
    const text = (mean.value / scale).toFixed(2) + " ± " + (mean.stderr / scale).toFixed(2);
    return el(
      "span",
      { title: exact },
      text.replace("-", "−"),
      significant ? el("strong", {}, " *") : null,
    );
  }

  function attributionRow(pair, observable) {
    const parts = conventions.map((key) => {
      const part = list(observable.contributions).find((one) => one.switch === key);
      return part ? percent(part.average, observable, part.significant) : "";
    });
    return [
      pair.a + ", " + pair.b,
      words(observable.observable),
      percent(observable.difference, observable, observable.significant),
      ...parts,
      list(pair.switches).length > 1 ? percent(observable.interaction, observable, false) : "",
    ];
  }

  /** What each convention of friction makes of the difference between two codes. */
  function attribution(pairs) {
    if (pairs.length === 0) return null;
    return [
      el("h3", {}, "What conventions of friction make of the answer"),
      el(
        "p",
        { class: "note" },
        "The engine " +
          pairs[0].code +
          " with one convention switched at a time: second code's minus " +
          "first code's, in percent of their mean, averaged over the orders of switching. " +
          "* differs from 0 at 95 %; interaction: beyond what each makes alone.",
      ),
      table({
        caption: "attribution of differences to conventions",
        columns: [
          "conventions",
          "observable",
          "difference",
          ...conventions.map(words),
          "interaction",
        ].map((title) => ({ title })),
        rows: pairs.flatMap((pair) =>
          list(pair.observables).map((observable) => attributionRow(pair, observable)),
        ),
        className: "models",
      }),
    ];
  }

  crossgrain.models = (report) => {
    const items = list(report.phenomena);
    const attributed = attribution(list(report.attribution));
    if (items.length === 0 && !attributed)
      return [missing("This report compares no models with molecular dynamics.")];
    const tables = items.map((item) => {
      const rows = list(item.rows).filter((row) =>
        list(row.cells).some((cell) => cell.case && isValue(cell)),
      );
      return [
        el("h3", {}, item.title),
        item.text ? el("p", { class: "note" }, item.text) : null,
        rows.length > 0
          ? [
              modelsTable(item, rows),
              differences(rows),
              crossgrain.modelsFigures(item),
              sideBySide(item, report),
            ]
          : missing(
              "No run of its cases in this store: crossgrain run " + casesOf(item).join(" ") + ".",
            ),
      ];
    });
    return [tables, attributed];
  };

  function casesOf(item) {
    const named = list(item.rows).flatMap((row) => list(row.cells).map((cell) => cell.case));
    return [...new Set(named.filter(Boolean))];
  }
})(window.crossgrain);
