// Small helpers to build pages. Data only ever becomes text nodes, never markup.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";

  /** An element: attributes (dataset as data-*), then children (nodes, texts, arrays, null). */
  function el(tag, attributes, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes || {})) {
      if (value === null || value === undefined || value === false) continue;
      element.setAttribute(name, value === true ? "" : String(value));
    }
    element.append(
      ...children
        .flat(Infinity)
        .filter((child) => child !== null && child !== undefined && child !== ""),
    );
    return element;
  }

  /** The sentence that stands where a part is missing. */
  function missing(text) {
    return el("p", { class: "missing", role: "note" }, text);
  }

  /**
   * A table. columns: [{title, numeric}]; rows: arrays of cell contents; the first column is the row
   * header. With `cards`, rows become cards on narrow screens; the roles keep it a table for screen
   * readers when the style sheet changes its display. Others scroll sideways.
   */
  function table({ caption, columns, rows, className, rowAttributes, cards }) {
    const head = columns.map((column) =>
      el(
        "th",
        { scope: "col", role: "columnheader", class: column.numeric ? "numeric" : null },
        column.title,
      ),
    );
    const body = rows.map((cells, i) =>
      el(
        "tr",
        { role: "row", ...(rowAttributes ? rowAttributes(i) : {}) },
        cells.map((cell, j) => {
          const attributes = {
            class: columns[j].numeric ? "numeric" : null,
            "data-label": columns[j].title,
          };
          return j === 0
            ? el("th", { ...attributes, scope: "row", role: "rowheader" }, cell)
            : el("td", { ...attributes, role: "cell" }, el("div", {}, cell));
        }),
      ),
    );
    return el(
      "div",
      { class: "scroll", tabindex: 0, role: "region", "aria-label": caption },
      el(
        "table",
        { class: (cards ? "cards " : "") + (className || ""), role: "table" },
        el("caption", {}, el("span", {}, caption)),
        el("thead", { role: "rowgroup" }, el("tr", { role: "row" }, head)),
        el("tbody", { role: "rowgroup" }, body),
      ),
    );
  }

  /** A labelled drop-down; options: [{value, text}]. */
  function select(id, label, options) {
    return el(
      "label",
      { class: "filter", for: id },
      el("span", {}, label),
      el(
        "select",
        { id },
        options.map((option) => el("option", { value: option.value }, option.text)),
      ),
    );
  }

  /** Definition list rows for tooltips, without the empty ones. */
  function definitions(pairs) {
    return el(
      "dl",
      {},
      pairs
        .filter(([, value]) => value !== "" && value !== null && value !== undefined)
        .map(([term, value]) => [el("dt", {}, term), el("dd", {}, value)]),
    );
  }

  crossgrain.dom = { el, missing, table, select, definitions };
})(window.crossgrain);
