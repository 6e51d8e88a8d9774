// Numbers and times as a reader of a paper expects them. Rounding is for display only: every
// rounded number on the pages has its exact value in the tooltip.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";

  const superscripts = {
    "-": "⁻",
    0: "⁰",
    1: "¹",
    2: "²",
    3: "³",
    4: "⁴",
    5: "⁵",
    6: "⁶",
    7: "⁷",
    8: "⁸",
    9: "⁹",
  };

  const isNumber = (value) => typeof value === "number" && Number.isFinite(value);
  const exponentOf = (value) => (value === 0 ? 0 : Math.floor(Math.log10(Math.abs(value)) + 1e-12));
  const minus = (text) => text.replace("-", "−");
  const power = (exponent) => "×10" + [...String(exponent)].map((c) => superscripts[c]).join("");

  // Plain decimals where they are shorter and still comparable at a glance.
  const isPlain = (exponent) => exponent >= -2 && exponent <= 3;

  /** A number with `digits` significant digits, e.g. "0.800", "2.1×10⁻⁴"; "0" is exact. */
  function number(value, digits = 3) {
    if (!isNumber(value)) return "not finite";
    if (value === 0) return "0";
    const [mantissa, exponentText] = value.toExponential(digits - 1).split("e");
    const exponent = Number(exponentText);
    if (isPlain(exponent)) return minus(value.toFixed(Math.max(0, digits - 1 - exponent)));
    return minus(mantissa) + power(exponent);
  }

  /** A limit or a margin: as few digits as say it exactly, at most three. */
  function limit(value) {
    if (!isNumber(value)) return "not finite";
    const rounded = Number(value.toPrecision(3));
    const [mantissa, exponent] = rounded.toExponential().split("e");
    if (isPlain(Number(exponent))) return minus(String(rounded));
    const factor = power(Number(exponent));
    return mantissa === "1" ? factor.slice(1) : minus(mantissa) + factor;
  }

  /** Value and error with a common power of ten, the error with two digits: "(2.10 ± 0.31)×10⁻⁴". */
  function withError(value, error) {
    if (!isNumber(value)) return "not finite";
    if (!isNumber(error) || error === 0) return number(value);
    const errorExponent = exponentOf(error);
    const top = Math.max(value === 0 ? errorExponent : exponentOf(value), errorExponent);
    // An error far below the value would print a tail of meaningless digits.
    if (top - errorExponent > 5) return number(value, 5) + " ± " + number(error, 2);
    if (isPlain(top)) {
      const decimals = Math.max(0, 1 - errorExponent);
      return minus(value.toFixed(decimals)) + " ± " + error.toFixed(decimals);
    }
    const scale = Math.pow(10, top);
    const decimals = Math.max(0, 1 - errorExponent + top);
    return (
      "(" +
      minus((value / scale).toFixed(decimals)) +
      " ± " +
      (error / scale).toFixed(decimals) +
      ")" +
      power(top)
    );
  }

  /** Both ends of a range with as many digits as it takes to tell them apart. */
  function range(low, high) {
    if (!isNumber(low) || !isNumber(high)) return ["not finite", "not finite"];
    const top = exponentOf(Math.max(Math.abs(low), Math.abs(high)));
    const digits = Math.min(12, Math.max(2, top - exponentOf(high - low) + 2));
    return [number(low, digits), number(high, digits)];
  }

  /** All digits, for tooltips. */
  function exact(value) {
    return isNumber(value) ? minus(String(value)) : "not finite";
  }

  /** The unit behind a number; "1" is the unit of numbers without one. */
  function unit(text) {
    return !text || text === "1" ? "" : " " + text;
  }

  function seconds(value) {
    if (!isNumber(value)) return "–";
    return value >= 100 ? value.toFixed(0) : value.toFixed(value >= 10 ? 1 : value >= 0.1 ? 2 : 3);
  }

  /** "22 Nov 2026, 05:00 UTC"; text that is no date is shown as it is. */
  function date(text) {
    const time = new Date(text || "");
    if (Number.isNaN(time.getTime())) return text || "date not recorded";
    const day = time.toLocaleDateString("en-GB", {
      day: "numeric",
      month: "short",
      year: "numeric",
      timeZone: "UTC",
    });
    return day + ", " + time.toISOString().slice(11, 16) + " UTC";
  }

  function plural(count, one, many) {
    return count + " " + (count === 1 ? one : many || one + "s");
  }

  function settings(object) {
    return Object.entries(object || {})
      .map(
        ([key, value]) =>
          key +
          " = " +
          (isNumber(value) ? exact(value) : value === null ? "not finite" : String(value)),
      )
      .join(", ");
  }

  crossgrain.format = {
    isNumber,
    number,
    limit,
    withError,
    range,
    exact,
    unit,
    seconds,
    date,
    plural,
    settings,
  };
})(window.crossgrain);
