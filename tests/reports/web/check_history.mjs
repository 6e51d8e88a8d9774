// history.html: flags, lazy charts, filters.
import assert from "node:assert/strict";
import { assertNoOverflow, assertQuiet, plots } from "./page_probes.mjs";

async function checkLazyDrawing(check, page, series) {
  const charts = page.locator('[data-plot="history"]');

  await check("charts are drawn when scrolled into view", async () => {
    assert.equal(await charts.count(), series.length);
    await page.waitForFunction(() => document.querySelector("[data-plot]").data);
    assert.equal(await charts.last().evaluate((plot) => plot.data === undefined), true);
    await charts.last().scrollIntoViewIfNeeded();
    await page.waitForFunction(() => [...document.querySelectorAll("[data-plot]")].at(-1).data);
  });
}

async function checkRows(check, page, series) {
  await check("series that left their band are flagged, first and in the sentence", async () => {
    const flagged = page.locator('.history tr[data-status="left_band"]');
    assert.equal(
      await flagged.count(),
      series.filter((entry) => entry.status === "left_band").length,
    );
    assert.match(await flagged.first().innerText(), /left the band/);
    assert.equal(
      await page.locator(".history tbody tr").first().getAttribute("data-status"),
      "left_band",
    );
    assert.match(
      await page.locator("#drift").innerText(),
      /^1 series left the band: cost of lammps in bed-fluid/,
    );
  });
  await check("each chart has the points of its series", async () => {
    const points = (await plots(page)).map((plot) => plot.traces[0].points).sort();
    assert.deepEqual(points, series.map((entry) => entry.points.length).sort());
  });
  await check("the history can be filtered", async () => {
    const visible = () => page.locator(".history tbody tr:visible").count();
    await page.selectOption("#history-status", "too_few");
    assert.equal(await visible(), series.filter((entry) => entry.status === "too_few").length);
    await page.selectOption("#history-status", "all");
    await page.fill("#history-text", "exponent");
    assert.equal(
      await visible(),
      series.filter((entry) => entry.observable.includes("exponent")).length,
    );
  });
}

export async function historyChecks(check, open, document) {
  const page = await open("history.html", { width: 1400, height: 500 });
  await checkLazyDrawing(check, page, document.history.series);
  await checkRows(check, page, document.history.series);
  await check("no console message (history)", () => assertQuiet(page));
  await check("no horizontal overflow at 360 px (history)", async () => {
    const narrow = await open("history.html", { width: 360, height: 800 });
    await plots(narrow);
    await assertNoOverflow(narrow);
  });
}
