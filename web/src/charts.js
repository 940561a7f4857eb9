// SPDX-License-Identifier: Apache-2.0
import uPlot from "uplot";
import uPlotStyle from "uplot/dist/uPlot.min.css";
import { element, number } from "./format.js";
import { logTicks } from "./ticks.js";

export { uPlotStyle };
const COLOURS = ["#1f77b4", "#d9541e", "#2e9950", "#8552b5", "#c22f6f", "#7d6a3a", "#0f9aa8", "#8a8f98"];
const inkOf = (parent) => getComputedStyle(parent).color;

/** Curves with abscissas of their own on the abscissas of all: uPlot wants one column of x. */
function joined(curves) {
  const same = curves.every((c) => c.x.length === curves[0].x.length && c.x[0] === curves[0].x[0] && c.x.at(-1) === curves[0].x.at(-1));
  if (same) return [Array.from(curves[0].x), ...curves.map((c) => Array.from(c.y, finite))];
  return uPlot.join(curves.map((c) => [Array.from(c.x), Array.from(c.y, finite)]));
}
const finite = (value) => (Number.isFinite(value) ? value : null);

/** A mark at each of `marks` [x]: vertical lines. */
function marksPlugin(marks, colour) {
  return {
    hooks: {
      draw: (plot) => {
        const { ctx, bbox } = plot;
        ctx.save();
        ctx.strokeStyle = colour;
        ctx.setLineDash([4, 4]);
        for (const x of marks()) {
          const place = plot.valToPos(x, "x", true);
          if (place < bbox.left || place > bbox.left + bbox.width) continue;
          ctx.beginPath();
          ctx.moveTo(place, bbox.top);
          ctx.lineTo(place, bbox.top + bbox.height);
          ctx.stroke();
        }
        ctx.restore();
      },
    },
  };
}

/**
 * A plot of `curves` [{name, x, y}] in `parent`, which it fills in width; drag zooms, a double click shows all. Options:
 * xTitle, yTitle, logX, logY, height, sync (cursors of plots of one name move together), marks (function: x of dashed lines).
 */
export function chart(parent, curves, options = {}) {
  const ink = inkOf(parent), grid = { stroke: ink + "", width: 0.15 };
  const positive = (curve) => (options.logY ? { ...curve, y: Array.from(curve.y, (v) => (v > 0 ? v : NaN)) } : curve);
  const axis = (label) => ({
    stroke: ink, label, labelSize: 18, grid, ticks: grid, labelFont: "12px system-ui", font: "11px system-ui",
    values: (_, values) => values.map((v) => (v === null ? "" : number(v))),
  });
  // uPlot's own marks of a log axis want it to begin at a round number.
  const xTicks = options.logX ? { splits: (_, index, low, high) => logTicks(low, high), filter: (_, ticks) => ticks } : {};
  const plot = new uPlot(
    {
      width: Math.max(240, parent.clientWidth), height: options.height ?? 240,
      // On a log axis uPlot rounds to whole decades; here the abscissas end where the curves end, unless they begin at 0.
      scales: { x: { time: false, distr: options.logX ? 3 : 1, range: (_, low, high) => (options.logX && low <= 0 ? uPlot.rangeLog(low, high, 10, false) : [low, high]) }, y: { distr: options.logY ? 3 : 1 } },
      axes: [{ ...axis(options.xTitle ?? ""), ...xTicks }, { ...axis(options.yTitle ?? ""), size: 66 }],
      series: [
        { label: options.xName ?? "time", value: (_, v) => (v === null ? "–" : number(v)) },
        ...curves.map((c, i) => ({
          label: c.name, stroke: c.colour ?? COLOURS[i % COLOURS.length], width: 1.5, spanGaps: true,
          points: { show: c.x.length < 3 }, value: (_, v) => (v === null ? "–" : number(v)),
        })),
      ],
      cursor: { sync: options.sync ? { key: options.sync } : undefined, drag: { x: true, y: true, uni: 30 } },
      legend: { live: true },
      plugins: options.marks ? [marksPlugin(options.marks, ink)] : [],
    },
    joined(curves.map(positive)),
    parent,
  );
  new ResizeObserver(() => {
    const width = Math.max(240, parent.clientWidth);
    if (width !== plot.width) plot.setSize({ width, height: plot.height });
  }).observe(parent);
  return plot;
}

/** The largest value by size, and where. */
export function peak(curve) {
  let best = -1;
  for (let i = 0; i < curve.y.length; ++i)
    if (Number.isFinite(curve.y[i]) && (best < 0 || Math.abs(curve.y[i]) > Math.abs(curve.y[best]))) best = i;
  return best < 0 ? null : { x: curve.x[best], y: curve.y[best] };
}

/** Local maxima above 2 % of the largest, highest first. */
export function peaks(curve, most = 12) {
  const y = curve.y, found = [];
  for (let i = 1; i + 1 < y.length; ++i) if (y[i] > y[i - 1] && y[i] >= y[i + 1]) found.push({ x: curve.x[i], y: y[i] });
  found.sort((a, b) => b.y - a.y);
  return found.filter((p) => p.y > 0.02 * found[0].y).slice(0, most);
}

export const empty = (words) => element("p", { class: "quiet" }, words);
