// The states a run can be found in: each has one colour in every map and table. The word always
// stands beside the colour; green is kept for verdicts.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el } = crossgrain.dom;

  const known = [
    "ok",
    "inaccurate",
    "energy gain",
    "blow-up",
    "not finished",
    "steady",
    "ageing",
    "absorbing",
    "saturated",
    "clogged",
    "no steady state",
    "structureless",
    "bands",
    "patches",
    "asymmetric",
    "no meaning",
  ];
  const spare = 4;
  const strangers = [];

  /** The style class of a state; words the pages do not know get one of the spare colours. */
  function styleClass(label) {
    if (known.includes(label)) return "s-" + label.replace(/ /g, "-");
    if (!strangers.includes(label)) strangers.push(label);
    return "s-other-" + (1 + (strangers.indexOf(label) % spare));
  }

  /** The colour of a state in a figure. */
  const color = (label) =>
    crossgrain.plot.variable("--" + styleClass(label).replace(/^s-/, "state-")) ||
    crossgrain.plot.variable("--state-ok");

  const state = (label) => el("span", { class: "state " + styleClass(label) }, label || "no word");

  /** Colours and words of the states that occur, with how often each does. */
  function legend(labels) {
    const counts = new Map();
    for (const label of labels) counts.set(label, (counts.get(label) || 0) + 1);
    const rank = (label) => (known.includes(label) ? known.indexOf(label) : known.length);
    const sorted = [...counts].sort(([a], [b]) => rank(a) - rank(b));
    return el(
      "ul",
      { class: "legend states", "aria-label": "States" },
      sorted.map(([label, count]) => el("li", {}, state(label), " " + count)),
    );
  }

  crossgrain.states = { state, styleClass, color, legend };
})(window.crossgrain);
