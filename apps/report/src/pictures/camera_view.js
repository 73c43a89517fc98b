// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What one camera saw, and over it what the simulation has there.
import { h, onSeen } from '../dom.js';
import { pointOnCloth } from '../viewer/observations.js';
import { ClothPath, edgesOf, kByProcessor, loadOutlines, strokeSilhouette } from './outlines.js';
import { PictureStore } from './picture_store.js';
import { project } from './projection.js';

// Colours over pictures, the same by day and night; the style sheet has them too.
export const kInk = { measured: '#ffffff', before: '#ff9a3c', after: '#3fc1ff', miss: '#ff4fa3' };

// What every camera's view needs. `layers`: which of kInk's names, and 'points', are shown.
export class PictureContext {
  constructor(report, observations, triangles, cloths) {
    const mesh = { triangles, edges: edgesOf(triangles) };
    Object.assign(this, { report, observations, mesh, cloths });
    this.layers = new Set(['measured', 'after']);
    this.views = new Set();
  }

  setLayer(name, on) {
    if (on) this.layers.add(name); else this.layers.delete(name);
    for (const view of this.views) view.draw();
  }
}

export class CameraView {
  constructor(context, index, player, { maxWidth = 720 } = {}) {
    this.context = context;
    this.player = player;
    this.maxWidth = maxWidth;
    this.canvas = h('canvas', { role: 'img' });
    this.note = h('span', { class: 'picture-note' });
    this.element = h('div', { class: 'camera-view' }, this.canvas, this.note);
    this.isSeen = false;
    this.setCamera(index);
    onSeen(this.element, (seen) => {
      this.isSeen = seen;
      if (seen) this.draw();
    });
    context.views.add(this);
    player.onFrame(() => {
      if (this.frame() !== this.drawn) this.draw();
    });
  }

  setCamera(index) {
    this.index = index;
    this.camera = this.context.report.cameras[index];
    this.store = new PictureStore(this.camera);
    this.paths = Object.fromEntries(Object.entries(this.context.cloths).map(([name, cloth]) =>
      [name, new ClothPath(this.camera, this.context.mesh, cloth)]));
    this.outlines = null;
    this.last = null;
    const [width, height] = this.camera.size;
    this.canvas.style.aspectRatio = `${width} / ${height}`;
    this.canvas.setAttribute('aria-label', `camera ${this.camera.name} with outlines`);
    loadOutlines(this.camera).then((outlines) => {
      this.outlines = outlines;
      this.draw();
    });
    this.draw();
  }

  // The picture's frame where there are pictures, so that outlines and picture belong together.
  frame() {
    if (this.store.isEmpty) return this.player.frame;
    return this.store.frameOf(this.store.indexAt(this.player.frame));
  }

  draw() {
    if (!this.isSeen) return;
    this.fit();
    const context = this.canvas.getContext('2d', { ...kByProcessor, alpha: false });
    const scale = this.canvas.width / this.camera.size[0];
    context.setTransform(1, 0, 0, 1, 0, 0);
    const frame = this.drawPicture(context);
    this.drawn = frame;
    const { layers } = this.context;
    const line = Math.max(1.25, this.canvas.width / 420);
    if (layers.has('measured') && this.outlines?.has(frame)) {
      context.setTransform(scale, 0, 0, scale, 0.5 * scale, 0.5 * scale);
      context.lineWidth = line / scale;
      context.strokeStyle = kInk.measured;
      context.stroke(this.outlines.get(frame));
    }
    for (const [name, path] of Object.entries(this.paths)) {
      const silhouette = layers.has(name) ? path.at(frame) : null;
      if (silhouette) strokeSilhouette(context, silhouette, kInk[name] ?? '#fff', scale, line);
    }
    if (layers.has('points')) this.drawPoints(context, frame, scale, line);
  }

  fit() {
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    const shown = this.canvas.clientWidth || 320;
    const width = Math.round(Math.min(this.maxWidth, shown * ratio));
    const height = Math.round((width * this.camera.size[1]) / this.camera.size[0]);
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
  }

  // Returns the frame that is shown: that of the last picture until the present one is decoded.
  drawPicture(context) {
    const { width, height } = this.canvas;
    context.fillStyle = '#20252b';
    context.fillRect(0, 0, width, height);
    if (this.store.isEmpty) {
      this.note.textContent = 'no pictures: outlines only';
      return this.player.frame;
    }
    const index = this.store.indexAt(this.player.frame);
    const image = this.store.get(index, () => this.draw());
    if (image) this.last = { image, frame: this.store.frameOf(index) };
    if (this.last?.image.width) context.drawImage(this.last.image, 0, 0, width, height);
    if (this.player.isPlaying) this.store.prefetch(index);
    const frame = this.last?.frame ?? this.store.frameOf(index);
    this.note.textContent = frame === this.player.frame ? '' : `frame ${frame}`;
    return frame;
  }

  // Tracks as dots, and lines from them to where the fitted cloth has the same points.
  drawPoints(context, frame, scale, line) {
    const { observations, cloths } = this.context;
    const cloth = Object.values(cloths).at(-1);
    if (!observations.tracks || frame >= cloth.frames) return;
    const { first, items, pixels } = observations.tracks;
    const place = new Float32Array(3);
    const pixel = new Float32Array(2);
    const inFront = new Uint8Array(1);
    const dot = (2.6 * line) / scale;
    context.setTransform(scale, 0, 0, scale, 0.5 * scale, 0.5 * scale);
    context.lineWidth = line / scale;
    context.strokeStyle = kInk.miss;
    context.fillStyle = kInk.measured;
    context.beginPath();
    for (let i = first[frame]; i < first[frame + 1]; ++i) {
      if (items[3 * i + 1] !== this.index) continue;
      pointOnCloth(observations, items[3 * i + 2], cloth.positions, 3 * cloth.particles * frame,
        place, 0);
      project(this.camera, place, 0, 1, pixel, inFront);
      context.fillRect(pixels[2 * i] - dot / 2, pixels[2 * i + 1] - dot / 2, dot, dot);
      if (!inFront[0]) continue;
      context.moveTo(pixels[2 * i], pixels[2 * i + 1]);
      context.lineTo(pixel[0], pixel[1]);
    }
    context.stroke();
  }
}
