// The section that sets models against molecular dynamics.
import assert from "node:assert/strict";
import { countTraces, plots } from "./page_probes.mjs";

export async function phenomenaChecks(check, page) {
  const section = page.locator("#models-content");
  await check(
    "every model has its value beside the reference, and differing rows say why",
    async () => {
      const rows = await section
        .locator("table.models")
        .first()
        .locator("tbody tr")
        .allInnerTexts();
      assert.equal(rows.length, 2);
      assert.match(
        rows[0],
        /V_w\/V\s+0\.459 ± 0\.004 ✗\s+1\.39 ± 0\.005 reference\s+1\.43 ± 0\.01 ✓\s+5 %/,
      );
      const told = await section.locator("dl").allInnerTexts();
      assert.equal(told.length, 1, "only the row that differs is explained");
      assert.match(told[0], /movers of the lattice gas have one speed/);
    },
  );
  await check("a title is text, whatever it looks like", async () => {
    assert.match(await section.locator("table.models thead").first().innerText(), /lattice <gas>/);
  });
  await check("models share the axes of a figure", async () => {
    const [figure] = (await plots(page)).filter((plot) => plot.name === "models");
    assert.equal(countTraces(figure, "model"), 2);
    assert.deepEqual(figure.axes.sort(), ["P", "theta"]);
    assert.deepEqual(
      figure.traces.map((trace) => [trace.name, trace.points]),
      [
        ["automaton", 3],
        ["YADE", 2],
      ],
    );
  });
  await check("what a convention is worth is told in percent, certain ones marked", async () => {
    const text = await section.locator("table.models").last().locator("tbody").innerText();
    // 0.7 of a mean of 10.5.
    assert.match(text, /lammps, liggghts\s+mean square spin\s+9\.52 ± 0\.19 \*\s+6\.67 ± 0\.19 \*/);
    assert.match(text, /1\.90 ± 0\.19(?! \*)/);
  });
}
