// The verdict matrix: rows are case x observable x setting, columns are codes (against a reference)
// and pairs of codes (against each other). Each cell says the outcome in word, symbol and colour,
// the difference with its uncertainty, and the limit.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing } = crossgrain.dom;
  const { describe, isExpected, badge, details, countByOutcome } = crossgrain.outcomes;
  const { list, allVerdicts, measurementOf } = crossgrain.data;
  const { label, pairLabel } = crossgrain.codes;
  const format = crossgrain.format;

  const mostRows = 12; // of a case before it is folded; what is unexpected always stands

  function codeNames(report) {
    const names = list(report.codes).map((entry) => entry.code);
    for (const item of list(report.cases))
      for (const entry of [...list(item.runs), ...list(item.verdicts)]) names.push(entry.code);
    return [...new Set(names)];
  }

  /** Columns that hold at least one verdict: single codes in their fixed order, then pairs. */
  function columnsOf(verdicts, codes) {
    const rank = (code) => codes.indexOf(code);
    const columns = new Map();
    for (const verdict of verdicts) {
      const pair = codes.includes(verdict.against);
      const key = pair ? verdict.code + "\n" + verdict.against : verdict.code;
      columns.set(key, { key, pair, code: verdict.code, against: pair ? verdict.against : "" });
    }
    return [...columns.values()].sort(
      (a, b) => a.pair - b.pair || rank(a.code) - rank(b.code) || rank(a.against) - rank(b.against),
    );
  }

  /** "published: taguchi-1992": the kind of check once, then what it is against. */
  function referenceOf(verdict) {
    const against = verdict.against || "no reference named";
    return against.startsWith(verdict.kind + ":")
      ? against.replace(":", ": ")
      : verdict.kind + ": " + against;
  }

  /** A pair's verdict joins the row of the same observable and setting; references never share one. */
  function rowsOf(item, codes) {
    const rows = [];
    const verdicts = list(item.verdicts);
    const isPair = (verdict) => codes.includes(verdict.against);
    for (const verdict of [...verdicts.filter((v) => !isPair(v)), ...verdicts.filter(isPair)]) {
      const pair = isPair(verdict);
      const reference = pair ? "" : referenceOf(verdict);
      let row = rows.find(
        (candidate) =>
          candidate.observable === verdict.observable &&
          candidate.setting === (verdict.setting || "") &&
          (pair || candidate.reference === reference),
      );
      if (!row) {
        row = {
          observable: verdict.observable,
          setting: verdict.setting || "",
          reference,
          cells: new Map(),
        };
        rows.push(row);
      }
      const key = pair ? verdict.code + "\n" + verdict.against : verdict.code;
      row.cells.set(key, [...(row.cells.get(key) || []), verdict]);
    }
    return rows;
  }

  function measuredBy(item, verdict) {
    const m = measurementOf(item, verdict);
    if (!m) return [];
    const systematic = m.systematic ? ", systematic " + format.exact(m.systematic) : "";
    return [
      [
        "measured",
        format.exact(m.value) +
          " ± " +
          format.exact(m.stderr) +
          format.unit(m.unit) +
          systematic +
          ", n = " +
          m.n,
      ],
    ];
  }

  function numbers(verdict) {
    if (!format.isNumber(verdict.difference)) return null;
    const bound = format.isNumber(verdict.limit)
      ? [" ", el("span", { class: "limit" }, "/ " + format.limit(verdict.limit))]
      : null;
    const difference = verdict.uncertainty
      ? format.withError(verdict.difference, verdict.uncertainty)
      : format.number(verdict.difference, 2);
    return el("div", { class: "numbers" }, el("span", { class: "difference" }, difference), bound);
  }

  function chip(item, verdict) {
    const expected = isExpected(verdict);
    const flag = !expected
      ? el("span", { class: "flag" }, "unexpected")
      : verdict.verdict === "disagree"
        ? el("span", { class: "flag" }, "expected")
        : null;
    const node = el(
      "div",
      {
        class: "chip c-" + describe(verdict.verdict).name + (expected ? "" : " unexpected"),
        "data-verdict": verdict.verdict || "none",
        "data-expected": String(expected),
      },
      badge(verdict.verdict, expected),
      flag ? [" ", flag] : null,
      numbers(verdict),
    );
    return crossgrain.tooltip.attach(node, () => details(verdict, measuredBy(item, verdict)));
  }

  function tableRow(item, row, columns) {
    const head = el(
      "th",
      { scope: "row", role: "rowheader" },
      el("span", { class: "observable" }, row.observable),
      row.setting ? el("span", { class: "setting" }, row.setting) : null,
      row.reference ? el("span", { class: "reference" }, row.reference) : null,
    );
    const cells = columns.map((column) => {
      const verdicts = row.cells.get(column.key);
      const name = column.pair ? column.code + " : " + column.against : column.code;
      return el(
        "td",
        { role: "cell", "data-label": name, class: verdicts ? null : "empty" },
        verdicts
          ? verdicts.map((verdict) => chip(item, verdict))
          : el("span", { title: "no verdict" }, "·"),
      );
    });
    const quiet = [...row.cells.values()].flat().every(isExpected);
    return el("tr", { role: "row", class: quiet ? "quiet" : null }, head, cells);
  }

  function caseCounts(item) {
    const counts = countByOutcome(list(item.verdicts)).map(([outcome, count]) => {
      const { name, symbol, word } = describe(outcome);
      return el("span", { class: "count t-" + name }, symbol + " " + count + " " + word);
    });
    return el("span", { class: "case-counts" }, counts);
  }

  /** Shows or hides the rows of a long case that hold nothing unexpected. */
  function foldButton(count) {
    const text = (folded) => (folded ? "show all " + format.plural(count, "row") : "fold");
    const button = el(
      "button",
      { type: "button", class: "fold", "aria-expanded": "false" },
      text(true),
    );
    button.addEventListener("click", () => {
      const folded = button.closest("tbody").classList.toggle("folded");
      button.setAttribute("aria-expanded", String(!folded));
      button.textContent = text(folded);
    });
    return button;
  }

  function caseHeading(item, span, rows) {
    const source = item.source ? el("span", { class: "soft" }, " Source: " + item.source) : null;
    const explained = item.text || item.source;
    return el(
      "tr",
      { class: "case", role: "row" },
      el(
        "th",
        { scope: "rowgroup", role: "rowheader", colspan: span },
        el(
          "div",
          { class: "case-head" },
          el("span", { class: "case-name" }, item.case),
          " ",
          item.title ? el("span", { class: "case-title" }, item.title) : null,
          explained
            ? el(
                "details",
                {},
                el("summary", {}, "what and why"),
                el("p", {}, item.text || "", source),
              )
            : null,
          crossgrain.caseLink(item),
          rows > mostRows ? foldButton(rows) : null,
          caseCounts(item),
        ),
      ),
    );
  }

  function caseBody(item, columns, codes) {
    const span = columns.length + 1;
    const rows = rowsOf(item, codes).map((row) => tableRow(item, row, columns));
    if (rows.length === 0) {
      const text = list(item.runs).length
        ? "No verdict on " + item.case + " in this report."
        : "No run of " + item.case + " in this store.";
      const cell = el("td", { role: "cell", colspan: span }, missing(text));
      rows.push(el("tr", { role: "row", class: "no-verdict" }, cell));
    }
    return el(
      "tbody",
      { role: "rowgroup", "data-case": item.case, class: rows.length > mostRows ? "folded" : null },
      caseHeading(item, span, rows.length),
      rows,
    );
  }

  function head(columns) {
    const singles = columns.filter((column) => !column.pair).length;
    const pairs = columns.length - singles;
    return el(
      "thead",
      { role: "rowgroup" },
      el(
        "tr",
        { role: "row", class: "groups" },
        el("td", { role: "cell" }),
        singles
          ? el(
              "th",
              { scope: "colgroup", role: "columnheader", colspan: singles },
              "against a reference",
            )
          : null,
        pairs
          ? el(
              "th",
              { scope: "colgroup", role: "columnheader", colspan: pairs, class: "first-pair" },
              "against each other",
            )
          : null,
      ),
      el(
        "tr",
        { role: "row" },
        el("th", { scope: "col", role: "columnheader" }, "observable, setting, reference"),
        columns.map((column) =>
          el(
            "th",
            { scope: "col", role: "columnheader" },
            column.pair ? pairLabel(column.code, column.against) : label(column.code),
          ),
        ),
      ),
    );
  }

  crossgrain.verdictMatrix = (report) => {
    if (list(report.cases).length === 0) return [missing("No case in this report.")];
    const codes = codeNames(report);
    const columns = columnsOf(allVerdicts(report), codes);
    const table = el(
      "table",
      { id: "matrix", class: "matrix", role: "table", style: "--columns: " + columns.length },
      el(
        "caption",
        {},
        "Difference ± half-width of its 95 % interval / limit. Hover, focus or tap a cell for all digits and reasons.",
      ),
      head(columns),
      list(report.cases).map((item) => caseBody(item, columns, codes)),
    );
    return [
      crossgrain.matrixFilter(report, table),
      el(
        "div",
        { class: "scroll", tabindex: 0, role: "region", "aria-label": "Verdict matrix" },
        table,
      ),
    ];
  };
})(window.crossgrain);
