// Spectra S(K), one log-log panel per group of layers: points with error bars of each code, the
// fitted power law over its fit window, and a guide of slope -5/3.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el } = crossgrain.dom;
  const { list, column, columnUnit, seriesNamed, perCase, groupBy } = crossgrain.data;
  const { logAxis, guideLabel, figure, plain, variable } = crossgrain.plot;
  const format = crossgrain.format;

  /** Layer groups in the order of the columns: "S_1_5" -> {first: 1, last: 5, id: "1_5"}. */
  function layersOf(group) {
    const names = new Set(group.flatMap((series) => list(series.columns)));
    return [...names]
      .map((name) => /^S_(\d+)_(\d+)$/.exec(name))
      .filter(Boolean)
      .map(([, first, last]) => ({
        first: Number(first),
        last: Number(last),
        id: first + "_" + last,
      }));
  }

  const nameOf = (series) =>
    series.code + (series.replica > 0 ? ", replica " + series.replica : "");

  /** Rows of the fit table: [{first, last, k_min, k_max, exponent, exponent_err, amplitude}]. */
  function fitsOf(series) {
    const columns = list(series.columns);
    const rows = column(series, "k_min").length;
    return Array.from({ length: rows }, (_, i) =>
      Object.fromEntries(columns.map((name) => [name, column(series, name)[i]])),
    );
  }

  function fitOf(fits, series, layers) {
    const table = fits.find(
      (candidate) =>
        candidate.code === series.code && (candidate.replica || 0) === (series.replica || 0),
    );
    const fit =
      table &&
      fitsOf(table).find(
        (row) => row.layer_first === layers.first && row.layer_last === layers.last,
      );
    return fit && format.isNumber(fit.exponent) && format.isNumber(fit.amplitude) ? fit : null;
  }

  function points(series, layers) {
    const look = crossgrain.codes.look(series.code);
    const color = crossgrain.codes.color(series.code);
    const errors = column(series, "err_" + layers.id);
    return {
      type: "scatter",
      mode: "markers",
      meta: "spectrum",
      name: plain(nameOf(series)),
      legendgroup: nameOf(series),
      x: column(series, "K"),
      y: column(series, "S_" + layers.id),
      opacity: series.replica > 0 ? 0.5 : 1,
      customdata: errors.map(format.exact),
      error_y: {
        type: "data",
        array: errors.map((value) => (format.isNumber(value) ? value : 0)),
        thickness: 1,
        width: 2,
        color,
      },
      marker: { color, symbol: look.symbol, size: look.size, line: { width: 1.4 } },
      hovertemplate:
        "K = %{x}<br>S = %{y:.6g}" +
        (errors.length ? " ± %{customdata}" : "") +
        "<extra>%{fullData.name}</extra>",
    };
  }

  function fitLine(series, fit) {
    const ends = [fit.k_min, fit.k_max];
    return {
      type: "scatter",
      mode: "lines",
      meta: "fit",
      name: plain(nameOf(series)),
      legendgroup: nameOf(series),
      x: ends,
      y: ends.map((k) => fit.amplitude * Math.pow(k, fit.exponent)),
      line: {
        color: crossgrain.codes.color(series.code),
        dash: crossgrain.codes.look(series.code).dash,
        width: 1.6,
      },
      hovertemplate:
        "slope " +
        format.withError(fit.exponent, fit.exponent_err) +
        "<br>fit over K = " +
        fit.k_min +
        " … " +
        fit.k_max +
        "<extra>%{fullData.name}</extra>",
    };
  }

  /** {x, y} of a line of slope -5/3 above the data: it shows a slope, not a level. */
  function guide(group, layers) {
    const k = column(group[0], "K");
    const s = column(group[0], "S_" + layers.id);
    const used = k.filter((value, i) => value > 0 && s[i] > 0);
    if (used.length < 2) return null;
    const lift =
      2 *
      Math.max(...k.map((value, i) => (value > 0 && s[i] > 0 ? s[i] * Math.pow(value, 5 / 3) : 0)));
    const x = [used[Math.floor(used.length / 4)], used[used.length - 1]];
    return { x, y: x.map((value) => lift * Math.pow(value, -5 / 3)) };
  }

  function build(group, fits, layers) {
    const fitted = group.map((series) => fitOf(fits, series, layers));
    const line = guide(group, layers);
    const levels = [
      ...group.flatMap((series) => column(series, "S_" + layers.id)),
      ...(line ? line.y : []),
    ];
    return {
      data: [
        ...group.map((series) => points(series, layers)),
        ...group.flatMap((series, i) => (fitted[i] ? [fitLine(series, fitted[i])] : [])),
        ...(line
          ? [
              {
                type: "scatter",
                mode: "lines",
                meta: "guide",
                hoverinfo: "skip",
                ...line,
                line: { color: variable("--soft"), dash: "1px,3px", width: 1.6 },
              },
            ]
          : []),
      ],
      layout: {
        xaxis: logAxis(
          "K (" + plain(columnUnit(group[0], "K")) + ")",
          group.flatMap((series) => column(series, "K")),
        ),
        yaxis: logAxis("S(K) (" + plain(columnUnit(group[0], "S_" + layers.id)) + ")", levels),
        annotations: line
          ? [guideLabel("K<sup>−5/3</sup>", line.x[0], line.y[0], { xanchor: "right", xshift: -3 })]
          : [],
      },
    };
  }

  function legendEntry(series, fit) {
    const slope = fit ? ", slope " + format.withError(fit.exponent, fit.exponent_err) : ", no fit";
    return {
      group: nameOf(series),
      text: nameOf(series) + slope,
      style: { ...crossgrain.codes.look(series.code), width: fit ? 1.6 : 0 },
    };
  }

  function panel(item, variant, group, fits, layers) {
    return figure({
      name: "spectrum",
      title: "layers " + layers.first + "–" + layers.last,
      height: 320,
      label:
        "Spectrum of layers " +
        layers.first +
        " to " +
        layers.last +
        ", " +
        item.case +
        " " +
        variant,
      legend: group.map((series) => legendEntry(series, fitOf(fits, series, layers))),
      build: () => build(group, fits, layers),
    });
  }

  function panels(item, absent) {
    const variantOf = (series) => series.variant || "";
    const groups = groupBy(seriesNamed(item, "spectrum"), variantOf);
    return [...groups].flatMap(([variant, group]) => {
      const fits = seriesNamed(item, "spectrum-fit").filter(
        (series) => variantOf(series) === variant,
      );
      const notes = fits.length ? absent : [...absent, "no fit is recorded"];
      return [
        el("h3", {}, item.case + (variant ? ", " + variant : "")),
        notes.length ? el("p", { class: "note" }, notes.join("; ") + ".") : null,
        el(
          "div",
          { class: "panels" },
          layersOf(group).map((layers) => panel(item, variant, group, fits, layers)),
        ),
      ];
    });
  }

  crossgrain.spectrum = (report) => perCase(report, "spectrum", panels);
})(window.crossgrain);
