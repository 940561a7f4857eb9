// SPDX-License-Identifier: Apache-2.0

// From the grey of a sheet that nothing happened to, over blue, green and yellow, to red.
const STOPS = [[205, 211, 217], [110, 156, 196], [70, 170, 150], [150, 200, 90], [250, 205, 70], [236, 120, 50], [190, 30, 45]];

/** Colour of a share from 0 to 1. */
export function ramp(share) {
  const place = Math.min(Math.max(share, 0), 1) * (STOPS.length - 1);
  const i = Math.min(Math.floor(place), STOPS.length - 2);
  return STOPS[i].map((low, k) => Math.round(low + (place - i) * (STOPS[i + 1][k] - low)));
}

export const css = ([r, g, b]) => `rgb(${r},${g},${b})`;
export const rampGradient = `linear-gradient(to right, ${STOPS.map(css).join(",")})`;

/** Parts side by side are told apart by hues a golden angle from each other. */
export function ofPart(index) {
  const hue = (210 + 137.508 * index) % 360, c = 0.32, l = 0.68;
  const channel = (n) => {
    const k = (n + hue / 30) % 12;
    return Math.round(255 * (l - c * Math.min(l, 1 - l) * 1.6 * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [channel(0), channel(8), channel(4)].map((v) => Math.min(255, Math.max(0, v)));
}

// Failure values: safe, near, failed. As the words in the tables of the page.
export const FAILED = [198, 40, 40], NEAR = [230, 145, 0], SAFE = [46, 125, 50], PLAIN = [110, 120, 135];

/** Colour of a weld by its failure value; 1 is failure. */
export function ofFailure(value) {
  if (!(value > 0)) return PLAIN;
  if (value >= 1) return FAILED;
  const [low, high, share] = value < 0.8 ? [SAFE, NEAR, value / 0.8] : [NEAR, FAILED, (value - 0.8) / 0.2];
  return low.map((c, k) => Math.round(c + (value < 0.8 ? share ** 3 : share * 0.6) * (high[k] - c)));
}
