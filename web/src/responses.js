// SPDX-License-Identifier: Apache-2.0
import { chart, peaks } from "./charts.js";
import { element, number, withUnit } from "./format.js";

const TITLES = { frf: "Frequency response", ssd: "Steady state", erp: "Equivalent radiated power" };

/** Amplitude and phase over frequency of chosen responses, their peaks marked and listed. */
export function responseBrowser(parent, responses, arrays, unit) {
  const curves = responses.map((r) => {
    const n = arrays[r.array].length / 3, part = (k) => arrays[r.array].subarray(k * n, (k + 1) * n);
    return { ...r, unit: r.unit.trim(), label: `${TITLES[r.kind]}: ${r.name}, ${r.quantity}`, x: part(0), amplitude: part(1), phase: part(2) };
  });
  const list = element("select", { multiple: true, size: Math.min(8, Math.max(3, curves.length)), "aria-label": "responses" },
    ...curves.map((c, i) => element("option", { value: i, selected: i === 0 }, c.label)));
  const linear = element("input", { type: "checkbox" });
  const place = element("div", { class: "plot" }), words = element("p", { class: "quiet" });
  let plots = [];
  const draw = () => {
    plots.forEach((p) => p.destroy());
    const shown = [...list.selectedOptions].map((o) => curves[o.value]);
    if (shown.length === 0) return;
    const found = peaks({ x: shown[0].x, y: shown[0].amplitude });
    const options = {
      logX: !linear.checked, sync: "response", xName: "frequency", xTitle: unit ? `frequency [${unit}]` : "frequency", marks: () => found.slice(0, 6).map((p) => p.x),
    };
    plots = [chart(place, shown.map((c) => ({ name: c.label, x: c.x, y: c.amplitude })),
      { ...options, logY: !linear.checked, height: 280, yTitle: shown[0].unit ? `${shown[0].quantity} [${shown[0].unit}]` : shown[0].quantity })];
    if (shown.some((c) => c.phase.some(Number.isFinite)))
      plots.push(chart(place, shown.map((c) => ({ name: c.label, x: c.x, y: c.phase })), { ...options, height: 170, yTitle: "phase [degree]" }));
    words.textContent = found.length ? `Peaks of ${shown[0].label}: ${found.map((p) => `${withUnit(p.y, shown[0].unit)} at ${withUnit(p.x, unit)}`).join(", ")}` : "";
  };
  list.addEventListener("change", draw);
  linear.addEventListener("change", draw);
  parent.append(element("div", { class: "channels" }, list, element("label", {}, linear, " linear axes")), place, words);
  draw();
}
