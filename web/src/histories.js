// SPDX-License-Identifier: Apache-2.0
import { chart, empty, peak } from "./charts.js";
import { difference } from "./difference.js";
import { csv, element, number, save, withUnit } from "./format.js";
import { CLASSES, filtered } from "./sae_filter.js";

/** The channels of all history files: `find(file, entity, quantity)` gives {name, unit, x, y}. */
export class Histories {
  constructor(about, arrays, second) {
    this.second = second; // units of time in one second; null where the units are not known
    this.files = (about ?? []).map((file) => ({
      ...file, values: arrays[file.array],
      channels: file.channels.map(([entity, title, quantity, unit]) => ({ entity, title, quantity, unit: unit.trim() })),
    }));
    this.timeUnit = "";
  }

  channel(file, index) {
    const { times: count, values, channels, file: name } = file, { entity, quantity, unit } = channels[index];
    return {
      file: name, entity, quantity, unit, name: [name, entity, quantity].filter(Boolean).join(" "),
      x: values.subarray(0, count), y: values.subarray((index + 1) * count, (index + 2) * count),
    };
  }

  find(fileName, entity, quantity) {
    const file = this.files.find((f) => f.file === fileName);
    const index = file?.channels.findIndex((c) => c.entity === entity && c.quantity === quantity) ?? -1;
    return index < 0 ? null : this.channel(file, index);
  }

  /** Value at a time: that of the last sample up to it. */
  static at(channel, time) {
    let low = 0, high = channel.x.length - 1;
    if (high < 0 || time < channel.x[0]) return 0;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (channel.x[middle] <= time) low = middle;
      else high = middle - 1;
    }
    return channel.y[low];
  }
}

const option = (value, words = value) => element("option", { value }, words);

/** A channel of this run; beside it, where there is another run, that of the other one and the difference. */
function withOther(channel, other) {
  if (!other) return [channel];
  const theirs = other.find(channel.file, channel.entity, channel.quantity), ours = { ...channel, name: `A ${channel.name}` };
  if (!theirs || theirs.x.length < 2) return [ours];
  return [ours, { ...theirs, name: `B ${theirs.name}` }, difference(channel, theirs)];
}

/** Choose channels of any file, lay them over each other, filter, zoom, save. */
export function historyBrowser(parent, histories, timeUnit, currentTime, other = null) {
  if (histories.files.length === 0) {
    parent.append(empty("This run left no histories: *DATABASE_ cards ask for them."));
    return null;
  }
  const fileList = element("select", { "aria-label": "file" }, ...histories.files.map((f) => option(f.file)));
  const entityList = element("select", { "aria-label": "entity" });
  const quantityList = element("select", { "aria-label": "quantity", multiple: true, size: 6 });
  const filterList = element("select", { "aria-label": "filter" }, option("", "no filter"), ...CLASSES.map((c) => option(c, `CFC ${c}`)));
  const keep = element("input", { type: "checkbox", id: "overlay" });
  const plotPlace = element("div", { class: "plot" }), words = element("p", { class: "quiet" });
  let shown = [], plot = null;
  const file = () => histories.files.find((f) => f.file === fileList.value);
  const fillEntities = () => {
    const titles = new Map(file().channels.map((c) => [c.entity, c.title]));
    entityList.replaceChildren(...[...titles].map(([e, title]) => option(e, [e || "whole model", title].filter(Boolean).join(": "))));
    fillQuantities();
  };
  const fillQuantities = () => {
    const before = [...quantityList.selectedOptions].map((o) => o.value);
    const names = file().channels.filter((c) => c.entity === entityList.value).map((c) => c.quantity);
    quantityList.replaceChildren(...names.map((n) => option(n)));
    const wanted = before.filter((n) => names.includes(n));
    for (const o of quantityList.options) o.selected = wanted.length ? wanted.includes(o.value) : o.index === 0;
  };
  const curves = () => {
    const channelClass = Number(filterList.value);
    return shown.map((c) => {
      if (!channelClass) return c;
      const result = filtered(Array.from(c.x), Array.from(c.y), channelClass, histories.second ?? 1);
      if (result.error) {
        words.textContent = `${c.name}: ${result.error}.`;
        return c;
      }
      return { ...c, name: `${c.name} CFC ${channelClass}`, x: result.times, y: result.values };
    });
  };
  const draw = () => {
    plot?.destroy();
    plot = null;
    words.textContent = "";
    if (shown.length === 0) return;
    const all = curves(), units = [...new Set(all.map((c) => c.unit).filter(Boolean))];
    const note = words.textContent;
    plot = chart(plotPlace, all, {
      height: 300, xTitle: timeUnit ? `time [${timeUnit}]` : "time", yTitle: units.length === 1 ? `[${units[0]}]` : "",
      marks: () => [currentTime()].filter((t) => t !== null),
    });
    const told = all.map((c) => {
      const p = peak(c);
      return p ? `${c.name}: peak ${withUnit(p.y, c.unit)} at ${withUnit(p.x, timeUnit)}` : c.name;
    });
    words.textContent = [note, ...told].filter(Boolean).join(" · ");
  };
  const choose = () => {
    const chosen = [...quantityList.selectedOptions].flatMap((o) =>
      withOther(histories.find(fileList.value, entityList.value, o.value), other));
    shown = keep.checked ? [...shown, ...chosen.filter((c) => !shown.some((s) => s.name === c.name))] : chosen;
    draw();
  };
  fileList.addEventListener("change", () => (fillEntities(), choose()));
  entityList.addEventListener("change", () => (fillQuantities(), choose()));
  quantityList.addEventListener("change", choose);
  filterList.addEventListener("change", draw);
  const saveCsv = () => {
    const all = curves();
    const rows = [["channel", "unit", "time", "value"]];
    for (const c of all) for (let i = 0; i < c.x.length; ++i) rows.push([c.name, c.unit, number(c.x[i]), c.y[i]]);
    save("histories.csv", csv(rows));
  };
  parent.append(
    element("div", { class: "channels" },
      element("label", {}, "file ", fileList), element("label", {}, "of ", entityList), quantityList,
      element("div", { class: "stack" },
        filterList, element("label", { for: "overlay" }, keep, " keep curves"),
        element("button", { onclick: () => ((shown = []), draw()) }, "clear"), element("button", { onclick: saveCsv }, "save as CSV"))),
    plotPlace, words,
    element("p", { class: "quiet" }, "Drag to zoom, double click for all. ",
      histories.second ? "" : "The units are not known: filters take the time to be in seconds."));
  fileList.value = (histories.files.find((f) => f.file === "glstat") ?? histories.files[0]).file;
  fillEntities();
  if (fileList.value === "glstat")
    for (const o of quantityList.options) o.selected = (other ? ["internal_energy"] : ["kinetic_energy", "internal_energy", "total_energy"]).includes(o.value);
  choose();
  return { redraw: () => plot?.redraw(false) };
}
