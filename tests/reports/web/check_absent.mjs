// A machine where nothing is installed: nothing is green, nothing looks like an empty success.
import assert from "node:assert/strict";
import { assertQuiet, greenElements, plots } from "./page_probes.mjs";

export async function absentChecks(check, open, document) {
  const page = await open("index.html");
  await check("without any code nothing is green", async () => {
    assert.deepEqual(await greenElements(page), []);
    const verdicts = document.cases.flatMap((item) => item.verdicts);
    assert.equal(
      await page.locator('#matrix [data-verdict="not_installed"]').count(),
      verdicts.length,
    );
    assert.match(
      await page.locator("#outcome").innerText(),
      new RegExp(`${verdicts.length} not installed`),
    );
  });
  await check("without any run there is no plot, but a sentence in its place", async () => {
    assert.equal((await plots(page)).length, 0);
    for (const section of ["certificate", "lid-height", "spectrum", "convergence", "cost"])
      assert.ok(
        (await page.locator(`#${section} .missing`).count()) > 0,
        `#${section} does not say what is missing`,
      );
    assert.match(await page.locator("#spectrum").innerText(), /lammps \(full\): not installed/);
  });
  await check("an empty history says so", async () => {
    const history = await open("history.html");
    assert.match(await history.locator(".missing").innerText(), /No history in this store/);
    assertQuiet(history);
  });
  await check("no console message (nothing installed)", () => assertQuiet(page));
}
