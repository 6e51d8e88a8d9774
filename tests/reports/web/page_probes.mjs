// What the checks look at in a page.
import assert from "node:assert/strict";

/** Draws every plot, also those below the fold, and returns their traces by name of the plot. */
export async function plots(page) {
  return page.evaluate(() => {
    window.crossgrain.plot.drawAll();
    return [...document.querySelectorAll("[data-plot].js-plotly-plot")].map((plot) => ({
      name: plot.dataset.plot,
      traces: plot.data.map((trace) => ({
        meta: trace.meta,
        name: trace.name,
        points: trace.x.length,
      })),
      axes: Object.entries(plot.layout)
        .filter(([key]) => /^[xy]axis/.test(key))
        .map(([, axis]) => axis.title.text),
    }));
  });
}

/** The folded part of a case. */
export const part = (page, name) => page.locator(`.case-part[data-case="${name}"]`);

/**
 * Opens a folded case and returns it once it shows all it has: a case is filled by an event that the
 * browser sends some time after the key, and its series come from a file. A key, since a click is
 * lost where pictures above the case arrive between its press and its release and move the page.
 */
export async function openCase(page, name) {
  const opened = part(page, name);
  await opened.locator("> summary").press("Enter");
  const isFilled = (details) => {
    const place = details.querySelector(":scope > div");
    return details.open && place.childElementCount > 0 && !place.textContent.includes("Loading");
  };
  try {
    const handle = await opened.elementHandle();
    await page.waitForFunction(isFilled, handle, { polling: 100 });
  } catch (error) {
    const isOpen = await opened.evaluate((details) => details.open);
    const state = isOpen ? "open, with " + (await opened.innerText()) : "still folded";
    throw new Error(`case ${name} is ${state}: ${error.message}`);
  }
  return opened;
}

/** Text of the tooltip that shows when the pointer rests on `target`. */
export async function tooltipOf(page, target) {
  await target.hover();
  await page.locator("#tooltip").waitFor({ state: "visible" });
  return page.locator("#tooltip").innerText();
}

export const countTraces = (plot, meta) =>
  plot.traces.filter((trace) => trace.meta === meta).length;

/** Elements that show green in any way, as "tag.class: text". */
export async function greenElements(page) {
  return page.evaluate(() => {
    const isGreen = (color) => {
      const [r, g, b, a = 1] = (color.match(/[\d.]+/g) || []).map(Number);
      return a > 0 && g > r + 3 && g > b + 3;
    };
    const properties = [
      "color",
      "backgroundColor",
      "borderLeftColor",
      "borderTopColor",
      "fill",
      "stroke",
    ];
    return [...document.querySelectorAll("body *")]
      .filter((element) =>
        properties.some((property) => isGreen(getComputedStyle(element)[property])),
      )
      .map((element) => ({
        text: element.textContent.trim().slice(0, 60),
        agree: element.closest(".c-agree, .v-agree, .t-agree") !== null,
      }));
  });
}

export async function assertNoOverflow(page) {
  const { content, window: width } = await page.evaluate(() => ({
    content: document.documentElement.scrollWidth,
    window: window.innerWidth,
  }));
  assert.ok(content <= width, `page is ${content} px wide in a window of ${width} px`);
}

export function assertQuiet(page) {
  assert.deepEqual(page.problems, []);
}
