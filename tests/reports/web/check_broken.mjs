// Documents without a finite number and with outcomes the pages do not know.
import assert from "node:assert/strict";
import { assertQuiet, greenElements, openCase, plots } from "./page_probes.mjs";

export async function brokenChecks(check, open, document) {
  const page = await open("index.html");
  await check("without a finite number there is a sentence, not an empty plot", async () => {
    await plots(page);
    assert.equal(await page.locator(".js-plotly-plot").count(), 0);
    for (const section of ["certificate", "lid-height", "spectrum", "convergence"])
      assert.match(
        await page.locator(`#${section}`).innerText(),
        /There is no finite number to draw\./,
      );
  });
  await check("an unknown outcome is unexpected and not green", async () => {
    const count = document.cases.flatMap((item) => item.verdicts).length;
    assert.equal(await page.locator('#matrix [data-expected="false"]').count(), count);
    assert.deepEqual(await greenElements(page), []);
  });
  await check("broken findings, pictures and series leave a sentence", async () => {
    for (const part of await page.locator(".case-part").all())
      await openCase(page, await part.getAttribute("data-case"));
    await plots(page);
    assert.match(
      await page.locator("#cases").innerText(),
      /could not be written[\s\S]*There is no finite number/,
    );
    assert.equal(await page.locator("#cases .js-plotly-plot").count(), 0);
  });
  await check("no console message (broken)", () => assertQuiet(page));
  await check("a history without finite values says so", async () => {
    const history = await open("history.html");
    await plots(history);
    assert.equal(await history.locator(".js-plotly-plot").count(), 0);
    assertQuiet(history);
  });
}
