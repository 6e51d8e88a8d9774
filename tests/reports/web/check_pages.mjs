// Opens written reports in Chromium from the file system and compares what is shown with what is in
// the documents.
//   node check_pages.mjs WRITE_REPORT ASSETS WORK_DIRECTORY
// Exit status 77 when there is no Chromium.
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { browserPath, withBrowser } from "../../../reports/web/browser.mjs";
import { absentChecks } from "./check_absent.mjs";
import { brokenChecks } from "./check_broken.mjs";
import { historyChecks } from "./check_history.mjs";
import { manyChecks } from "./check_many.mjs";
import { modelChecks } from "./check_models.mjs";
import { reportChecks } from "./check_report.mjs";

const [writeReport, assets, work] = process.argv.slice(2);
if (!browserPath()) {
  console.log("skipped: Chromium is not installed");
  process.exit(77);
}

function makeReport(kind) {
  const directory = join(work, kind);
  const document = join(work, kind + ".json");
  execFileSync(process.execPath, [
    join(dirname(fileURLToPath(import.meta.url)), "make_document.mjs"),
    kind,
    document,
  ]);
  execFileSync(writeReport, [document, directory, assets]);
  return { directory, document: JSON.parse(readFileSync(document, "utf8")) };
}

/** A page of a report; anything on its console or any request beyond the file system is an error. */
async function open(context, report, name, viewport) {
  const page = await context.newPage();
  page.problems = [];
  page.on(
    "console",
    (message) =>
      ["error", "warning"].includes(message.type()) && page.problems.push(message.text()),
  );
  page.on("pageerror", (error) => page.problems.push(error.message));
  page.on("dialog", (dialog) => page.problems.push("dialog: " + dialog.message()));
  page.on(
    "request",
    (request) =>
      /^(file|data|blob):/.test(request.url()) || page.problems.push("request: " + request.url()),
  );
  if (viewport) await page.setViewportSize(viewport);
  await page.goto(pathToFileURL(join(report.directory, name)).href);
  await page.waitForSelector("html[data-ready]");
  return page;
}

let failures = 0;
async function check(name, body) {
  try {
    await body();
    console.log("ok      " + name);
  } catch (error) {
    failures += 1;
    console.log("FAILED  " + name + "\n        " + error.message.split("\n").join("\n        "));
  }
}

rmSync(work, { recursive: true, force: true });
mkdirSync(work, { recursive: true });
const rich = makeReport("rich");
const absent = makeReport("absent");
const models = makeReport("models");
const many = makeReport("many");
const broken = makeReport("broken");
await withBrowser({ viewport: { width: 1400, height: 900 } }, async (context) => {
  const opener = (report) => (name, viewport) => open(context, report, name, viewport);
  await reportChecks(check, opener(rich), rich.document);
  await historyChecks(check, opener(rich), rich.document);
  await absentChecks(check, opener(absent), absent.document);
  await modelChecks(check, opener(models), models);
  await manyChecks(check, opener(many), many);
  await brokenChecks(check, opener(broken), broken.document);
});
process.exit(failures > 0 ? 1 : 0);
