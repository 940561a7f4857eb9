// SPDX-License-Identifier: Apache-2.0
// Channel frequency classes of SAE J211-1 (ISO 6487).

export const CLASSES = [60, 180, 600, 1000];
const CORNER = 2.0775; // of the Butterworth filter run both ways, over the class (J211-1, appendix C)

/** The signal at as many times, evenly spaced, on straight lines between its samples; null where times do not ascend. */
function evenly(times, values) {
  const count = times.length, step = (times[count - 1] - times[0]) / (count - 1);
  const even = { times: [], values: [] };
  if (times.some((t, i) => i > 0 && !(t > times[i - 1]))) return null;
  for (let i = 0, k = 0; i < count; ++i) {
    const t = Math.min(times[0] + i * step, times[count - 1]);
    while (k < count - 2 && times[k + 1] < t) ++k;
    const share = (t - times[k]) / (times[k + 1] - times[k]);
    even.times.push(t);
    even.values.push(values[k] + share * (values[k + 1] - values[k]));
  }
  return even;
}

/** One way; the signal was `before` until its start. */
function once(values, before, a, b) {
  let x1 = before, x2 = before, y1 = before, y2 = before;
  return values.map((x) => {
    const y = a[0] * x + a[1] * x1 + a[2] * x2 + b[0] * y1 + b[1] * y2;
    [x2, x1, y2, y1] = [x1, x, y1, y];
    return y;
  });
}

/**
 * Second-order Butterworth filter run forwards and backwards, so that no phase is shifted: `{times, values}` evenly spaced,
 * or `{error}`. Nothing acted before the first time. `second` is one second in the unit of the times.
 */
export function filtered(times, values, channelClass, second) {
  if (times.length < 3) return { error: "too few samples to filter" };
  const even = evenly(times, values);
  if (!even) return { error: "times do not ascend" };
  const step = (even.times[1] - even.times[0]) / second;
  if (channelClass * CORNER * step >= 0.5)
    return { error: `CFC ${channelClass} needs samples closer than ${(0.5 / (channelClass * CORNER)).toPrecision(3)} s` };
  const w = Math.tan(Math.PI * CORNER * channelClass * step), c = 1 + Math.SQRT2 * w + w * w;
  const a = [(w * w) / c, (2 * w * w) / c, (w * w) / c];
  const b = [(-2 * (w * w - 1)) / c, (-1 + Math.SQRT2 * w - w * w) / c];
  const forth = once(even.values, 0, a, b);
  const back = once(forth.reverse(), forth[0], a, b);
  return { times: even.times, values: back.reverse() };
}
