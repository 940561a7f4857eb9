// SPDX-License-Identifier: Apache-2.0
// Makes the page of a run alive: the tables that are there get sorting, filters and CSV; the packed data become a view,
// histories, responses. Without this script, and without a browser that draws, the page keeps what it says.
import { uPlotStyle } from "./charts.js";
import { compareRuns } from "./compare.js";
import { element } from "./format.js";
import { Histories, historyBrowser } from "./histories.js";
import { drawsModels } from "./model_view.js";
import { unpack } from "./packed_arrays.js";
import { responseBrowser } from "./responses.js";
import { Shape } from "./shape.js";
import style from "./style.css";
import { enhance } from "./tables.js";
import { ViewPanel } from "./view_panel.js";
import { weldPanel } from "./weld_panel.js";
import { readWelds } from "./welds.js";

const section = (id) => document.getElementById(id);

/** The words behind # as pairs: #weld=50002&time=0.004. */
function readLink() {
  return new URLSearchParams(location.hash.slice(1));
}

function writeLink(changes) {
  const link = readLink();
  for (const [key, value] of Object.entries(changes)) {
    if (value === null) link.delete(key);
    else link.set(key, value);
  }
  history.replaceState(null, "", `#${link}`);
}

/** Rows of weld tables lead to the weld. */
function linkRows(select) {
  for (const row of document.querySelectorAll("tr.weld")) {
    const id = row.dataset.weld ?? row.cells[0].textContent.trim();
    row.dataset.weld = id;
    row.tabIndex = 0;
    row.addEventListener("click", () => select(id, true));
    row.addEventListener("keydown", (event) => event.key === "Enter" && select(id, true));
  }
}

/** Without WebGL the pictures that stand in the page for browsers without scripts. */
function showPictures(place) {
  const pictures = element("div", { id: "pictures" });
  pictures.innerHTML = document.querySelector("noscript")?.textContent ?? "";
  place.append(pictures, element("p", { class: "quiet" }, "This browser draws no WebGL: these are pictures of the end; nugget picture draws others."));
}

async function start() {
  const { about, arrays } = await unpack(section("run-data").textContent);
  const units = about.units ?? {};
  const shape = about.view?.times ? new Shape(about.view, arrays) : null;
  const welds = readWelds(about.welds, shape);
  const histories = new Histories(about.histories, arrays, about.second ?? null);
  const shares = (id, mode) => {
    const i = about.shares?.ids.indexOf(id) ?? -1;
    return i < 0 ? 0 : arrays.shares[i * about.shares.modes + mode];
  };
  let panel = null, browser = null, weldShown = null, mode = null;
  const currentTime = () => panel?.time ?? null;

  const showWeld = () => {
    if (!weldShown) return;
    const share = about.shares && mode !== null ? `${(100 * shares(weldShown.id, mode)).toFixed(2)} % of mode ${mode + 1}` : null;
    weldPanel(section("weld-panel"), weldShown, {
      histories, units, currentTime, shares: share,
      titleOfPart: (id) => shape?.parts.find((part) => String(part.id) === id)?.title ?? "",
    });
  };
  const select = (id, move) => {
    weldShown = welds.find((weld) => weld.id === String(id)) ?? null;
    for (const row of document.querySelectorAll("tr.weld")) row.classList.toggle("chosen", row.dataset.weld === String(id));
    showWeld();
    section("weld-panel").hidden = !weldShown;
    writeLink({ weld: weldShown ? weldShown.id : null });
    if (!panel) return;
    panel.view.selectedWeld = weldShown;
    panel.view.show();
    if (move && weldShown) {
      panel.view.goTo(weldShown);
      section("view").scrollIntoView({ behavior: "smooth", block: "nearest" });
    }
  };

  if (about.view?.note) section("view").append(element("p", { class: "quiet", id: "view-note" }, about.view.note));
  if (shape && !drawsModels()) showPictures(section("view"));
  if (shape && drawsModels()) {
    panel = new ViewPanel(section("view"), shape, welds, {
      units, modes: about.view.modes,
      onweld: (weld) => select(weld.id, false),
      onplace: (time, shownMode) => {
        mode = shownMode ?? null;
        browser?.redraw();
        if (mode !== null) showWeld();
      },
    });
    section("view").dataset.ready = "yes";
    const failureOf = new Map(welds.map((weld) => [weld, histories.find("swforc", weld.entity, "failure")]));
    const largest = () => Math.max(1e-12, ...welds.map((w) => shares(w.id, mode)));
    let top = [-1, 0];
    panel.view.weldValue = (weld) => {
      if (about.view.modes) {
        if (top[0] !== mode) top = [mode, largest()];
        return Math.max(1e-9, shares(weld.id, mode ?? 0) / top[1]);
      }
      const time = panel?.time ?? Infinity;
      if (weld.failureTime <= time) return 1;
      const curve = failureOf.get(weld);
      return Math.min(0.9999, curve ? Histories.at(curve, time) : weld.peak);
    };
    panel.view.show();
  }
  linkRows(select);
  for (const [id, name] of [["welds", "welds"], ["modes", "modes"], ["weld-ranking", "weld-energies"]])
    if (section(id)) enhance(section(id), name);
  for (const row of document.querySelectorAll("tr.mode"))
    row.addEventListener("click", () => panel?.showMode(about.view.shown.indexOf(Number(row.cells[0].textContent) - 1)));
  if (about.responses) responseBrowser(section("responses"), about.responses, arrays, units.frequency);
  if (section("histories")) browser = historyBrowser(section("histories"), histories, units.time, currentTime);
  for (const note of about.notes ?? []) section("histories")?.append(element("p", { class: "quiet" }, note));

  const follow = () => {
    const link = readLink();
    if (link.has("weld")) select(link.get("weld"), true);
    if (panel && link.has("time")) panel.showTime(Number(link.get("time")));
    if (panel?.modes && link.has("mode")) panel.showMode(about.view.shown.indexOf(Number(link.get("mode")) - 1));
  };
  window.addEventListener("hashchange", follow);
  follow();
  document.body.classList.add("alive");
  window.nugget = { panel, welds, histories }; // for scripts and tests
}

document.head.append(element("style", {}, uPlotStyle + style));
(section("run-data-b") ? compareRuns() : start()).catch((error) => {
  (section("view") ?? section("views"))?.append(element("p", { class: "quiet" }, `The view cannot be shown here: ${error.message}`));
  throw error;
});
