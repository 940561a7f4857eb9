// SPDX-License-Identifier: Apache-2.0
// Drives report.html in a headless Chromium, offline: node drive.mjs KIND FOLDER [PICTURE.png]
// KIND: impact, damage, modes, responses; without_webgl, of an impact; compare or compare_modes, of compare.html. Prints
// what it measured as JSON; exits with 1 and a word where something does not work, with 77 where there is no Chromium.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { closeBrowser, openPage, openWindow } from "./browser.mjs";

const [, , kind, folder, picture] = process.argv;
const { page, complaints } = await openWindow({ webgl: kind !== "without_webgl", width: 1280, height: 900 });
const began = Date.now();
const address = await openPage(page, folder, kind.startsWith("compare") ? "compare.html" : "report.html")
  .catch((error) => complaints.push(error.message));
const measured = { milliseconds_to_first_picture: Date.now() - began };
assert.deepEqual(complaints, []);

/** Different colours in the middle of the canvas: an empty view has one or two. */
const colours = () => page.evaluate(async () => {
  const image = new Image();
  image.src = window.nugget.panel.view.picture();
  await image.decode();
  const canvas = new OffscreenCanvas(image.width, image.height).getContext("2d");
  canvas.drawImage(image, 0, 0);
  const pixels = new Uint32Array(canvas.getImageData(0, 0, image.width, image.height).data.buffer);
  return new Set(pixels).size;
});
const camera = () => page.evaluate(() => window.nugget.panel.view.camera.position.toArray());
const text = (selector) => page.locator(selector).first().innerText();

/** Saves what a button gives, as text. */
async function saved(button) {
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  return readFileSync(await download.path(), "utf8");
}

async function turn() {
  const before = await camera(), box = await page.locator(".canvas").boundingBox();
  await page.mouse.move(box.x + 200, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(box.x + 330, box.y + 240, { steps: 4 });
  await page.mouse.up();
  assert.notDeepEqual(await camera(), before, "the view turns with the mouse");
}

async function play() {
  const place = () => page.evaluate(() => [window.nugget.panel.view.place, window.nugget.panel.view.scale]);
  const before = await place();
  await page.click("#play");
  await page.waitForTimeout(400);
  await page.click("#play");
  assert.notDeepEqual(await place(), before, "play moves the model");
}

/** From each side the first weld is clicked, until nothing of the model covers it. */
async function clickWeld() {
  await page.click("text=fit");
  for (const side of ["+z", "+y", "-y", "+x", "-x"]) {
    const [id, x, y] = await page.evaluate((from) => {
      const { panel, welds } = window.nugget;
      panel.view.look(from);
      panel.view.draw();
      return [welds[0].id, ...panel.view.onScreen(welds[0])];
    }, side);
    await page.mouse.click(x, y);
    await page.waitForTimeout(300);
    if (!(await page.locator("#weld-panel").isVisible()) || !new RegExp(`^Weld ${id}\\b`).test(await text("#weld-panel h3"))) continue;
    assert.ok((await page.url()).includes(`weld=${id}`), "the address leads to the weld");
    return;
  }
  assert.fail("a click on the disc opens the weld");
}

async function impact() {
  measured.colours = await colours();
  assert.ok(measured.colours > 20, "the model is drawn");
  await turn();
  await play();
  await clickWeld();
  assert.ok((await page.locator("#weld-panel .uplot").count()) > 0, "the weld's histories are drawn");
  const heading = page.locator("#welds th").nth(7);  // shear
  await heading.click();
  const shear = await page.locator("#welds tr.weld td:nth-child(8)").allInnerTexts();
  assert.deepEqual(shear, [...shear].sort((a, b) => a - b), "sorted by shear force");
  const csv = await saved(page.locator(".tools button").first());
  assert.equal(csv.trim().split("\r\n").length, 1 + shear.length, "the table as CSV");
  const named = await page.locator("#colour-by option").evaluateAll((all) => all.map((option) => option.value));
  for (const what of named) {
    await page.selectOption("#colour-by", what);
    assert.ok((await colours()) > 2, `coloured by ${what}`);
    if (what !== "part") assert.match(await text(".legend-3d"), new RegExp(`^${what}`), "the legend says what it is");
  }
  await page.selectOption("select[aria-label='cut plane']", "x");
  await page.selectOption("select[aria-label='cut plane']", "no cut");
  assert.ok((await page.locator("#histories .uplot").count()) === 1, "histories are drawn");
  await page.selectOption("#histories select[aria-label='file']", "swforc");
  const channels = await saved(page.locator("#histories button", { hasText: "CSV" }));
  assert.match(channels, /^channel,unit,time,value\r\nswforc weld/);
  await page.goto(`${address}#weld=${await page.evaluate(() => window.nugget.welds.at(-1).id)}&time=0`);
  await page.reload();
  await page.waitForSelector("#weld-panel:not([hidden])");
  assert.equal(await page.evaluate(() => window.nugget.panel.view.place), 0, "the link leads to its time");
}

/** What colours the view, and whether "damage" colours the first weld by its row of welds.csv. */
async function damage() {
  const options = page.locator("#colour-by option");
  measured.fields = await options.evaluateAll((all) => all.map((option) => option.value));
  measured.weld = null;
  if (!measured.fields.includes("damage")) return;
  await page.selectOption("#colour-by", "damage");
  assert.match(await text(".legend-3d"), /^damage\n/, "the legend says what it is");
  assert.ok((await colours()) > 2, "the model is drawn");
  const [weld, byFailure, byDamage, ends] = await page.evaluate(() => {
    const { panel, welds } = window.nugget, { view } = panel, weld = welds[0];
    if (!weld) return [null];
    const byDamage = view.weldColour(weld);
    panel.colourBy("part");
    return [weld.damage, view.weldColour(weld), byDamage, [weld.failed]];
  });
  if (weld === null) return;
  assert.ok(weld > 0 && weld < 1 && !ends[0], "the weld is damaged and holds");
  assert.notDeepEqual(byDamage, byFailure);
  measured.weld = "damage";
}

async function modes() {
  assert.ok((await colours()) > 20, "the mode is drawn");
  await page.locator("tr.mode").last().click();
  const last = await page.locator("tr.mode").last().locator("td").first().innerText();
  assert.match(await text("#when"), new RegExp(`^mode ${last}:`), "a click on a mode shows it");
  await play();
  await turn();
}

async function responses() {
  const plots = () => page.locator("#responses .uplot").count();
  assert.equal(await plots(), 2, "amplitude and phase");
  const before = await page.locator("#responses canvas").first().evaluate((canvas) => canvas.toDataURL());
  await page.locator("#responses label", { hasText: "linear" }).locator("input").check();
  const after = await page.locator("#responses canvas").first().evaluate((canvas) => canvas.toDataURL());
  assert.notEqual(after, before, "linear axes draw another picture");
  assert.match(await text("#responses p"), /Peaks of/);
}

/** Pictures in place of the view; all else as ever. */
async function withoutWebgl() {
  assert.match(await text("#view"), /draws no WebGL/);
  const widths = await page.locator("#pictures img").evaluateAll((all) => Promise.all(all.map((image) => image.decode().then(() => image.naturalWidth))));
  assert.deepEqual(widths, [1080, 1080], "two pictures of the model");
  await page.locator("#welds tr.weld").first().click();
  assert.ok((await page.locator("#weld-panel .uplot").count()) > 0, "the weld's histories are drawn");
}

const cameras = () => page.evaluate(() => window.nugget.panels.map((panel) => panel.view.camera.position.toArray()));

/** Turns the left view; the right one turns with it. */
async function turnBoth() {
  const canvas = page.locator(".side-A .canvas");
  await canvas.scrollIntoViewIfNeeded();
  const [before] = await cameras(), box = await canvas.boundingBox();
  await page.mouse.move(box.x + 100, box.y + 100);
  await page.mouse.down();
  await page.mouse.move(box.x + 180, box.y + 130, { steps: 4 });
  await page.mouse.up();
  const [a, b] = await cameras();
  assert.notDeepEqual(a, before, "the view turns with the mouse");
  a.forEach((x, k) => assert.ok(Math.abs(x - b[k]) < 1e-6 * Math.hypot(...a), "and the other one with it"));
}

async function compare() {
  await turnBoth();
  const times = await page.evaluate(() => {
    const { panels } = window.nugget;
    panels[0].showPlace(0);
    return panels.map((panel) => panel.time);
  });
  assert.deepEqual(times, [0, 0], "both show one time");
  await page.locator(".side-A #colour-by").selectOption("displacement");
  const [left, right] = await page.evaluate(() => window.nugget.panels.map((panel) => panel.view.colouring));
  assert.equal(left.kind, "displacement");
  assert.deepEqual(right, left, "one range of colours");
  assert.ok((await page.locator("#histories .uplot").count()) === 1, "histories over each other");
  measured.welds = await page.locator("#welds tr").count();
}

/** Modes of B come in another order or with other shapes: each pair that is clicked is shown. */
async function compareModes() {
  const rows = page.locator("#pairs tr.pair");
  measured.pairs = await rows.evaluateAll((all) => all.map((row) => [Number(row.dataset.a), Number(row.dataset.b), Number(row.lastChild.innerText)]));
  await rows.last().click();
  const shown = await page.evaluate(() => window.nugget.panels.map((panel) => panel.mode));
  assert.deepEqual(shown, measured.pairs.at(-1).slice(0, 2), "a click shows both modes");
  await turnBoth();
}

try {
  await { impact, damage, modes, responses, without_webgl: withoutWebgl, compare, compare_modes: compareModes }[kind]();
  if (picture) {
    await page.waitForTimeout(1500); // until the page has scrolled to what a link named
    await page.screenshot({ path: picture });
  }
  await page.setViewportSize({ width: 390, height: 800 });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(wide <= 1, `on a narrow screen nothing reaches beyond the side (${wide} pixels)`);
  assert.deepEqual(complaints, []);
  console.log(JSON.stringify(measured));
} catch (error) {
  console.error(error.message, complaints.join("\n"));
  process.exitCode = 1;
} finally {
  await closeBrowser();
}
