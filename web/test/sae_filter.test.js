// SPDX-License-Identifier: Apache-2.0
// The filter against SAE J211-1: -3 dB at 5/3 of the class, flat below, falling by 24 dB an octave; nothing before the start.
import assert from "node:assert/strict";
import { test } from "node:test";
import { filtered } from "../src/sae_filter.js";

/** Amplitude in the middle of a long sine of 1. */
function gain(channelClass, hertz, second = 1) {
  const step = 1 / (40 * Math.max(hertz, channelClass));
  const times = Array.from({ length: 8001 }, (_, i) => second * i * step);
  const { values } = filtered(times, times.map((t) => Math.sin((2 * Math.PI * hertz * t) / second)), channelClass, second);
  return Math.max(...values.slice(3000, 5000).map(Math.abs));
}

test("corridor of each class", () => {
  for (const [channelClass, corner] of [[60, 100], [180, 300], [600, 1000], [1000, 1650]]) {
    assert.ok(Math.abs(20 * Math.log10(gain(channelClass, corner)) + 3) < 0.5, `CFC ${channelClass}`);
    assert.ok(Math.abs(gain(channelClass, 0.1 * corner) - 1) < 0.01);
    const octave = 20 * Math.log10(gain(channelClass, 8 * corner) / gain(channelClass, 4 * corner));
    assert.ok(Math.abs(octave + 24) < 1.5);
  }
});

test("times in milliseconds", () => assert.ok(Math.abs(gain(180, 300, 1000) - gain(180, 300)) < 1e-9));

test("a blow in the first sample is no force that had long been there", () => {
  const times = Array.from({ length: 2001 }, (_, i) => i * 1e-5);
  const force = times.map((t) => (t < 0.012 ? 90 * Math.sin((Math.PI * t) / 0.012) : 0));
  force[0] = 316;
  const { values } = filtered(times, force, 60, 1);
  const peak = values.indexOf(Math.max(...values));
  assert.ok(Math.abs(times[peak] - 0.006) < 1e-4);
  assert.ok(Math.abs(values[peak] - 90) < 2.5);
});

test("what cannot be filtered is said", () => {
  assert.match(filtered([0, 1], [1, 2], 60, 1).error, /too few/);
  assert.match(filtered([0, 0.001, 0.001, 0.002], [0, 1, 2, 3], 60, 1).error, /ascend/);
  assert.match(filtered([0, 0.1, 0.2, 0.3], [0, 1, 2, 3], 60, 1).error, /closer/);
});
