// Opens pages in the system's Chromium, without a profile and without background traffic.
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const candidates = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

/** Path of the browser, or undefined when there is none. CHROMIUM overrides. */
export function browserPath() {
  const wanted = process.env.CHROMIUM;
  return wanted
    ? existsSync(wanted)
      ? wanted
      : undefined
    : candidates.find((path) => existsSync(path));
}

/** playwright-core from CROSSGRAIN_NODE_MODULES, or from node_modules beside this file. */
function playwright() {
  const modules =
    process.env.CROSSGRAIN_NODE_MODULES ||
    join(dirname(fileURLToPath(import.meta.url)), "node_modules");
  if (!existsSync(join(modules, "playwright-core")))
    throw new Error(
      `playwright-core is not in ${modules}: run "npm ci" in reports/web, or set CROSSGRAIN_NODE_MODULES`,
    );
  return createRequire(join(modules, "x.js"))("playwright-core");
}

/** Runs `use(context)` in a fresh browser and removes its profile afterwards. */
export async function withBrowser(options, use) {
  const executablePath = browserPath();
  if (!executablePath) throw new Error("Chromium was not found: install it, or set CHROMIUM");
  const profile = mkdtempSync(join(tmpdir(), "crossgrain-browser-"));
  try {
    const context = await playwright().chromium.launchPersistentContext(profile, {
      executablePath,
      headless: true,
      args: [
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-dev-shm-usage", // containers often have 64 MB of it
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
      ],
      ...options,
    });
    try {
      return await use(context);
    } finally {
      await context.close();
    }
  } finally {
    rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 100 });
  }
}
