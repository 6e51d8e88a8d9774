// How each code looks in every figure and table: one colour, one dash, one symbol, never changed.
// Colours come from style.css (--code-...), which has a light and a dark value for each.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el } = crossgrain.dom;

  // Widths and sizes shrink from the first code to the last, so that curves and points that lie on
  // top of each other remain visible as nested stripes and symbols.
  const known = {
    "native-dem": { dash: "solid", symbol: "circle-open", width: 5, size: 11, glyph: "○" },
    lammps: { dash: "solid", symbol: "square-open", width: 2.6, size: 8, glyph: "□" },
    liggghts: { dash: "6px,5px", symbol: "diamond-open", width: 2, size: 7, glyph: "◇" },
    yade: { dash: "2px,4px", symbol: "triangle-up-open", width: 2, size: 5, glyph: "△" },
    "native-lga": { dash: "8px,3px,2px,3px", symbol: "cross-open", width: 2, size: 7, glyph: "✚" },
    "native-hopper": { dash: "12px,4px", symbol: "x-open", width: 2, size: 7, glyph: "✖" },
  };
  const others = ["other-1", "other-2", "other-3"];
  const strangers = [];

  /** {variable, dash, symbol, width, size, glyph}; codes brought by the user get the spare colours. */
  function look(code) {
    if (known[code]) return { ...known[code], variable: "--code-" + code };
    if (!strangers.includes(code)) strangers.push(code);
    const name = others[strangers.indexOf(code) % others.length];
    return {
      dash: "4px,2px",
      symbol: "star-open",
      width: 2,
      size: 7,
      glyph: "☆",
      variable: "--code-" + name,
    };
  }

  function color(code) {
    return getComputedStyle(document.documentElement).getPropertyValue(look(code).variable).trim();
  }

  /** Symbol in the colour of the code, then its name: the key to all figures. */
  function label(code) {
    const swatch = el(
      "span",
      { class: "swatch", "aria-hidden": "true", style: "color: var(" + look(code).variable + ")" },
      look(code).glyph,
    );
    return el("span", { class: "code" }, swatch, code);
  }

  function pairLabel(a, b) {
    return el(
      "span",
      { class: "pair" },
      label(a),
      el("span", { class: "versus" }, " : "),
      label(b),
    );
  }

  crossgrain.codes = { look, color, label, pairLabel };
})(window.crossgrain);
