// SPDX-License-Identifier: Apache-2.0
import { chart, empty } from "./charts.js";
import { element, number, withUnit } from "./format.js";

const CURVES = [
  ["force", ["axial", "shear", "resultant_force"]], ["moment", ["resultant_moment", "torsion"]], ["failure value", ["failure"]],
];

/** Everything about one weld: what became of it, where it is tied, its histories. */
export function weldPanel(parent, weld, { histories, units, currentTime, shares, titleOfPart }) {
  const row = (name, ...value) => element("div", {}, element("dt", {}, name), element("dd", {}, ...value));
  const c = weld.cells, has = (name) => c[name] !== undefined && c[name] !== "";
  const rows = [row("verdict", element("b", { class: weld.kindOfVerdict }, weld.verdict))];
  const add = (name, column, unit) => has(column) && rows.push(row(name, unit === undefined ? c[column] : withUnit(Number(c[column]), unit)));
  const sheets = [c.sheet1, ...(c.sheet2 ?? "").split(" ")].filter(Boolean).map((id) => `${id} ${titleOfPart(id)}`.trim());
  rows.push(row("sheets", sheets.join(" + ") || "–"));
  add("diameter", "diameter", units.length);
  add("length", "length", units.length);
  if (has("x")) rows.push(row("place", `${number(+c.x)}, ${number(+c.y)}, ${number(+c.z)} ${units.length ?? ""}`));
  for (const i of [1, 2])
    if (has(`node${i}`)) rows.push(row(`end ${i}`, `node ${c[`node${i}`]}, case ${c[`case${i}`]}, moved ${withUnit(+c[`moved${i}`], units.length)}: ${c[`reason${i}`]}`));
  add("peak axial force", "peak_axial", units.force);
  add("peak shear force", "peak_shear", units.force);
  add("peak bending moment", "peak_bending", units.moment);
  add("peak torsion", "peak_torsion", units.moment);
  if (has("peak_failure")) rows.push(row("largest failure value", `${number(+c.peak_failure)} at ${withUnit(+c.peak_failure_time, units.time)}`));
  if (+c.peak_failure > 0 && c.failed !== "yes") rows.push(row("margin", `loads times ${number(1 / +c.peak_failure)} to failure, if all grow alike`));
  add("terms at the end", "last_terms");
  add("damage", "damage");
  add("energy", "energy", units.energy);
  add("finding", "remarks");
  if (shares) rows.push(row("strain energy", shares));
  const plots = element("div", { class: "small-plots" });
  parent.replaceChildren(element("h3", {}, `Weld ${weld.id} `, element("small", {}, c.kind)), element("dl", {}, ...rows), plots);
  let any = false;
  for (const [title, quantities] of CURVES) {
    const curves = quantities.map((q) => histories.find("swforc", weld.entity, q)).filter((curve) => curve?.y.some((v) => v !== 0));
    if (curves.length === 0) continue;
    any = true;
    const place = element("div");
    plots.append(place);
    chart(place, curves.map((curve) => ({ ...curve, name: curve.quantity.replaceAll("_", " ") })), {
      height: 170, xTitle: units.time ? `time [${units.time}]` : "time",
      yTitle: curves[0].unit ? `${title} [${curves[0].unit}]` : title, sync: "weld",
      marks: () => [currentTime()].filter((t) => t !== null),
    });
  }
  if (!any && histories.files.length > 0) plots.append(empty("No histories of this weld: *DATABASE_SWFORC asks for them."));
}
