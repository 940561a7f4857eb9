// SPDX-License-Identifier: Apache-2.0

/** The model of the view: nodes, facets, beams and what they do over the states, unpacked. */
export class Shape {
  constructor(about, arrays) {
    this.about = about;
    this.parts = about.parts;
    this.times = about.times;
    this.states = about.times.length;
    this.nodeIds = arrays.node_ids;
    this.nodes = this.nodeIds.length;
    this.facetNodes = arrays.facet_nodes;
    this.facetElements = arrays.facet_elements;
    this.facetParts = arrays.facet_parts;
    this.facetFrom = arrays.facet_from;
    this.facetUntil = arrays.facet_until;
    this.facets = this.facetParts.length;
    this.beamNodes = arrays.beam_nodes;
    this.beamElements = arrays.beam_elements;
    this.beamParts = arrays.beam_parts;
    this.beamUntil = arrays.beam_until;
    this.beams = this.beamParts.length;
    this.fields = about.fields.map((field, number) => ({
      ...field,
      values: about.times.map((_, i) => arrays[`field${number}_${i}`]),
    }));
    this.first = this.#coordinates(arrays.x);
    this.x = [];
    let steps = arrays.x;
    for (let i = 0; i < this.states; ++i) {
      const change = arrays[`dx${i}`];
      steps = steps.map((value, k) => value + change[k]); // both count modulo 2^16
      this.x.push(this.#coordinates(steps));
    }
    this.indexOfNode = new Map(Array.from(this.nodeIds, (id, i) => [id, i]));
  }

  /** x y z of each node from steps: x of all, y of all, z of all. */
  #coordinates(steps) {
    const { low, high } = this.about, count = steps.length / 3, x = new Float32Array(3 * count);
    for (let axis = 0; axis < 3; ++axis) {
      const size = (high[axis] - low[axis]) / 65535;
      for (let i = 0; i < count; ++i) x[3 * i + axis] = low[axis] + size * steps[axis * count + i];
    }
    return x;
  }

  /** Coordinates at a place between states (2.5: midway between the states 2 and 3), displacements times `scale`. */
  coordinatesAt(place, scale, target) {
    const i = Math.min(Math.floor(place), this.states - 1), k = Math.min(i + 1, this.states - 1), share = place - i;
    const a = this.x[i], b = this.x[k], o = this.first;
    for (let n = 0; n < target.length; ++n) target[n] = o[n] + scale * (a[n] + share * (b[n] - a[n]) - o[n]);
    return target;
  }

  facetLives(facet, state) {
    return this.facetFrom[facet] <= state && state < this.facetUntil[facet];
  }

  diagonal() {
    const { low, high } = this.about;
    return Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  }
}
