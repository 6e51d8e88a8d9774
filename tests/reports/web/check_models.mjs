// Readings, failure maps, pictures and the viewer of series.
import assert from "node:assert/strict";
import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { phenomenaChecks } from "./check_phenomena.mjs";
import {
  assertNoOverflow,
  assertQuiet,
  greenElements,
  openCase,
  part,
  tooltipOf,
} from "./page_probes.mjs";

/** Traces and axis types of the series plot of a case. */
async function seriesPlot(page, name) {
  await part(page, name).locator('[data-plot="series"]').scrollIntoViewIfNeeded();
  const plot = part(page, name).locator('[data-plot="series"].js-plotly-plot');
  await plot.waitFor();
  return plot.evaluate((node) => ({
    metas: node.data.map((trace) => trace.meta),
    points: node.data.map((trace) => trace.x.length),
    types: [node.layout.xaxis.type, node.layout.yaxis.type],
    titles: [node.layout.xaxis.title.text, node.layout.yaxis.title.text],
  }));
}

async function checkReadings(check, page) {
  const table = page.locator("#readings table");
  await check("the readings table has a row per figure and a column per reading", async () => {
    assert.deepEqual(await table.locator("thead th").allInnerTexts(), [
      "figure, observable, reference",
      "P",
      "D",
      "std",
    ]);
    const cells = await table
      .locator("tbody tr")
      .evaluateAll((rows) =>
        rows.map((row) => [...row.cells].slice(1).map((cell) => cell.dataset.outcomes)),
      );
    assert.deepEqual(cells, [
      ["agree", "agree, disagree", "undecided, disagree"],
      ["agree", "agree", undefined],
    ]);
  });
  await check("a cell of the readings table tells each verdict with its value", async () => {
    const text = await tooltipOf(
      page,
      table.locator("tbody tr").first().locator(".c-disagree").first(),
    );
    for (const piece of ["D/dissipation=0.5", "1.390 ± 0.015", "reason of D/dissipation=0.5"])
      assert.ok(text.includes(piece), `"${piece}" is not in "${text}"`);
  });
}

async function checkPictures(check, page, report) {
  await check("nothing of a case is loaded before it is opened", async () => {
    assert.equal(await page.locator(".case-part img").count(), 0);
    assert.equal(await page.evaluate(() => window.crossgrainSeries), undefined);
  });
  await check("the matrix leads to the pictures of a case", async () => {
    await page.locator('#matrix [data-case="pipe-gas-limits"] .case-head a').click();
    assert.equal(await part(page, "pipe-gas-limits").getAttribute("open"), "");
    await part(page, "pipe-gas-limits").locator("> summary").press("Enter");
  });
  await check("pictures are shown with captions, and damaged ones say so", async () => {
    const opened = await openCase(page, "pipe-gas-fig6");
    const images = opened.locator(".picture img");
    assert.equal(await images.count(), 2);
    await images.first().scrollIntoViewIfNeeded();
    await page.waitForFunction(() => document.querySelector(".picture img").naturalWidth > 0);
    assert.deepEqual(
      await images.first().evaluate((image) => [image.naturalWidth, image.naturalHeight]),
      [20, 400],
    );
    assert.ok(
      await images.first().evaluate((image) => image.getBoundingClientRect().width > 100),
      "stretched",
    );
    assert.match(
      await opened.locator(".picture .missing").innerText(),
      /could not be written: packed bytes/,
    );
    const caption = await opened.locator(".picture figcaption").first().innerText();
    for (const piece of ["P/dissipation=0.1", "space-time", "red: 2 <particles>"])
      assert.ok(caption.includes(piece));
    for (const file of await opened
      .locator(".picture a")
      .evaluateAll((links) => links.map((a) => a.getAttribute("href"))))
      assert.ok(existsSync(join(report.directory, file)), file);
    assert.equal(readdirSync(join(report.directory, "pictures")).length, 3);
  });
  await check("a small picture keeps its pixels", async () => {
    const image = (await openCase(page, "hopper-automaton")).locator("img");
    assert.deepEqual(
      await image.evaluate((node) => [
        getComputedStyle(node).imageRendering,
        node.getAttribute("width"),
      ]),
      ["pixelated", "360"],
    );
  });
}

async function checkFindings(check, page, report) {
  await check("a failure map has the state of every variant, and a legend", async () => {
    const opened = await openCase(page, "pipe-gas-failure");
    const item = report.document.cases.find((entry) => entry.case === "pipe-gas-failure");
    assert.deepEqual(await opened.locator(".state-map caption").allInnerTexts(), ["P", "D"]);
    assert.deepEqual(
      await opened.locator(".state-map").first().locator("thead th").allInnerTexts(),
      ["gravity ↑ density →", "0.5", "1", "10"],
    );
    const shown = await opened
      .locator(".state-map [data-state]")
      .evaluateAll((cells) => cells.map((c) => c.dataset.state));
    assert.deepEqual(shown.sort(), item.findings.map((entry) => entry.label).sort());
    assert.equal(await opened.locator(".state-map .empty").count(), 1);
    assert.match(await opened.locator(".states").innerText(), /steady 2[\s\S]*melted 1/);
  });
  await check("a number and a name span a map, other keys make maps of their own", async () => {
    const opened = await openCase(page, "pipe-gas-limits");
    const maps = await opened
      .locator(".state-map")
      .evaluateAll((tables) =>
        tables.map((table) =>
          [...table.rows].map((row) => [...row.cells].map((cell) => cell.textContent)),
        ),
      );
    const expected = (variant) => [
      ["reading ↓  density →", "0.8", "7"],
      ...["P", "D"].map((reading) => [
        reading,
        ...["0.8", "7"].map((density) => `${reading}/density=${density}/${variant}`),
      ]),
    ];
    assert.deepEqual(maps, [expected("rough"), expected("smooth")]);
  });
  await check("replicas that differ are both told", async () => {
    assert.match(
      await part(page, "hopper-automaton").locator(".findings").innerText(),
      /bands 1 of 2 patches 1 of 2/,
    );
  });
}

async function checkSeries(check, page) {
  await check("a spectrum is drawn log-log, one curve per variant, with units", async () => {
    const plot = await seriesPlot(page, "pipe-gas-fig6");
    assert.deepEqual(plot.metas, Array(6).fill("curve"));
    assert.deepEqual(plot.types, ["log", "log"]);
    assert.deepEqual(plot.titles, ["f (1/step)", "P (step)"]);
  });
  await check("series, run, quantity and axes can be chosen", async () => {
    const opened = part(page, "pipe-gas-fig6");
    await opened.locator("select").nth(0).selectOption("contrast");
    assert.deepEqual((await seriesPlot(page, "pipe-gas-fig6")).types, ["linear", "linear"]);
    await opened.locator("select").nth(1).selectOption("0");
    const one = await seriesPlot(page, "pipe-gas-fig6");
    assert.deepEqual(one.metas, ["curve", "curve"]); // C and its white-noise value, one unit
    await opened.locator("select").nth(3).selectOption("linear log");
    assert.deepEqual((await seriesPlot(page, "pipe-gas-fig6")).types, ["linear", "log"]);
  });
  await check("fits and the experimental band are drawn with P(theta)", async () => {
    const plot = await seriesPlot(page, "hopper-automaton");
    assert.deepEqual(plot.metas, ["band-edge", "band", "curve", "curve", "curve"]);
    assert.deepEqual(plot.types, ["log", "log"]);
  });
  await check("a table in long form is drawn as one curve per key", async () => {
    await part(page, "hopper-automaton").locator("select").nth(0).selectOption("stagnation");
    const plot = await seriesPlot(page, "hopper-automaton");
    assert.deepEqual(plot.points, [78, 78]);
    assert.deepEqual(plot.titles, ["theta (degrees)", "P (1)"]);
    assert.match(
      await part(page, "hopper-automaton").locator(".legend").last().innerText(),
      /iteration = 50\s+iteration = 500/,
    );
  });
  await check("a displacement field is drawn as arrows", async () => {
    await openCase(page, "bed-solid");
    const plot = await seriesPlot(page, "bed-solid");
    assert.deepEqual([plot.metas, plot.points], [["arrows"], [360]]);
  });
}

export async function modelChecks(check, open, report) {
  const page = await open("index.html");
  await checkReadings(check, page);
  await checkPictures(check, page, report);
  await checkFindings(check, page, report);
  await checkSeries(check, page);
  await phenomenaChecks(check, page);
  await check("states are not green, in both themes", async () => {
    for (const colorScheme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme });
      assert.deepEqual(
        (await greenElements(page)).filter((element) => !element.agree),
        [],
      );
    }
  });
  await check("no console message, no request beyond the file system (models)", () =>
    assertQuiet(page),
  );
  await check("no horizontal overflow at 360 px (models)", async () => {
    const narrow = await open("index.html", { width: 360, height: 800 });
    for (const name of [
      "pipe-gas-fig6",
      "pipe-gas-failure",
      "pipe-gas-limits",
      "hopper-automaton",
      "bed-solid",
    ])
      await openCase(narrow, name);
    await narrow.evaluate(() => window.crossgrain.plot.drawAll());
    await assertNoOverflow(narrow);
    assertQuiet(narrow);
  });
}
