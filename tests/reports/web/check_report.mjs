// index.html of a document with every kind of verdict, series and failure.
import assert from "node:assert/strict";
import {
  assertNoOverflow,
  assertQuiet,
  countTraces,
  greenElements,
  plots,
  tooltipOf,
} from "./page_probes.mjs";

async function checkMatrix(check, page, verdicts) {
  await check("every verdict has its cell, in words", async () => {
    const words = await page
      .locator("#matrix [data-verdict]")
      .evaluateAll((cells) => cells.map((cell) => [cell.dataset.verdict, cell.innerText]));
    assert.equal(words.length, verdicts.length);
    for (const [verdict, text] of words)
      assert.ok(text.includes(verdict.replace("_", " ")), `${verdict} is not said in "${text}"`);
  });
  await check("unexpected verdicts are marked and come first in the sentence", async () => {
    assert.equal(
      await page.locator('#matrix [data-expected="false"]').count(),
      verdicts.filter((v) => !v.expected).length,
    );
    assert.match(
      await page.locator("#outcome").innerText(),
      /^2 verdicts are unexpected: collision-normal, restitution, yade/,
    );
  });
  await check("only agree is green, in both themes", async () => {
    for (const colorScheme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme });
      const green = await greenElements(page);
      assert.ok(
        green.some((element) => element.agree),
        "agree is not green",
      );
      assert.deepEqual(
        green.filter((element) => !element.agree),
        [],
      );
    }
  });
  await check("the tooltip has all digits, the limit's reason and the reason", async () => {
    const cell = page.locator('#matrix [data-verdict="disagree"][data-expected="true"]');
    const text = await tooltipOf(page, cell);
    for (const part of ["0.00331", "second order scheme", "first order in dt"])
      assert.ok(text.includes(part), `"${part}" is not in "${text}"`);
  });
}

async function checkFilter(check, page, verdicts) {
  const visible = () => page.locator("#matrix .chip:visible:not(.faded)").count();
  await check("the matrix can be filtered by case and outcome", async () => {
    await page.selectOption("#filter-outcome", "disagree");
    assert.equal(await visible(), verdicts.filter((v) => v.verdict === "disagree").length);
    await page.selectOption("#filter-case", "bed-fluid");
    assert.equal(await visible(), 0);
    assert.equal(
      await page.locator("#filter-status").innerText(),
      `0 of ${verdicts.length} verdicts`,
    );
    await page.selectOption("#filter-outcome", "all");
    assert.equal(await visible(), verdicts.filter((v) => v.case === "bed-fluid").length);
    await page.selectOption("#filter-case", "all");
    assert.equal(await visible(), verdicts.length);
  });
}

async function checkPlots(check, page, document) {
  const drawn = await plots(page);
  const named = (name) => drawn.filter((plot) => plot.name === name);
  const series = (name) =>
    document.cases.flatMap((item) => item.series).filter((entry) => entry.name === name);
  await check("each plot has as many traces as the document has series", () => {
    assert.equal(countTraces(named("lid-height")[0], "height"), series("lid-height").length);
    assert.equal(
      countTraces(named("lid-height")[0], "difference"),
      series("lid-height").length - 1,
    );
    assert.equal(named("spectrum").length, 3);
    for (const plot of named("spectrum")) {
      assert.equal(countTraces(plot, "spectrum"), series("spectrum").length);
      assert.equal(countTraces(plot, "fit"), series("spectrum-fit").length);
    }
    assert.equal(named("convergence").length, 2);
    for (const plot of named("convergence"))
      assert.equal(countTraces(plot, "convergence"), series("convergence").length);
    const pairs = named("certificate").reduce((sum, plot) => sum + countTraces(plot, "pair"), 0);
    assert.equal(pairs, document.certificate.pairs.length);
    assert.equal(named("cost").length, 3);
  });
  await check("every axis of a measured quantity names its unit", () => {
    for (const name of ["lid-height", "spectrum", "convergence", "certificate"])
      for (const plot of named(name)) for (const title of plot.axes) assert.match(title, /\(.+\)/);
  });
  await check("a legend entry switches its curves off and on", async () => {
    const shown = () =>
      page
        .locator('[data-plot="lid-height"]')
        .evaluate((plot) => plot.data.filter((trace) => trace.visible !== false).length);
    const before = await shown();
    const entry = page.locator("#lid-height .legend button", { hasText: "lammps" });
    await entry.click();
    assert.equal(await shown(), before - 2);
    await entry.click();
    assert.equal(await shown(), before);
  });
}

async function checkMissing(check, page) {
  await check("missing parts say what is missing", async () => {
    assert.match(
      await page.locator("#lid-height").innerText(),
      /No run of bed-deep in this store\./,
    );
    assert.match(
      await page.locator('[data-case="bed-deep"]').innerText(),
      /No run of bed-deep in this store\./,
    );
    assert.match(
      await page.locator("#lid-height").innerText(),
      /yade \(full\): run failed – killed at the time limit/,
    );
  });
  await check("a failed run shows its reason and log as text", async () => {
    const text = await page.locator(".failure").innerText();
    assert.ok(text.includes("<script>alert(1)</script>"));
    assert.ok(text.includes("killed at the time limit of 60 s"));
  });
}

export async function reportChecks(check, open, document) {
  const verdicts = document.cases.flatMap((item) =>
    item.verdicts.map((verdict) => ({ ...verdict, case: item.case })),
  );
  const page = await open("index.html");
  await checkMatrix(check, page, verdicts);
  await checkFilter(check, page, verdicts);
  await checkPlots(check, page, document);
  await checkMissing(check, page);
  await check("tables have captions and headers with scope", async () => {
    const bad = await page
      .locator("table")
      .evaluateAll(
        (tables) =>
          tables.filter((t) => !t.caption || [...t.querySelectorAll("th")].some((th) => !th.scope))
            .length,
      );
    assert.equal(bad, 0);
  });
  await check("print is light whatever the theme", async () => {
    await page.emulateMedia({ media: "print", colorScheme: "dark" });
    assert.equal(
      await page.evaluate(() => getComputedStyle(document.body).backgroundColor),
      "rgb(255, 255, 255)",
    );
    await page.emulateMedia({ media: "screen", colorScheme: "light" });
  });
  await check("no console message, no request beyond the file system (report)", () =>
    assertQuiet(page),
  );
  for (const width of [360, 1400]) {
    await check(`no horizontal overflow at ${width} px (report)`, async () => {
      const narrow = await open("index.html", { width, height: 800 });
      await plots(narrow);
      await assertNoOverflow(narrow);
      assertQuiet(narrow);
    });
  }
}
