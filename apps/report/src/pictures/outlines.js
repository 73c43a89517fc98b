// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Outlines over a picture: as measured, and of a simulated cloth.
import { decode } from '../data.js';
import { project } from './projection.js';

// Measured polygons of a camera as one path a frame, in the camera's pixels.
export async function loadOutlines(camera) {
  if (!camera.outlines) return null;
  const corners = await decode(camera.outlines.corners);
  const polygons = await decode(camera.outlines.polygons);
  const paths = new Map();
  let at = 0;
  for (let p = 0; p < polygons.length; p += 2) {
    const [frame, count] = [polygons[p], polygons[p + 1]];
    if (!paths.has(frame)) paths.set(frame, new Path2D());
    const path = paths.get(frame);
    path.moveTo(corners[at], corners[at + 1]);
    for (let i = 1; i < count; ++i) path.lineTo(corners[at + 2 * i], corners[at + 2 * i + 1]);
    path.closePath();
    at += 2 * count;
  }
  return paths;
}

// The mesh's edges, each with its one or two triangles: a, b, first, second or -1.
export function edgesOf(triangles) {
  const found = new Map();
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [triangles[t + k], triangles[t + ((k + 1) % 3)]].sort((x, y) => x - y);
      const key = a * 0x100000 + b;
      if (found.has(key)) found.get(key)[3] = t / 3; else found.set(key, [a, b, t / 3, -1]);
    }
  }
  return new Int32Array([...found.values()].flat());
}

// The cloth in a camera: `inside`, a path of all its triangles, each turned the same way, and
// `contours`, those edges at which it ends or turns away, of which the outline is a part. Null
// where the simulation did not get that far.
export class ClothPath {
  constructor(camera, mesh, cloth) {
    this.camera = camera;
    this.mesh = mesh;    // { triangles, edges }
    this.cloth = cloth;  // { positions, particles, frames }
    this.pixels = new Float32Array(2 * cloth.particles);
    this.inFront = new Uint8Array(cloth.particles);
    this.sides = new Int8Array(mesh.triangles.length / 3);  // 0 behind the camera
  }

  at(frame) {
    const { positions, particles, frames } = this.cloth;
    if (frame >= frames) return null;
    project(this.camera, positions, 3 * particles * frame, particles, this.pixels, this.inFront);
    return { inside: this.inside(), contours: this.contours(), box: this.box() };
  }

  inside() {
    const path = new Path2D();
    const { pixels, inFront, sides, mesh: { triangles } } = this;
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [triangles[t], triangles[t + 1], triangles[t + 2]];
      sides[t / 3] = 0;
      if (!inFront[a] || !inFront[b] || !inFront[c]) continue;
      const area = (pixels[2 * b] - pixels[2 * a]) * (pixels[2 * c + 1] - pixels[2 * a + 1]) -
                   (pixels[2 * c] - pixels[2 * a]) * (pixels[2 * b + 1] - pixels[2 * a + 1]);
      sides[t / 3] = area > 0 ? 1 : -1;
      const [second, third] = area > 0 ? [b, c] : [c, b];
      path.moveTo(pixels[2 * a], pixels[2 * a + 1]);
      path.lineTo(pixels[2 * second], pixels[2 * second + 1]);
      path.lineTo(pixels[2 * third], pixels[2 * third + 1]);  // filling closes it
    }
    return path;
  }

  contours() {
    const path = new Path2D();
    const { pixels, sides, mesh: { edges } } = this;
    for (let e = 0; e < edges.length; e += 4) {
      const first = sides[edges[e + 2]];
      const second = edges[e + 3] < 0 ? 0 : sides[edges[e + 3]];
      if (first === second) continue;
      path.moveTo(pixels[2 * edges[e]], pixels[2 * edges[e] + 1]);
      path.lineTo(pixels[2 * edges[e + 1]], pixels[2 * edges[e + 1] + 1]);
    }
    return path;
  }

  // Left, top, right and bottom in the camera's pixels.
  box() {
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    for (let i = 0; i < this.inFront.length; ++i) {
      if (!this.inFront[i]) continue;
      for (let c = 0; c < 2; ++c) {
        box[c] = Math.min(box[c], this.pixels[2 * i + c]);
        box[2 + c] = Math.max(box[2 + c], this.pixels[2 * i + c]);
      }
    }
    return box;
  }
}

// Paths of thousands of triangles are quicker without a graphics card in between.
export const kByProcessor = { willReadFrequently: true };

let scratch = null;

function scratchOf(width, height) {
  scratch ??= document.createElement('canvas');
  if (scratch.width < width || scratch.height < height) {
    scratch.width = Math.max(width, scratch.width);
    scratch.height = Math.max(height, scratch.height);
  }
  return scratch.getContext('2d', kByProcessor);
}

// Draws the outer rim of a cloth: its contours, of double width, less its inside. `scale`: canvas
// px per px of the camera.
export function strokeSilhouette(context, { inside, contours, box }, colour, scale, lineWidth) {
  const { width, height } = context.canvas;
  const clip = (value, end) => Math.round(Math.max(0, Math.min(end, value)));
  const margin = 2 * lineWidth + 2;
  const [left, top] = [clip(box[0] * scale - margin, width), clip(box[1] * scale - margin, height)];
  const across = clip(box[2] * scale + margin, width) - left;
  const down = clip(box[3] * scale + margin, height) - top;
  if (!(across > 0 && down > 0)) return;
  const rim = scratchOf(width, height);
  rim.setTransform(1, 0, 0, 1, 0, 0);
  rim.clearRect(left, top, across, down);
  rim.setTransform(scale, 0, 0, scale, 0.5 * scale, 0.5 * scale);
  rim.lineWidth = (2 * lineWidth) / scale;
  rim.lineCap = 'round';
  rim.strokeStyle = colour;
  rim.fillStyle = colour;
  rim.stroke(contours);
  rim.globalCompositeOperation = 'destination-out';
  rim.fill(inside);
  rim.globalCompositeOperation = 'source-over';
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.drawImage(rim.canvas, left, top, across, down, left, top, across, down);
}
