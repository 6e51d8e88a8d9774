// One look for all plots, drawn when scrolled into view, and redrawn when the theme changes or the
// page is printed. A figure hands over a function that builds its traces and axes; colours are read
// from the style sheet at that moment.
window.crossgrain = window.crossgrain || {};
(function (crossgrain) {
  "use strict";
  const { el, missing } = crossgrain.dom;

  const figures = new Map(); // plot element -> {build, drawn, config, hidden: legend groups switched off}
  // No button that could send a figure anywhere: the report stays where it was opened.
  const config = {
    displaylogo: false,
    responsive: true,
    modeBarButtons: [["toImage", "zoom2d", "pan2d", "resetScale2d"]],
  };

  const variable = (name) =>
    getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  /** Text for Plotly, which reads a small markup language. */
  function plain(text) {
    return String(text).replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");
  }

  /** An axis with a title that names quantity and unit. `options` override. */
  function axis(title, options) {
    const type = (options && options.type) || "linear";
    return {
      title: { text: title, standoff: 6 },
      gridcolor: variable("--plot-grid"),
      linecolor: variable("--plot-axis"),
      tickcolor: variable("--plot-axis"),
      showline: true,
      mirror: true,
      ticks: "outside",
      ticklen: 4,
      zeroline: false,
      automargin: true,
      exponentformat: "power",
      minor:
        type === "log"
          ? { ticks: "outside", ticklen: 2, tickcolor: variable("--plot-axis") }
          : undefined,
      tickangle: 0,
      ...options,
    };
  }

  /** A log axis around `values`, with few enough ticks that only decades are labelled. */
  function logAxis(title, values, options) {
    const logs = values.filter((value) => value > 0).map(Math.log10);
    const low = logs.reduce((a, b) => Math.min(a, b), Infinity);
    const high = logs.reduce((a, b) => Math.max(a, b), -Infinity);
    if (low > high) return axis(title, { type: "log", ...options });
    const margin = Math.max(0.06 * (high - low), 0.15);
    const range = [low - margin, high + margin];
    // With more than 0.7 decades per tick Plotly labels whole decades only.
    const nticks = Math.max(2, Math.min(8, Math.ceil(range[1] - range[0])));
    return axis(title, { type: "log", range, nticks, ...options });
  }

  /** A name written at the end of a guide line, in log-log axes. */
  function guideLabel(text, x, y, options) {
    return {
      text,
      x: Math.log10(x),
      y: Math.log10(y),
      showarrow: false,
      font: { size: 11, color: variable("--soft") },
      ...options,
    };
  }

  function layout(parts) {
    const font = {
      family: getComputedStyle(document.body).fontFamily,
      size: 12,
      color: variable("--text"),
    };
    return {
      font,
      paper_bgcolor: "rgba(0,0,0,0)",
      plot_bgcolor: variable("--plot-background"),
      margin: { l: 62, r: 14, t: 10, b: 44 },
      showlegend: false, // legend.js: one that wraps on narrow screens
      hoverlabel: { font: { family: font.family, size: 12 }, align: "left", namelength: -1 },
      hovermode: "closest",
      // Dragging must scroll the page on a touch screen, not zoom the plot.
      dragmode: window.matchMedia("(pointer: coarse)").matches ? false : "zoom",
      ...parts,
    };
  }

  /** A figure that cannot be drawn says so in its place and leaves the others alone. */
  function draw(plot) {
    try {
      react(plot, figures.get(plot));
    } catch (error) {
      figures.delete(plot);
      plot.replaceChildren(missing("This figure could not be drawn: " + error.message));
      console.error(error);
    }
  }

  const finite = (value) => value !== null && value !== undefined && Number.isFinite(Number(value));
  const hasPoint = (trace) =>
    trace.x.some((x, i) => (trace.type === "bar" ? finite(x) : finite(x) && finite(trace.y[i])));

  function react(plot, figure) {
    const { data, layout: parts } = figure.build();
    if (!data.some(hasPoint)) {
      figures.delete(plot);
      plot.style.height = "";
      plot.replaceChildren(missing("There is no finite number to draw."));
      return;
    }
    figure.drawn = true;
    for (const trace of data) if (figure.hidden.has(trace.legendgroup)) trace.visible = false;
    window.Plotly.react(plot, data, layout(parts), { ...config, ...figure.config });
  }

  const watcher = new IntersectionObserver(
    (entries) => {
      for (const entry of entries) {
        if (!entry.isIntersecting) continue;
        watcher.unobserve(entry.target);
        const figure = figures.get(entry.target);
        if (figure && !figure.drawn) draw(entry.target);
      }
    },
    { rootMargin: "400px" },
  );

  /** Figures that the page has replaced by others are forgotten. */
  function present() {
    for (const plot of [...figures.keys()]) if (!plot.isConnected) figures.delete(plot);
    return [...figures];
  }

  function drawAll() {
    for (const [plot] of present()) draw(plot);
  }

  function redrawDrawn() {
    for (const [plot, figure] of present()) if (figure.drawn) draw(plot);
  }

  function toggle(plot, group) {
    const { hidden } = figures.get(plot);
    if (!hidden.delete(group)) hidden.add(group);
    draw(plot);
    return !hidden.has(group);
  }

  /**
   * A figure: {name, title, label, height, build, config, notes, legend}. `name` is what tests look
   * for; `legend` is a list for legend.js whose groups are the traces' `legendgroup`.
   */
  function figure({ name, title, label, height, build, config: extra, notes, legend }) {
    const plot = el("div", {
      class: "plot",
      "data-plot": name,
      role: "group",
      "aria-label": label || title,
      style: "height: " + height + "px",
    });
    figures.set(plot, { build, drawn: false, config: extra, hidden: new Set() });
    watcher.observe(plot);
    const caption =
      title || (notes && notes.length)
        ? el(
            "figcaption",
            {},
            title ? el("strong", {}, title) : null,
            (notes || []).map((note) => el("span", { class: "note" }, " " + note)),
          )
        : null;
    return el(
      "figure",
      {},
      caption,
      legend ? crossgrain.legend(legend, (group) => toggle(plot, group)) : null,
      plot,
    );
  }

  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redrawDrawn);
  window.matchMedia("print").addEventListener("change", redrawDrawn);
  window.addEventListener("beforeprint", drawAll);

  crossgrain.plot = { figure, axis, logAxis, guideLabel, plain, variable, drawAll };
})(window.crossgrain);
