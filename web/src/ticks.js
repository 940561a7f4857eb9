// SPDX-License-Identifier: Apache-2.0

/** Marks of a logarithmic axis between two numbers above 0, wherever they lie: 1, 2 and 5 of each decade, of more than four decades the powers. */
export function logTicks(low, high) {
  const first = Math.floor(Math.log10(low)), last = Math.ceil(Math.log10(high));
  const digits = last - first > 4 ? [1] : [1, 2, 5];
  const ticks = [];
  for (let power = first; power <= last; ++power)
    for (const digit of digits) {
      const tick = Number(`${digit}e${power}`);
      if (tick >= low * (1 - 1e-6) && tick <= high * (1 + 1e-6)) ticks.push(tick);
    }
  return ticks.length >= 2 ? ticks : [low, high];
}
