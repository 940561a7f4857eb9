// SPDX-License-Identifier: Apache-2.0

/** `b` minus `a` at those times of `a` that `b` has, on straight lines between samples. */
export function difference(a, b) {
  let k = 0;
  const slack = 1e-6 * (b.x.at(-1) - b.x[0]); // times are rounded
  const y = Array.from(a.x, (t) => {
    if (t < b.x[0] - slack || t > b.x.at(-1) + slack) return NaN;
    while (k < b.x.length - 2 && b.x[k + 1] < t) ++k;
    const share = (t - b.x[k]) / (b.x[k + 1] - b.x[k]);
    return b.y[k] + share * (b.y[k + 1] - b.y[k]);
  });
  return { ...a, name: `B − A ${a.name}`, y: y.map((v, i) => v - a.y[i]) };
}
