// SPDX-License-Identifier: Apache-2.0
// Two runs side by side: one camera, one time, one range of colours; histories over each other; modes paired by shape.
import { element, number } from "./format.js";
import { Histories, historyBrowser } from "./histories.js";
import { drawsModels } from "./model_view.js";
import { unpack } from "./packed_arrays.js";
import { Shape } from "./shape.js";
import { enhance } from "./tables.js";
import { ViewPanel } from "./view_panel.js";
import { readWelds } from "./welds.js";

async function readRun(id) {
  const { about, arrays } = await unpack(document.getElementById(id).textContent);
  const shape = about.view?.times ? new Shape(about.view, arrays) : null;
  return { about, shape, welds: readWelds(about.welds, shape), histories: new Histories(about.histories, arrays, about.second ?? null) };
}

/** Displacements of a mode at the nodes that both models have. */
function shapeAt(shape, mode, nodes) {
  const u = new Float64Array(3 * nodes.length), x = shape.x[mode];
  nodes.forEach((id, i) => {
    const n = 3 * shape.indexOfNode.get(id);
    for (let k = 0; k < 3; ++k) u[3 * i + k] = x[n + k] - shape.first[n + k];
  });
  return u;
}

const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);

/** Each mode of A with the mode of B that is most like it: modal assurance criterion of the displacements, without masses. */
export function pairModes(a, b) {
  const nodes = Array.from(a.nodeIds).filter((id) => b.indexOfNode.has(id));
  const ofA = a.x.map((_, i) => shapeAt(a, i, nodes)), ofB = b.x.map((_, i) => shapeAt(b, i, nodes));
  return ofA.map((u, i) => {
    const mac = ofB.map((v) => dot(u, v) ** 2 / (dot(u, u) * dot(v, v) || 1));
    const best = mac.indexOf(Math.max(...mac));
    return { i, best, mac: mac[best] };
  });
}

function modeTable(a, b) {
  const [ofA, ofB] = [a, b].map((run) => (run.about.units?.frequency ? `frequency [${run.about.units.frequency}]` : "frequency"));
  const head = element("tr", {}, ...["mode of A", ofA, "mode of B", ofB, "difference", "MAC"].map((t) => element("th", {}, t)));
  const rows = pairModes(a.shape, b.shape).map(({ i, best, mac }) => {
    const [f, g] = [a.shape.times[i], b.shape.times[best]];
    const cells = [a.about.view.shown[i] + 1, number(f), b.about.view.shown[best] + 1, number(g), f ? `${((100 * (g - f)) / f).toFixed(2)} %` : "", mac.toFixed(3)];
    return element("tr", { class: "mode pair", "data-a": i, "data-b": best }, ...cells.map((c) => element("td", {}, String(c))));
  });
  return element("table", { id: "pairs" }, head, ...rows);
}

/** Camera, time, colours of one view are those of the other. */
function link(a, b) {
  let busy = false;
  const once = (act) => {
    if (busy) return;
    busy = true;
    act();
    busy = false;
  };
  for (const [from, to] of [[a, b], [b, a]]) {
    from.view.controls.addEventListener("change", () => once(() => to.view.cameraAs(from.view)));
    from.followers.push(() => once(() => {
      if (!from.modes) to.showTime(from.time);
    }));
  }
  a.colourFollowers.push((what, range) => b.colourBy(what, range));
}

export async function compareRuns() {
  const [a, b] = [await readRun("run-data"), await readRun("run-data-b")];
  const place = document.getElementById("views"), units = a.about.units ?? {};
  let panels = null;
  if (a.shape && b.shape && drawsModels()) {
    const sides = ["A", "B"].map((name) => element("div", { class: `side side-${name}` }, element("b", {}, name)));
    place.append(element("div", { class: "sides" }, ...sides));
    panels = [a, b].map((run, i) => new ViewPanel(sides[i], run.shape, run.welds, { units, modes: run.about.view.modes, onweld: () => {}, onplace: () => {} }));
    panels.forEach((panel, i) => {
      const run = [a, b][i], failure = new Map(run.welds.map((w) => [w, run.histories.find("swforc", w.entity, "failure")]));
      panel.view.weldValue = (weld) => {
        if (weld.failureTime <= (panel.time ?? Infinity)) return 1;
        const curve = failure.get(weld);
        return Math.min(0.9999, curve ? Histories.at(curve, panel.time) : weld.peak);
      };
    });
    link(...panels);
    panels[0].colourBy(panels[0].colourList.value);
    panels[1].view.cameraAs(panels[0].view);
  } else {
    const notes = [a, b].map((run) => run.about.view?.note).filter(Boolean);
    if (!drawsModels()) notes.push("This browser draws no WebGL: the models are not shown.");
    place.append(element("p", { class: "quiet" }, notes.join(" ")));
  }
  if (panels?.[0].modes && panels[1].modes) {
    const table = modeTable(a, b);
    document.getElementById("mode-pairs").append(table);
    for (const row of table.querySelectorAll(".pair"))
      row.addEventListener("click", () => (panels[0].showMode(Number(row.dataset.a)), panels[1].showMode(Number(row.dataset.b))));
  }
  for (const id of ["welds", "numbers", "pairs"]) if (document.getElementById(id)) enhance(document.getElementById(id), id);
  const histories = document.getElementById("histories");
  if (histories) {
    const browser = historyBrowser(histories, a.histories, units.time, () => panels?.[0].time ?? null, b.histories);
    panels?.[0].followers.push(() => browser?.redraw());
  }
  document.body.classList.add("alive");
  window.nugget = { panels, a, b };
}
