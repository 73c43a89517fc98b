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

// The cloth in a camera as one path of all its triangles, each turned the same way so that the
// path's inside is the silhouette; null where the simulation did not get that far.
export class ClothPath {
  constructor(camera, triangles, cloth) {
    this.camera = camera;
    this.triangles = triangles;
    this.cloth = cloth;  // { positions, particles, frames }
    this.pixels = new Float32Array(2 * cloth.particles);
    this.inFront = new Uint8Array(cloth.particles);
  }

  at(frame) {
    const { positions, particles, frames } = this.cloth;
    if (frame >= frames) return null;
    project(this.camera, positions, 3 * particles * frame, particles, this.pixels, this.inFront);
    const path = new Path2D();
    const { triangles, pixels, inFront } = this;
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [triangles[t], triangles[t + 1], triangles[t + 2]];
      if (!inFront[a] || !inFront[b] || !inFront[c]) continue;
      const area = (pixels[2 * b] - pixels[2 * a]) * (pixels[2 * c + 1] - pixels[2 * a + 1]) -
                   (pixels[2 * c] - pixels[2 * a]) * (pixels[2 * b + 1] - pixels[2 * a + 1]);
      const [second, third] = area > 0 ? [b, c] : [c, b];
      path.moveTo(pixels[2 * a], pixels[2 * a + 1]);
      path.lineTo(pixels[2 * second], pixels[2 * second + 1]);
      path.lineTo(pixels[2 * third], pixels[2 * third + 1]);
      path.closePath();
    }
    return path;
  }
}

let scratch = null;

function scratchOf(width, height) {
  scratch ??= document.createElement('canvas');
  if (scratch.width < width || scratch.height < height) {
    scratch.width = Math.max(width, scratch.width);
    scratch.height = Math.max(height, scratch.height);
  }
  return scratch.getContext('2d');
}

// Draws the outer rim of a filled path: its stroke less its inside. `scale`: canvas px per px of
// the camera.
export function strokeSilhouette(context, path, colour, scale, lineWidth) {
  const { width, height } = context.canvas;
  const rim = scratchOf(width, height);
  rim.setTransform(1, 0, 0, 1, 0, 0);
  rim.clearRect(0, 0, width, height);
  rim.setTransform(scale, 0, 0, scale, 0.5 * scale, 0.5 * scale);
  rim.lineWidth = (2 * lineWidth) / scale;
  rim.lineJoin = 'round';
  rim.strokeStyle = colour;
  rim.fillStyle = colour;
  rim.stroke(path);
  rim.globalCompositeOperation = 'destination-out';
  rim.fill(path);
  rim.globalCompositeOperation = 'source-over';
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.drawImage(rim.canvas, 0, 0, width, height, 0, 0, width, height);
}
