// Makes a picture of a written report:
//   node reports/web/screenshot.mjs REPORT_DIR OUT.png [--page history.html] [--width 1400]
//        [--dark] [--section ID] [--open]
import { join, resolve } from "node:path";
import { parseArgs } from "node:util";
import { pathToFileURL } from "node:url";
import { withBrowser } from "./browser.mjs";

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    page: { type: "string", default: "index.html" },
    width: { type: "string", default: "1400" },
    dark: { type: "boolean", default: false },
    section: { type: "string" },
    open: { type: "boolean", default: false },
  },
});
const [directory, out] = positionals;
if (!directory || !out || !(Number(values.width) > 0)) {
  console.error(
    "usage: node screenshot.mjs REPORT_DIR OUT.png [--page history.html] [--width 1400] [--dark] [--section ID] [--open]",
  );
  process.exit(2);
}

const options = {
  viewport: { width: Number(values.width), height: 1000 },
  colorScheme: values.dark ? "dark" : "light",
};
try {
  await withBrowser(options, async (context) => {
    const page = await context.newPage();
    await page.goto(pathToFileURL(join(resolve(directory), values.page)).href);
    if (values.open) {
      await page.evaluate(() =>
        document.querySelectorAll("details").forEach((part) => (part.open = true)),
      );
      await page.waitForTimeout(500); // series are read from their files
      await page.evaluate(() =>
        document.querySelectorAll("img").forEach((image) => (image.loading = "eager")),
      );
    }
    await page.evaluate(() => window.crossgrain.plot.drawAll());
    await page.waitForTimeout(300); // the last relayout of Plotly is asynchronous
    if (values.section) await page.locator("#" + values.section).screenshot({ path: out });
    else await page.screenshot({ path: out, fullPage: true });
  });
} catch (error) {
  console.error(`screenshot: ${error.message.split("\n")[0]}`);
  process.exit(1);
}
