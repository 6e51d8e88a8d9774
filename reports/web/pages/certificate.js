// Certificate of equivalence: how far two codes are apart after a number of contact times, as a
// distance and as matching decimal digits, against the limit; for driven beds also the distance of
// the lid heights over the first and the second period.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing, table } = crossgrain.dom;
  const { isExpected, badge } = crossgrain.outcomes;
  const { list } = crossgrain.data;
  const format = crossgrain.format;

  const roundOffDigits = 16; // decimal digits of a double: the full length of the bar of digits

  function keysOf(pairs, name) {
    const keys = new Set(pairs.flatMap((pair) => Object.keys(pair[name] || {})));
    return [...keys].sort((a, b) => Number(a) - Number(b) || a.localeCompare(b));
  }

  /** Distance, limit below it, and the digits as number and bar. */
  function distance(value, limit, digits) {
    if (value === undefined) return el("span", { class: "soft" }, "–");
    const share = format.isNumber(digits)
      ? Math.max(0, Math.min(1, digits / roundOffDigits))
      : null;
    return el(
      "div",
      { class: "distance", title: format.exact(value) },
      el("span", { class: "value" }, value === 0 ? "0 (bit for bit)" : format.number(value, 2)),
      share === null
        ? null
        : el(
            "span",
            { class: "digits" },
            digits.toFixed(1) + " digits",
            el(
              "span",
              { class: "bar", "aria-hidden": "true" },
              el("span", { style: "width:" + 100 * share + "%" }),
            ),
          ),
      format.isNumber(limit)
        ? el("span", { class: "bound" }, "limit " + format.limit(limit))
        : null,
    );
  }

  function row(pair, times, periods) {
    return [
      [
        el("span", { class: "case-name" }, pair.case),
        pair.variant ? el("span", { class: "setting" }, pair.variant) : null,
      ],
      crossgrain.codes.pairLabel(pair.a, pair.b),
      ...times.map((time) =>
        distance((pair.max_dx || {})[time], (pair.limits || {})[time], (pair.digits || {})[time]),
      ),
      ...periods.map((period) =>
        distance((pair.max_dh || {})[period], (pair.limits_dh || {})[period]),
      ),
      [
        badge(pair.verdict, isExpected(pair)),
        isExpected(pair) ? null : [" ", el("span", { class: "flag" }, "unexpected")],
        pair.reason ? el("span", { class: "reason" }, pair.reason) : null,
      ],
    ];
  }

  crossgrain.certificate = (report) => {
    const certificate = report.certificate || {};
    const pairs = list(certificate.pairs);
    if (pairs.length === 0) return [missing("No pair of codes has been certified in this report.")];
    const unit = certificate.length_unit || "reduced length";
    const times = keysOf(pairs, "max_dx");
    const periods = keysOf(pairs, "max_dh");
    const columns = [
      { title: "case" },
      { title: "codes" },
      ...times.map((time) => ({ title: "max |Δx|, " + time + " t_c", numeric: true })),
      ...periods.map((period) => ({ title: "max |Δh|, " + period, numeric: true })),
      { title: "verdict" },
    ];
    const agreed = pairs.filter((pair) => pair.verdict === "agree").length;
    const caption =
      agreed +
      " of " +
      format.plural(pairs.length, "pair") +
      " certified. Largest distance of a grain after a number of contact times t_c, in " +
      unit +
      "; matching decimal digits, full bar: " +
      roundOffDigits +
      ".";
    return [
      table({
        caption,
        columns,
        rows: pairs.map((pair) => row(pair, times, periods)),
        className: "certificate",
        cards: true,
        rowAttributes: (i) => ({
          "data-pair": pairs[i].a + ":" + pairs[i].b,
          "data-verdict": pairs[i].verdict,
        }),
      }),
      ...crossgrain.certificatePlots(pairs, unit),
    ];
  };
})(window.crossgrain);
