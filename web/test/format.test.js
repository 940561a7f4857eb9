// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { test } from "node:test";
import { csv, number, withUnit } from "../src/format.js";
import { difference } from "../src/difference.js";
import { logTicks } from "../src/ticks.js";
import { ofFailure, ramp } from "../src/colours.js";

test("numbers in five digits", () => {
  assert.equal(number(0), "0");
  assert.equal(number(1234.5678), "1234.6");
  assert.equal(number(-0.0012345678), "-0.0012346");
  assert.equal(number(5.93e6), "5.930e6");
  assert.equal(number(4.5e-7), "4.500e-7");
  assert.equal(number(NaN), "–");
  assert.equal(withUnit(2, "kN"), "2 kN");
  assert.equal(withUnit(2, undefined), "2");
});

test("commas, quotes and line ends are quoted (RFC 4180)", () =>
  assert.equal(csv([["a", 'say "x"'], ["1,5", 2]]), 'a,"say ""x"""\r\n"1,5",2\r\n'));

test("colours of failure values go from safe over near to failed", () => {
  const [safe, near, failed] = [0.1, 0.85, 1].map(ofFailure);
  assert.ok(safe[1] > safe[0]);
  assert.ok(near[0] > near[2]);
  assert.deepEqual(failed, [198, 40, 40]);
  assert.notDeepEqual(ofFailure(0), safe);
  assert.deepEqual(ramp(-1), ramp(0));
  assert.deepEqual(ramp(2), ramp(1));
});

test("the difference of two curves ends where one of them ends", () => {
  const a = { name: "force", x: [0, 1, 2, 3], y: [0, 10, 20, 30] }, b = { x: [0, 2], y: [0, 40] };
  assert.deepEqual(difference(a, b).y, [0, 10, 20, NaN]);
  assert.deepEqual(difference(b, a).y.slice(0, 2), [0, -20]);
});

test("marks of a log axis, wherever it begins", () => {
  assert.deepEqual(logTicks(50, 500), [50, 100, 200, 500]);
  assert.deepEqual(logTicks(Math.fround(0.01), 1), [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1]);
  assert.deepEqual(logTicks(0.013, 1e6).slice(0, 2), [0.1, 1]);
  assert.deepEqual(logTicks(31, 44), [31, 44]);
});
