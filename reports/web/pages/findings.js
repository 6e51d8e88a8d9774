// What the runs of a case were found to be: a table variant x finding, and for a sweep over two
// numbers a map of the states for each of its other keys.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, table } = crossgrain.dom;
  const { list, groupBy } = crossgrain.data;
  const { state, styleClass, legend } = crossgrain.states;
  const format = crossgrain.format;

  const subject = (finding) => [finding.code, finding.variant || "", finding.rung || 0].join("\n");

  /** Replicas mostly agree; where they do not, every word stands with its share. */
  function words(findings) {
    const groups = [...groupBy(findings, (finding) => finding.label)];
    return groups.map(([label, members], i) => {
      const share = groups.length > 1 ? " " + members.length + " of " + findings.length : null;
      const details = [...new Set(members.map((finding) => finding.detail).filter(Boolean))];
      const node = el("span", { "data-state": label }, state(label), share);
      if (details.length) crossgrain.tooltip.attach(node, () => el("div", {}, details.join("; ")));
      return [i > 0 ? " " : "", node];
    });
  }

  function findingsTable(item) {
    const all = list(item.findings);
    const names = [...new Set(all.map((finding) => finding.name))];
    const several = new Set(all.map((finding) => finding.code)).size > 1;
    const rows = [...groupBy(all, subject).values()].map((group) => [
      [
        group[0].variant || "(the case)",
        several ? el("span", { class: "setting" }, group[0].code) : null,
        group[0].rung ? el("span", { class: "setting" }, "time step " + (group[0].rung + 1)) : null,
      ],
      ...names.map((name) => {
        const found = group.filter((finding) => finding.name === name);
        return found.length ? words(found) : "–";
      }),
    ]);
    return table({
      caption:
        "What the runs of " + item.case + " were found to be; hover or tap a word for the reason",
      columns: ["variant", ...names].map((title) => ({ title })),
      rows,
      className: "compact findings",
      cards: true,
    });
  }

  const isNumeric = (text) => text !== "" && format.isNumber(Number(text));

  /**
   * Keys of the sweep that change: two numbers span the map; where there is one, a name takes the
   * other side; the rest tells the maps apart. Without a number there is no map.
   */
  function keysOf(item) {
    const values = (key) =>
      list(item.variants).map((variant) => String((variant.parameters || {})[key] ?? ""));
    const changing = list(item.sweep).filter((key) => new Set(values(key)).size > 1);
    const numeric = changing.filter((key) => values(key).every(isNumeric));
    const named = changing.filter((key) => !numeric.includes(key));
    if (numeric.length === 2) return { across: numeric[0], up: numeric[1], others: named };
    if (numeric.length === 1) return { across: numeric[0], up: named[0], others: named.slice(1) };
    return null;
  }

  function cell(findings, key) {
    if (!findings) return el("td", { class: "empty", title: "no run" }, "·");
    const labels = [...new Set(findings.map((finding) => finding.label))];
    const common = labels.length === 1;
    const node = el(
      "td",
      {
        class: common ? "state " + styleClass(labels[0]) : "state mixed",
        "data-state": labels.join(" / "),
      },
      labels.join(" / "),
    );
    return crossgrain.tooltip.attach(node, () =>
      el("div", {}, [
        el("strong", {}, key),
        findings.map((finding) =>
          el("div", {}, finding.label + (finding.detail ? ": " + finding.detail : "")),
        ),
      ]),
    );
  }

  /** Numbers in their order, names as the case lists them. */
  function valuesOf(points, key) {
    const found = [...new Set(points.map((point) => String(point.parameters[key] ?? "")))];
    return found.every(isNumeric) ? found.sort((a, b) => Number(a) - Number(b)) : found;
  }

  function mapRow(y, columns, points, { across, up }) {
    const at = (x) =>
      points.find(
        ({ parameters }) =>
          String(parameters[across]) === x && (!up || String(parameters[up] ?? "") === y),
      );
    const place = (x) => across + " = " + x + (up ? ", " + up + " = " + y : "");
    return el(
      "tr",
      {},
      el("th", { scope: "row", class: isNumeric(y) ? "numeric" : null }, y),
      columns.map((x) => cell((at(x) || {}).findings, place(x))),
    );
  }

  /** One map: columns are the values of `across`, rows those of `up`, numbers upwards. */
  function map(title, keys, points) {
    const { across, up } = keys;
    const columns = valuesOf(points, across);
    const sides = up ? valuesOf(points, up) : [""];
    const rows = sides.every(isNumeric) ? sides.reverse() : sides;
    const corner = (up ? up + (isNumeric(rows[0]) ? " ↑  " : " ↓  ") : "") + across + " →";
    return el(
      "div",
      { class: "scroll", tabindex: 0, role: "region", "aria-label": title },
      el(
        "table",
        { class: "state-map" },
        el("caption", {}, el("span", {}, title)),
        el(
          "thead",
          {},
          el(
            "tr",
            {},
            el("th", { scope: "col" }, corner),
            columns.map((x) => el("th", { scope: "col", class: "numeric" }, x)),
          ),
        ),
        el(
          "tbody",
          {},
          rows.map((y) => mapRow(y, columns, points, keys)),
        ),
      ),
    );
  }

  /** Maps of the finding "state", one per code and per value of the other keys. */
  function maps(item) {
    const keys = keysOf(item);
    const states = list(item.findings).filter((finding) => finding.name === "state");
    if (!keys || states.length === 0) return [];
    const codes = [...new Set(states.map((finding) => finding.code))];
    const bySubject = groupBy(states, (finding) => finding.code + "\n" + (finding.variant || ""));
    return codes.flatMap((code) => {
      const points = list(item.variants).map((variant) => ({
        parameters: variant.parameters || {},
        findings: bySubject.get(code + "\n" + variant.name),
      }));
      const groups = groupBy(points, ({ parameters }) =>
        keys.others.map((key) => parameters[key]).join(", "),
      );
      return [...groups].map(([others, members]) => {
        const title = [others, codes.length > 1 ? code : ""].filter(Boolean).join(", ");
        return map(title || item.case, keys, members);
      });
    });
  }

  crossgrain.findings = (item) => {
    const all = list(item.findings);
    if (all.length === 0) return [];
    const states = all.filter((finding) => finding.name === "state");
    const drawn = maps(item);
    return [
      el("h4", {}, drawn.length ? "Failure map" : "Findings"),
      states.length ? legend(states.map((finding) => finding.label)) : null,
      drawn.length ? el("div", { class: "state-maps" }, drawn) : null,
      drawn.length
        ? el("details", {}, el("summary", {}, "as a table"), findingsTable(item))
        : findingsTable(item),
    ];
  };
})(window.crossgrain);
