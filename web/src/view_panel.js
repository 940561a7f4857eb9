// SPDX-License-Identifier: Apache-2.0
import { element, number, withUnit } from "./format.js";
import { FAILED, NEAR, PLAIN, SAFE, css, ofPart, rampGradient } from "./colours.js";
import { ModelView, NO_VALUE, VIEWS } from "./model_view.js";

const PLAY_SECONDS = 4; // for all states
const DAMAGE = "damage"; // the field that welds have too

/** The three-dimensional view with its controls. `onplace(time)` is told when another state is shown. */
export class ViewPanel {
  constructor(parent, shape, welds, { units, onweld, onplace, modes }) {
    this.shape = shape;
    this.units = units;
    this.modes = modes;
    this.onplace = onplace;
    this.onweld = onweld;
    this.followers = []; // called when another state is shown
    this.colourFollowers = []; // called with what colours the view, and its range
    const canvas = element("div", { class: "canvas", tabindex: 0, role: "img", "aria-label": "model in three dimensions" });
    this.readout = element("div", { class: "readout", "aria-live": "polite" });
    this.legend = element("div", { class: "legend-3d" });
    canvas.append(this.readout, this.legend);
    parent.append(canvas);
    this.#addDamageOfWelds(welds);
    this.view = new ModelView(canvas, shape, welds, (hit) => this.#picked(hit));
    parent.append(this.#stateBar(), this.#toolBar());
    canvas.addEventListener("keydown", (event) => this.#key(event));
    if (modes) this.mode = this.#firstElasticMode();
    this.colourBy(modes ? "displacement" : this.shape.fields[0]?.name ?? "part");
    if (modes) this.showMode(this.mode);
    else this.showPlace(shape.states - 1);
  }

  // ---- controls

  #stateBar() {
    this.slider = element("input", {
      type: "range", min: 0, max: Math.max(1, this.shape.states - 1), step: this.modes ? 1 : "any", "aria-label": this.modes ? "mode" : "time",
    });
    this.slider.addEventListener("input", () => {
      if (this.modes) this.showMode(Number(this.slider.value));
      else this.showPlace(Number(this.slider.value));
    });
    this.playButton = element("button", { onclick: () => this.togglePlay(), id: "play", title: "space" }, "▶ play");
    this.when = element("output", { class: "when", id: "when" });
    const scale = element("input", { type: "number", value: 1, min: 0, step: "any", "aria-label": "scale of displacements" });
    this.scaleInput = scale;
    scale.addEventListener("input", () => {
      this.view.scale = Number(scale.value) || 0;
      this.amplitude = this.view.scale;
      this.view.show();
    });
    return element("div", { class: "controls" }, this.playButton, this.slider, this.when, element("label", {}, "scale ", scale));
  }

  #toolBar() {
    const colours = element("select", { "aria-label": "colour by", id: "colour-by" }, element("option", { value: "part" }, "parts"),
      ...this.shape.fields.map((f) => element("option", { value: f.name }, f.name)), element("option", { value: "displacement" }, "displacement"));
    colours.addEventListener("change", () => this.colourBy(colours.value));
    this.colourList = colours;
    this.view.edges = this.shape.facets < 100000;
    const edges = element("input", { type: "checkbox", checked: this.view.edges });
    edges.addEventListener("change", () => ((this.view.edges = edges.checked), this.view.show()));
    const axis = element("select", { "aria-label": "cut plane" }, ...["no cut", "x", "y", "z"].map((a) => element("option", { value: a }, a === "no cut" ? a : `cut ${a}`)));
    const where = element("input", { type: "range", min: 0, max: 1, step: 0.001, value: 0.5, "aria-label": "place of the cut", disabled: true });
    const cut = () => ((where.disabled = axis.value === "no cut"), this.view.setCut(axis.value, Number(where.value)));
    axis.addEventListener("change", cut);
    where.addEventListener("input", cut);
    const views = Object.keys(VIEWS).map((name) => element("button", { onclick: () => this.view.look(name) }, name));
    const partList = element("div", { class: "part-list" }, ...this.shape.parts.map((part, i) => this.#partSwitch(part, i)));
    return element("div", { class: "controls wrap" }, element("label", {}, "colour by ", colours), element("label", {}, edges, " edges"), axis, where,
      element("button", { onclick: () => this.view.fit(), title: "f" }, "fit"), ...views,
      element("button", { onclick: () => this.savePicture() }, "save picture"),
      element("details", { class: "parts" }, element("summary", {}, `${this.shape.parts.length} parts`), partList));
  }

  #partSwitch(part, i) {
    const box = element("input", { type: "checkbox", checked: true });
    box.addEventListener("change", () => {
      if (box.checked) this.view.hiddenParts.delete(i);
      else this.view.hiddenParts.add(i);
      this.view.show();
    });
    return element("label", {}, box, element("i", { style: `background:${css(ofPart(i))}` }), ` ${part.id} ${part.title}`);
  }

  #key(event) {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (step) this.modes ? this.showMode(this.mode + step) : this.showPlace(Math.round(this.view.place) + step);
    else if (event.key === " ") this.togglePlay();
    else if (event.key === "f") this.view.fit();
    else if (event.key === "e") ((this.view.edges = !this.view.edges), this.view.show());
    else return;
    event.preventDefault();
  }

  savePicture() {
    element("a", { href: this.view.picture(), download: "nugget.png" }).click();
  }

  // ---- what is shown

  /** "part", "displacement" or the name of a field; by parts where the model does not have it. */
  colourBy(what, range = null) {
    const field = this.shape.fields.find((f) => f.name === what);
    if (!field && what !== "displacement") what = "part";
    this.colourList.value = what;
    if (field) this.view.colouring = { kind: "field", field, low: field.low, high: this.#usualHigh(field), ...range };
    else if (what === "displacement") this.view.colouring = { kind: what, low: 0, high: this.#largestDisplacement(), ...range };
    else this.view.colouring = { kind: "part" };
    this.#drawLegend(field ?? { name: what, dimension: "length" });
    this.view.show();
    const { low, high } = this.view.colouring;
    for (const follow of this.colourFollowers) follow(what, low === undefined ? null : { low, high });
  }

  /** What all but a few facets stay below in the last state: one torn element does not take the colours from the others. */
  #usualHigh(field) {
    const last = Array.from(field.values.at(-1)).filter((v) => v !== NO_VALUE).sort((a, b) => a - b);
    const steps = last[Math.floor(0.995 * (last.length - 1))] || 254;
    return field.low + (steps / 254) * (field.high - field.low);
  }

  /** Elements may have no damage while welds do: then they are grey beside them. */
  #addDamageOfWelds(welds) {
    const { fields, times, facets } = this.shape;
    if (this.modes || fields.some((f) => f.name === DAMAGE) || !welds.some((weld) => weld.damage > 0)) return;
    fields.push({ name: DAMAGE, dimension: "", low: 0, high: 1, values: times.map(() => new Uint8Array(facets).fill(NO_VALUE)) });
  }

  #drawLegend({ name, dimension, low, high }) {
    const { kind } = this.view.colouring, unit = this.units[dimension];
    const weld = (colour, words) => element("span", {}, element("i", { style: `background:${css(colour)}` }), words);
    const welds = this.view.welds.length === 0 ? [] : [element("div", { class: "weld-legend" }, "welds: ", ...(this.modes
      ? [weld(SAFE, "little strain energy"), weld(FAILED, "most")]
      : name === DAMAGE ? ["as at the end of the run; 1: failed ", weld(PLAIN, "law without damage")]
      : [weld(SAFE, "holds"), weld(NEAR, "0.8"), weld(FAILED, "failed"), weld(PLAIN, "no value")]))];
    if (kind === "part") return this.legend.replaceChildren(...welds);
    const edit = (side) => {
      const input = element("input", { value: number(this.view.colouring[side]), "aria-label": `${side} end of the legend`, size: 8 });
      input.addEventListener("change", () => {
        if (!Number.isFinite(Number(input.value))) return;
        this.view.colouring = { ...this.view.colouring, [side]: Number(input.value) };
        this.view.show();
      });
      return input;
    };

    if (kind === "displacement" && this.modes) {
      const ends = element("div", { class: "ends" }, element("span", {}, "0"), element("span", {}, "largest"));
      return this.legend.replaceChildren(element("div", {}, name), element("div", { class: "ramp", style: `background:${rampGradient}` }), ends, ...welds);
    }
    this.legend.replaceChildren(element("div", {}, unit ? `${name} [${unit}]` : name), element("div", { class: "ramp", style: `background:${rampGradient}` }),
      element("div", { class: "ends" }, edit("low"), edit("high")),
      ...(kind === "field" ? [element("div", {}, `all states: ${number(low)} to ${number(high)}`)] : []), ...welds);
  }

  #largestDisplacement() {
    const { first, x } = this.shape;
    let largest = 0;
    for (const state of this.modes ? [x[this.mode ?? 0]] : x)
      for (let n = 0; n < first.length; n += 3)
        largest = Math.max(largest, Math.hypot(state[n] - first[n], state[n + 1] - first[n + 1], state[n + 2] - first[n + 2]));
    return largest;
  }

  /** A place between states, from 0. */
  showPlace(place) {
    this.view.place = Math.min(Math.max(place, 0), this.shape.states - 1);
    this.slider.value = this.view.place;
    this.time = this.#timeAt(this.view.place);
    this.when.value = `t = ${withUnit(this.time, this.units.time)}`;
    this.onplace(this.time);
    this.view.show();
    for (const follow of this.followers) follow();
  }

  showTime(time) {
    const { times } = this.shape;
    let i = 0;
    while (i + 2 < times.length && times[i + 1] <= time) ++i;
    this.showPlace(times.length > 1 ? i + (time - times[i]) / (times[i + 1] - times[i]) : 0);
  }

  #timeAt(place) {
    const { times } = this.shape, i = Math.min(Math.floor(place), times.length - 1), k = Math.min(i + 1, times.length - 1);
    return times[i] + (place - i) * (times[k] - times[i]);
  }

  #firstElasticMode() {
    const i = this.shape.times.findIndex((f) => f > 1e-3 * Math.max(...this.shape.times));
    return Math.max(0, i);
  }

  /** A mode, from 0, at its largest displacement. */
  showMode(mode) {
    this.mode = Math.min(Math.max(mode, 0), this.shape.states - 1);
    this.slider.value = this.mode;
    this.view.place = this.mode;
    this.time = null;
    this.amplitude ??= 1; // of 6 % of the model's diagonal (view.cpp)
    this.view.scale = this.amplitude;
    if (this.view.colouring.kind === "displacement") this.colourBy("displacement");
    this.when.value = `mode ${this.shape.about.shown[this.mode] + 1}: ${withUnit(this.shape.times[this.mode], this.units.frequency)}`;
    this.onplace(null, this.shape.about.shown[this.mode]);
    this.view.show();
  }

  togglePlay() {
    this.playing = !this.playing;
    this.playButton.textContent = this.playing ? "⏸ pause" : "▶ play";
    if (!this.playing) return;
    let last = performance.now(), phase = 0;
    if (!this.modes && this.view.place >= this.shape.states - 1) this.view.place = 0;
    const step = (now) => {
      if (!this.playing) return;
      const passed = Math.min(0.1, (now - last) / 1000);
      last = now;
      if (this.modes) {
        phase += 2 * Math.PI * passed;
        this.view.scale = this.amplitude * Math.cos(phase);
        this.view.show();
      } else {
        const next = this.view.place + (passed / PLAY_SECONDS) * (this.shape.states - 1);
        this.showPlace(next >= this.shape.states - 1 ? (next - passed < this.shape.states - 1 && this.view.place < this.shape.states - 1 ? this.shape.states - 1 : 0) : next);
      }
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  #picked(hit) {
    if (hit?.weld) return this.onweld(hit.weld);
    if (!hit) return (this.readout.textContent = "");
    const f = hit.facet, part = this.shape.parts[this.shape.facetParts[f]];
    const { kind, field } = this.view.colouring;
    const value = kind === "field" && field.values[this.view.state][f] !== NO_VALUE
      ? `, ${field.name} about ${withUnit(field.low + (field.values[this.view.state][f] / 254) * (field.high - field.low), this.units[field.dimension])}` : "";
    this.readout.textContent = `element ${this.shape.facetElements[f]}, part ${part.id} ${part.title}${value}`;
  }
}
