// Legends above the plots: they wrap on narrow screens, and each entry switches its curves off and
// on, to look below curves that lie on top of each other.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el } = crossgrain.dom;

  const svg = (tag, attributes) => {
    const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    return element;
  };

  /** A piece of the curve: {variable, width, dash, glyph} of the style, what is not given is left out. */
  function sample({ variable, width, dash, glyph }) {
    const picture = svg("svg", {
      width: 26,
      height: 12,
      viewBox: "0 0 26 12",
      overflow: "visible",
      "aria-hidden": "true",
    });
    if (width) {
      const pattern = dash && dash !== "solid" ? dash.replace(/px/g, "") : "none";
      picture.append(
        svg("line", {
          x1: 0,
          x2: 26,
          y1: 6,
          y2: 6,
          style: "stroke: var(" + variable + ")",
          "stroke-width": width,
          "stroke-dasharray": pattern,
        }),
      );
    }
    if (glyph) {
      const text = svg("text", {
        x: 13,
        y: 10.5,
        "text-anchor": "middle",
        "font-size": 13,
        "font-weight": 700,
        style: "fill: var(" + variable + ")",
      });
      text.append(glyph);
      picture.append(text);
    }
    return picture;
  }

  /** entries: [{group, text, style}]; toggle(group) switches and says whether it is now visible. */
  crossgrain.legend = (entries, toggle) =>
    el(
      "ul",
      { class: "legend" },
      entries.map(({ group, text, style }) => {
        const button = el(
          "button",
          { type: "button", "aria-pressed": "true", title: "show or hide" },
          sample(style),
          " " + text,
        );
        button.addEventListener("click", () =>
          button.setAttribute("aria-pressed", String(toggle(group))),
        );
        return el("li", {}, button);
      }),
    );
})(window.crossgrain);
