// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The 3D view: one or two panes with one eye, in step with the page's clock.
import {
  AmbientLight, Box3, DirectionalLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

import { colour, onTheme } from '../theme.js';
import { Pace } from './pace.js';

// Everything that one motion of the cloth comes with.
export class Pane {
  constructor(motion, cloth) {
    this.motion = motion;
    this.cloth = cloth;
    this.layers = new Map();
    this.scene = new Scene();
    this.scene.add(cloth.object, new AmbientLight(0xffffff, 1.9));
  }

  addLayer(name, layer, visible) {
    layer.object.visible = visible;
    this.layers.set(name, layer);
    this.scene.add(layer.object);
  }

  setFrame(frame) {
    this.cloth.setFrame(frame);
    for (const layer of this.layers.values()) {
      if (layer.object.visible) layer.setFrame(frame);
    }
  }

  applyTheme() {
    this.cloth.applyTheme();
    for (const layer of this.layers.values()) {
      for (const part of layer.parts) part.applyTheme();
    }
  }
}

export function boxOf(positions) {
  const box = new Box3();
  const point = new Vector3();
  for (let i = 0; i < positions.length; i += 3) {
    box.expandByPoint(point.fromArray(positions, i));
  }
  return box;
}

// Whether WebGL is drawn by the processor, where smooth edges cost more than they are worth.
function isSoftware() {
  const gl = document.createElement('canvas').getContext('webgl2');
  const info = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

export class Viewer {
  // `up`: unit vector against gravity; `box`: what the eye has to see.
  constructor(container, panes, up, box) {
    this.container = container;
    this.panes = panes;
    this.shown = panes.slice(-1);
    this.isOver = false;  // the shown ones over each other rather than side by side
    this.mostPixels = isSoftware() ? 1 : 2;  // per CSS pixel
    this.pace = new Pace(this.mostPixels > 1 ? 1 : 0.75);
    this.canvas = document.createElement('canvas');
    this.renderer = new WebGLRenderer({ canvas: this.canvas, context: this.makeContext() });
    this.renderer.setScissorTest(true);
    container.prepend(this.canvas);
    this.eye = new PerspectiveCamera(32, 1, 0.01, 100);
    this.eye.up.copy(up);
    this.light = new DirectionalLight(0xffffff, 1.6);
    this.controls = new OrbitControls(this.eye, this.canvas);
    this.controls.addEventListener('change', () => this.invalidate());
    this.controls.addEventListener('start', () => { if (!this.isPlaying) this.move(true, 1 / 30); });
    this.controls.addEventListener('end', () => { if (!this.isPlaying) this.move(false, 0); });
    this.background = colour('--panel');
    this.home = { up, box };
    this.lookHome();
    new ResizeObserver(() => this.resize()).observe(container);
    onTheme(() => this.applyTheme());
    this.frames = 0;  // drawn so far
  }

  // Opaque, unlike three's own, so that the browser need not draw what lies below.
  makeContext() {
    const context = this.canvas.getContext('webgl2', {
      alpha: false, stencil: false, antialias: this.mostPixels > 1, powerPreference: 'low-power',
    });
    if (!context) throw new Error('this browser has none');
    return context;
  }

  // From the front right and a little above, as far as all of the motion needs.
  lookHome() {
    const { up, box } = this.home;
    const centre = box.getCenter(new Vector3());
    const radius = 0.5 * box.getSize(new Vector3()).length();
    const side = Math.abs(up.z) > 0.9 ? new Vector3(0.55, -1, 0) : new Vector3(0.55, 0, 1);
    side.addScaledVector(up, -side.dot(up)).normalize();
    const from = side.addScaledVector(up, 0.42).normalize();
    this.distance = radius / Math.sin((0.5 * this.eye.fov * Math.PI) / 180);
    this.controls.target.copy(centre);
    this.eye.position.copy(centre).addScaledVector(from, this.distance * this.closeness());
    this.eye.near = 0.01 * this.distance;
    this.eye.far = 20 * this.distance;
    this.controls.update();
    this.invalidate();
  }

  // Far enough away to see these places too.
  stepBack(places) {
    const { target } = this.controls;
    const reach = Math.max(...places.map((place) => target.distanceTo(new Vector3(...place))));
    const offset = this.eye.position.clone().sub(target);
    const wanted = (1.15 * reach) / Math.sin((0.5 * this.eye.fov * Math.PI) / 180);
    offset.setLength(Math.max(offset.length(), wanted));
    this.eye.position.copy(target).add(offset);
    this.controls.update();
  }

  // Of the sphere around the motion most is empty; narrow panes need more room.
  closeness() {
    const aspect = this.aspect();
    return 0.98 * Math.max(1, 1.15 / aspect);
  }

  aspect() {
    const { clientWidth, clientHeight } = this.container;
    return clientWidth && clientHeight ? clientWidth / this.columns() / clientHeight : 1.3;
  }

  columns() {
    return this.isOver ? 1 : this.shown.length;
  }

  show(names, isOver = false) {
    const before = this.closeness();
    this.shown = this.panes.filter((pane) => names.includes(pane.motion.name));
    this.isOver = isOver && this.shown.length > 1;
    for (const pane of this.shown) pane.setFrame(this.frame ?? 0);
    const { target } = this.controls;
    this.eye.position.sub(target).multiplyScalar(this.closeness() / before).add(target);
    this.controls.update();
    this.resize();
  }

  setFrame(frame) {
    this.frame = frame;
    for (const pane of this.shown) pane.setFrame(frame);
    this.invalidate();
  }

  refresh() {
    this.setFrame(this.frame ?? 0);
  }

  applyTheme() {
    this.background = colour('--panel');
    for (const pane of this.panes) pane.applyTheme();
    this.invalidate();
  }

  // While the clock runs. `rate`: Hz, at which pictures are wanted.
  play(isPlaying, rate) {
    this.isPlaying = isPlaying;
    this.move(isPlaying, 1 / rate);
  }

  move(isMoving, wanted) {
    this.pace.move(isMoving, wanted);
    this.resize();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.container;
    if (!width || !height) return;
    const ratio = this.pace.now * Math.min(this.mostPixels, window.devicePixelRatio);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    for (const pane of this.panes) {
      for (const layer of pane.layers.values()) {
        for (const part of layer.parts) part.setPixelRatio?.(this.renderer.getPixelRatio());
      }
    }
    this.invalidate();
  }

  invalidate() {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.draw();
    });
  }

  // The rectangle of a pane, in CSS pixels of the canvas.
  rectangle(index) {
    const width = this.container.clientWidth / this.columns();
    return { left: this.isOver ? 0 : index * width, width, height: this.container.clientHeight };
  }

  draw() {
    this.renderer.setClearColor(this.background);
    this.shown.forEach((pane, index) => {
      const { left, width, height } = this.rectangle(index);
      this.eye.aspect = width / height;
      this.eye.updateProjectionMatrix();
      this.renderer.setViewport(left, 0, width, height);
      this.renderer.setScissor(left, 0, width, height);
      this.light.position.copy(this.eye.position).sub(this.controls.target)
        .addScaledVector(this.eye.up, 0.8 * this.distance);
      pane.scene.add(this.light);
      this.renderer.autoClear = !this.isOver || index === 0;
      this.renderer.render(pane.scene, this.eye);
    });
    ++this.frames;
    if (this.pace.drawn(performance.now())) this.resize();
  }
}
