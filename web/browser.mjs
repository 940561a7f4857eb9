// SPDX-License-Identifier: Apache-2.0
// A headless Chromium without a network, and pages of Nugget in it. Ends the process with 77 where there is none.
import { existsSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

let browser;

/** A window of width x height pixels: its page, and what it complains of. */
export async function openWindow({ webgl = true, width, height }) {
  const executablePath = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/google-chrome"].find((path) => path && existsSync(path));
  if (!executablePath) {
    console.error("no Chromium here (apt-get install chromium, or set CHROMIUM)");
    process.exit(77);
  }
  const drawing = webgl ? ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"] : ["--disable-3d-apis"];
  browser = await chromium.launch({ executablePath, args: [...drawing, "--no-sandbox"] });
  const context = await browser.newContext({ viewport: { width, height }, offline: true, acceptDownloads: true });
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(error.stack));
  return { page, complaints };
}

/** Opens a report or comparison, waits until its model is drawn, and returns its address. */
export async function openPage(page, folder, name) {
  const address = pathToFileURL(resolve(folder, name)).href;
  await page.goto(address);
  await page.waitForFunction(() => {
    const { panel, panels } = window.nugget ?? {};
    const drawn = (panels?.[1] ?? panel)?.view.frames > 0 || document.getElementById("pictures");
    return document.body.classList.contains("alive") && drawn;
  }, null, { timeout: 60000 });
  return address;
}

export const closeBrowser = () => browser?.close();
