// A report of 40 cases with 24 variants each: what is not looked at is neither read nor drawn.
import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { join } from "node:path";
import { assertQuiet } from "./page_probes.mjs";

export async function manyChecks(check, open, report) {
  const verdicts = report.document.cases.flatMap((item) => item.verdicts).length;
  const page = await open("index.html");
  const size = statSync(join(report.directory, "data.js")).size;
  const elements = await page.evaluate(() => document.querySelectorAll("*").length);
  const { domContentLoadedEventEnd: ready } = await page.evaluate(() =>
    performance.getEntriesByType("navigation")[0].toJSON(),
  );
  const megabytes = (size / 1e6).toFixed(1);
  console.log(
    `        ${verdicts} verdicts: ready after ${ready.toFixed(0)} ms, data.js ${megabytes} MB, ${elements} elements`,
  );
  await check("the page of many cases reads no curve and draws no plot by itself", async () => {
    assert.ok(size < 1200 * verdicts, `data.js has ${size} bytes for ${verdicts} verdicts`);
    assert.ok(elements < 40 * verdicts, `${elements} elements for ${verdicts} verdicts`);
    assert.equal(await page.evaluate(() => window.crossgrainSeries), undefined);
    assert.equal(await page.locator(".js-plotly-plot").count(), 0);
  });
  await check(
    "long cases are folded, filters look into them, and they can be unfolded",
    async () => {
      const visible = () => page.locator("#matrix .chip:visible").count();
      assert.equal(await visible(), 0);
      await page.locator("#matrix .fold").first().click();
      assert.equal(await visible(), verdicts / 40);
      await page.selectOption("#filter-outcome", "disagree");
      const disagree = report.document.cases
        .flatMap((item) => item.verdicts)
        .filter((v) => v.verdict === "disagree");
      assert.equal(
        await page.locator("#matrix .chip:visible:not(.faded)").count(),
        disagree.length,
      );
    },
  );
  await check("costs of many variants are summed by case", async () => {
    assert.equal(await page.locator("#cost tbody tr").count(), 40);
  });
  await check("the table of runs is made when it is asked for", async () => {
    assert.equal(await page.locator(".runs").count(), 0);
    await page.locator(".all-runs summary").press("Enter");
    await page.locator(".runs").waitFor();
    assert.equal(
      await page.locator(".runs tbody tr").count(),
      report.document.cases.flatMap((item) => item.runs).length,
    );
  });
  await check("no console message (many)", () => assertQuiet(page));
}
