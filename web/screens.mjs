// SPDX-License-Identifier: Apache-2.0
// Pictures of report.html for docs/manual/report.md, out of what the tutorials computed: node screens.mjs TUTORIALS PICTURES
// TUTORIALS has a folder for each page of docs/tutorials. Exits with 77 where there is no Chromium.
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { closeBrowser, openPage, openWindow } from "./browser.mjs";

const [, , tutorials, pictures] = process.argv;
mkdirSync(pictures, { recursive: true });
const { page, complaints } = await openWindow({ width: 1100, height: 820 });
const save = (name) => page.screenshot({ path: join(pictures, `${name}.png`) });
const saveFrom = async (selector, name) => {
  await page.locator(selector).first().evaluate((element) => window.scrollTo(0, element.getBoundingClientRect().top + window.scrollY - 8));
  await save(name);
};

try {
  await openPage(page, join(tutorials, "rail_crush", "rail"), "report.html");
  await page.locator("h1 + p").evaluate((line) => { line.textContent = line.textContent.replace(/^\S*\//, ""); });  // no folder of this machine
  await save("report");
  await page.locator("#welds tr.weld").first().click();
  await page.waitForSelector("#weld-panel .uplot");
  await page.locator("#weld-panel").screenshot({ path: join(pictures, "report_weld.png") });
  await saveFrom("#histories", "report_histories");
  await openPage(page, join(tutorials, "body_modes", "modes"), "report.html");
  await page.locator("tr.mode").nth(9).click();
  await saveFrom("#view", "report_modes");
  await openPage(page, join(tutorials, "weld_placement", "corner"), "compare.html");
  await save("compare");
  if (complaints.length) throw new Error(complaints.join("\n"));
} catch (error) {
  console.error(error.message, complaints.join("\n"));
  process.exitCode = 1;
} finally {
  await closeBrowser();
}
