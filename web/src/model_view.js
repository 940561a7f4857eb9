// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { PLAIN, ofFailure, ofPart, ramp } from "./colours.js";

export const NO_VALUE = 255; // of a field in 8 bits
const GREY = [150, 156, 164];

/** Corners of a facet's two triangles, and its sides. */
const TRIANGLES = [0, 1, 2, 0, 2, 3], SIDES = [0, 1, 1, 2, 2, 3, 3, 0];

export const VIEWS = {
  iso: [1, -1.4, 0.9], "+x": [1, 0, 0], "−x": [-1, 0, 0], "+y": [0, 1, 0], "−y": [0, -1, 0], "+z": [0, 0, 1], "−z": [0, 0, -1],
};

/** Whether the browser can draw in three dimensions. */
export const drawsModels = () => Boolean(document.createElement("canvas").getContext("webgl2"));

function rendererFor(canvasParent) {
  const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  renderer.localClippingEnabled = true;
  renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
  canvasParent.append(renderer.domElement);
  return renderer;
}

/**
 * The model in three dimensions: facets, edges, beams, welds as discs. What is shown is set by properties; `redraw()` draws.
 * `onpick({weld} | {facet} | null)` is called for a click.
 */
export class ModelView {
  place = 0; // between states
  scale = 1; // of displacements
  colouring = { kind: "part" }; // or {kind: "field", field}, {kind: "displacement", high}
  edges = true;
  hiddenParts = new Set();
  selectedWeld = null;
  weldValue = () => 0; // failure value of a weld (or its share of energy) that colours it
  weldFailed = () => false;

  constructor(parent, shape, welds, onpick) {
    this.shape = shape;
    this.welds = welds;
    this.onpick = onpick;
    this.parent = parent;
    this.renderer = rendererFor(parent);
    this.scene = new THREE.Scene();
    this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -1, 1);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", () => this.redraw());
    this.light = new THREE.DirectionalLight(0xffffff, 2.2);
    this.scene.add(this.light, new THREE.AmbientLight(0xffffff, 1.4));
    this.cut = new THREE.Plane(new THREE.Vector3(0, 0, -1), Infinity);
    this.x = new Float32Array(3 * shape.nodes);
    this.#makeFacets();
    this.#makeLines();
    this.#makeWelds();
    this.#listen();
    this.resize();
    this.look("iso");
    this.show();
  }

  // ---- what is in the scene

  #makeFacets() {
    const { facets } = this.shape;
    this.facetX = new Float32Array(18 * facets);
    this.facetColours = new Uint8Array(18 * facets);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(this.facetX, 3));
    geometry.setAttribute("color", new THREE.BufferAttribute(this.facetColours, 3, true));
    this.visible = new Uint32Array(6 * facets);
    geometry.setIndex(new THREE.BufferAttribute(this.visible, 1));
    const material = new THREE.MeshLambertMaterial({
      vertexColors: true, flatShading: true, side: THREE.DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    });
    this.mesh = new THREE.Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  #makeLines() {
    const { facets, beams } = this.shape;
    this.nodeX = new THREE.BufferAttribute(this.x, 3);
    const lines = (count, colour, opacity) => {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", this.nodeX);
      geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(count), 1));
      const made = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: colour, transparent: opacity < 1, opacity }));
      made.frustumCulled = false;
      this.scene.add(made);
      return made;
    };
    this.edgeLines = lines(8 * facets, 0x101418, 0.28);
    this.beamLines = lines(2 * beams, 0x303a46, 1);
  }

  #makeWelds() {
    const disc = new THREE.CylinderGeometry(0.5, 0.5, 1, 20);
    const material = new THREE.MeshLambertMaterial();
    this.discs = new THREE.InstancedMesh(disc, material, Math.max(1, this.welds.length));
    this.discs.frustumCulled = false;
    this.discs.count = this.welds.length;
    this.discs.instanceColor = new THREE.InstancedBufferAttribute(new Float32Array(3 * Math.max(1, this.welds.length)), 3);
    const ring = new THREE.TorusGeometry(0.8, 0.12, 8, 32);
    this.ring = new THREE.Mesh(ring, new THREE.MeshBasicMaterial({ color: 0xff00aa, depthTest: false, transparent: true }));
    this.ring.visible = false;
    this.ring.renderOrder = 2;
    this.scene.add(this.discs, this.ring);
  }

  setCut(axis, share) {
    const materials = [this.mesh, this.edgeLines, this.beamLines, this.discs].map((o) => o.material);
    const { low, high } = this.shape.about;
    const k = { x: 0, y: 1, z: 2 }[axis];
    if (k !== undefined) {
      const normal = [0, 0, 0];
      normal[k] = -1;
      this.cut.set(new THREE.Vector3(...normal), low[k] + share * (high[k] - low[k]));
    }
    for (const material of materials) {
      material.clippingPlanes = k === undefined ? null : [this.cut];
      material.needsUpdate = true;
    }
    this.redraw();
  }

  // ---- the state that is shown

  /** Coordinates, colours and what lives, of `place`. */
  show() {
    this.shape.coordinatesAt(this.place, this.scale, this.x);
    this.nodeX.needsUpdate = true;
    const { facetNodes } = this.shape, x = this.x, target = this.facetX;
    let t = 0;
    for (let f = 0; f < this.shape.facets; ++f)
      for (const corner of TRIANGLES) {
        const n = 3 * facetNodes[4 * f + corner];
        target[t++] = x[n];
        target[t++] = x[n + 1];
        target[t++] = x[n + 2];
      }
    this.mesh.geometry.attributes.position.needsUpdate = true;
    this.#colour();
    this.#choose();
    this.#placeWelds();
    this.redraw();
  }

  get state() {
    return Math.min(Math.round(this.place), this.shape.states - 1);
  }

  #colour() {
    const { facetParts, facets } = this.shape, target = this.facetColours, { kind, field, high } = this.colouring;
    const parts = this.shape.parts.map((_, i) => ofPart(i));
    const table = Array.from({ length: 255 }, (_, i) => ramp(i / 254));
    const values = kind === "field" ? field.values[this.state] : null;
    for (let f = 0; f < facets; ++f) {
      let colour;
      if (values) colour = values[f] === NO_VALUE ? GREY : table[this.#stretched(values[f])];
      else if (kind === "displacement") colour = table[Math.round(254 * Math.min(1, this.#displacement(f) / (high || 1)))];
      else colour = parts[facetParts[f]];
      for (let k = 0; k < 6; ++k) target.set(colour, 18 * f + 3 * k);
    }
    this.mesh.geometry.attributes.color.needsUpdate = true;
  }

  /** A value in 8 bits of the field's whole range, in the range that the legend shows. */
  #stretched(value) {
    const { field, low, high } = this.colouring;
    const shown = field.low + (value / 254) * (field.high - field.low);
    return Math.round(254 * Math.min(1, Math.max(0, (shown - low) / (high - low || 1))));
  }

  /** Length of the mean displacement of a facet's corners. */
  #displacement(f) {
    const { facetNodes, first } = this.shape, x = this.shape.x[this.state];
    let u = 0, v = 0, w = 0;
    for (let corner = 0; corner < 4; ++corner) {
      const n = 3 * facetNodes[4 * f + corner];
      u += x[n] - first[n];
      v += x[n + 1] - first[n + 1];
      w += x[n + 2] - first[n + 2];
    }
    return 0.25 * Math.hypot(u, v, w);
  }

  /** Facets, edges and beams that live and whose part is shown. */
  #choose() {
    const { facetParts, facetNodes, facets, beamParts, beamUntil, beamNodes, beams } = this.shape, state = this.state;
    const edges = this.edgeLines.geometry.index.array, beamIndex = this.beamLines.geometry.index.array;
    let t = 0, s = 0, b = 0;
    for (let f = 0; f < facets; ++f) {
      if (this.hiddenParts.has(facetParts[f]) || !this.shape.facetLives(f, state)) continue;
      const triangle = facetNodes[4 * f + 2] === facetNodes[4 * f + 3];
      for (let k = 0; k < (triangle ? 3 : 6); ++k) this.visible[t++] = 6 * f + k;
      if (this.edges) for (let k = 0; k < 8; ++k) edges[s++] = facetNodes[4 * f + SIDES[k]];
    }
    for (let e = 0; e < beams; ++e)
      if (!this.hiddenParts.has(beamParts[e]) && state < beamUntil[e])
        for (let k = 0; k < 2; ++k) beamIndex[b++] = beamNodes[2 * e + k];
    for (const [object, count] of [[this.mesh, t], [this.edgeLines, s], [this.beamLines, b]]) {
      object.geometry.setDrawRange(0, count);
      object.geometry.index.needsUpdate = true;
    }
  }

  #point(node) {
    const n = 3 * node;
    return new THREE.Vector3(this.x[n], this.x[n + 1], this.x[n + 2]);
  }

  /** Centre and direction of a weld now: the mean of its nodes, the normal of the facet that it is tied to. */
  #poseOf(weld) {
    if (weld.nodes.length === 0) return null;
    const centre = new THREE.Vector3();
    for (const node of weld.nodes) centre.addScaledVector(this.#point(node), 1 / weld.nodes.length);
    const direction = new THREE.Vector3(0, 0, 1);
    if (weld.segment.length >= 3) {
      const corners = weld.segment.map((node) => this.#point(node)), last = corners.length - 1;
      direction.crossVectors(
        corners[2].clone().sub(corners[0]),
        (last > 2 ? corners[3] : corners[1]).clone().sub(corners[last > 2 ? 1 : 0]),
      );
    } else if (weld.nodes.length === 2) {
      direction.subVectors(this.#point(weld.nodes[1]), this.#point(weld.nodes[0]));
    }
    if (direction.lengthSq() === 0) direction.set(0, 0, 1);
    return { centre, direction: direction.normalize() };
  }

  #placeWelds() {
    const up = new THREE.Vector3(0, 1, 0), turn = new THREE.Quaternion(), size = new THREE.Vector3(), matrix = new THREE.Matrix4();
    const least = 0.004 * this.shape.diagonal();
    this.ring.visible = false;
    this.welds.forEach((weld, i) => {
      const pose = weld.part !== undefined && this.hiddenParts.has(weld.part) ? null : this.#poseOf(weld);
      if (!pose) {
        this.discs.setMatrixAt(i, matrix.makeScale(0, 0, 0));
        return;
      }
      turn.setFromUnitVectors(up, pose.direction);
      const diameter = Math.max(weld.diameter || 0, least);
      size.set(diameter, Math.max(1.6 * (weld.length || 0), 0.45 * diameter), diameter);
      this.discs.setMatrixAt(i, matrix.compose(pose.centre, turn, size));
      const colour = this.weldColour(weld);
      this.discs.setColorAt(i, new THREE.Color().setRGB(...colour.map((c) => c / 255), THREE.SRGBColorSpace));
      if (weld !== this.selectedWeld) return;
      this.ring.visible = true;
      this.ring.position.copy(pose.centre);
      this.ring.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), pose.direction);
      this.ring.scale.setScalar(diameter);
    });
    this.discs.instanceMatrix.needsUpdate = true;
    this.discs.instanceColor.needsUpdate = true;
    this.discs.computeBoundingSphere();
  }

  /** By the ramp of the elements where these show damage, else by its failure value. */
  weldColour(weld) {
    const { field, low, high } = this.colouring, value = this.weldValue(weld);
    if (field?.name !== "damage") return ofFailure(value);
    const damage = value >= 1 ? 1 : weld.damage;
    return damage === null ? PLAIN : ramp((damage - low) / (high - low || 1));
  }

  // ---- camera

  resize() {
    const { clientWidth: width, clientHeight: height } = this.parent;
    if (!width || !height) return;
    this.renderer.setSize(width, height);
    const aspect = width / height;
    this.camera.left = -aspect;
    this.camera.right = aspect;
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  /** Turns the camera to one of VIEWS; all fits. */
  look(name) {
    const direction = new THREE.Vector3(...VIEWS[name]).normalize();
    this.camera.up.set(0, Math.abs(direction.z) > 0.9 ? 1 : 0, Math.abs(direction.z) > 0.9 ? 0 : 1);
    this.direction = direction;
    this.fit();
  }

  /** All of the model, or a piece of `size` around `centre`, fills the view. */
  fit(centre = null, size = null) {
    const { low, high } = this.shape.about, diagonal = this.shape.diagonal();
    const direction = this.direction ?? this.camera.position.clone().sub(this.controls.target);
    this.direction = null;
    const middle = centre ?? new THREE.Vector3(...low.map((v, k) => 0.5 * (v + high[k])));
    this.controls.target.copy(middle);
    this.camera.position.copy(middle).addScaledVector(direction.normalize(), 2 * diagonal);
    this.camera.near = 0;
    this.camera.far = 5 * diagonal;
    this.controls.update();
    this.camera.updateMatrixWorld();
    let [width, height] = [size ?? 0, size ?? 0]; // of the box, seen from the camera
    for (let corner = 0; size === null && corner < 8; ++corner) {
      const p = new THREE.Vector3(...low.map((v, k) => (corner & (1 << k) ? high[k] : v)));
      p.applyMatrix4(this.camera.matrixWorldInverse);
      width = Math.max(width, 2 * Math.abs(p.x));
      height = Math.max(height, 2 * Math.abs(p.y));
    }
    this.camera.zoom = 0.94 * Math.min(2 / (height || 1), (2 * this.camera.right) / (width || 1));
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.redraw();
  }

  /** Looks as another view does. */
  cameraAs(other) {
    this.camera.position.copy(other.camera.position);
    this.camera.up.copy(other.camera.up);
    this.camera.zoom = other.camera.zoom;
    this.camera.far = other.camera.far;
    this.controls.target.copy(other.controls.target);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.redraw();
  }

  /** Brings a weld to the middle. */
  goTo(weld) {
    const pose = this.#poseOf(weld);
    if (pose) this.fit(pose.centre, Math.max(14 * (weld.diameter || 0), 0.12 * this.shape.diagonal()));
  }

  // ---- drawing and picking

  redraw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => this.draw());
  }

  draw() {
    this.waiting = false;
    this.light.position.copy(this.camera.position).sub(this.controls.target).normalize().add(new THREE.Vector3(0.3, 0.2, 0.5));
    this.renderer.render(this.scene, this.camera);
    ++this.frames;
  }
  frames = 0;

  picture() {
    this.draw();
    return this.renderer.domElement.toDataURL("image/png");
  }

  #listen() {
    const canvas = this.renderer.domElement;
    let down = null;
    canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
    canvas.addEventListener("pointerup", (event) => {
      if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4) this.#pick(event);
      down = null;
    });
    new ResizeObserver(() => this.resize()).observe(this.parent);
  }

  #pick(event) {
    const canvas = this.renderer.domElement.getBoundingClientRect();
    const at = new THREE.Vector2(
      (2 * (event.clientX - canvas.left)) / canvas.width - 1, 1 - (2 * (event.clientY - canvas.top)) / canvas.height);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(at, this.camera);
    this.mesh.geometry.computeBoundingSphere();
    const disc = this.welds.length ? ray.intersectObject(this.discs)[0] : undefined;
    const facet = ray.intersectObject(this.mesh).find((hit) => !this.mesh.material.clippingPlanes || this.cut.distanceToPoint(hit.point) >= 0);
    // A disc lies between sheets: it is meant when it is not far behind what covers it.
    if (disc && (!facet || disc.distance < facet.distance + 0.02 * this.shape.diagonal()))
      this.onpick({ weld: this.welds[disc.instanceId] });
    else if (facet) this.onpick({ facet: Math.floor(this.#firstCorner(facet) / 6) });
    else this.onpick(null);
  }

  #firstCorner(hit) {
    return hit.face.a;
  }

  /** Where a weld is on the screen, in pixels of the page; null where it is not shown. */
  onScreen(weld) {
    const pose = this.#poseOf(weld);
    if (!pose) return null;
    const canvas = this.renderer.domElement.getBoundingClientRect(), p = pose.centre.project(this.camera);
    return [canvas.left + (0.5 + 0.5 * p.x) * canvas.width, canvas.top + (0.5 - 0.5 * p.y) * canvas.height];
  }
}
