// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// One moving cloth: its surface, coloured by a field or by its two sides, and its threads.
import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, DynamicDrawUsage, FrontSide, BackSide, Group,
  LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial, SRGBColorSpace,
} from 'three';

import { mapColour } from '../colours.js';
import { colour } from '../theme.js';

const kShades = 256;

// The lines of warp and weft where the mesh is a grid, else every edge.
function threadsOf(mesh, triangles) {
  const pairs = [];
  if (mesh.grid) {
    const [nu, nv] = mesh.grid;
    for (let j = 0; j < nv; ++j) {
      for (let i = 0; i < nu; ++i) {
        const here = i + j * nu;
        if (i + 1 < nu) pairs.push(here, here + 1);
        if (j + 1 < nv) pairs.push(here, here + nu);
      }
    }
    return pairs;
  }
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; ++k) pairs.push(triangles[t + k], triangles[t + ((k + 1) % 3)]);
  }
  return pairs;
}

function shadesOf(field) {
  const shades = new Float32Array(3 * (kShades + 1));
  const linear = new Color();
  for (let k = 0; k <= kShades; ++k) {
    const value = k === kShades ? NaN : k / (kShades - 1);
    linear.setRGB(...mapColour(value, [0, 1], field.diverging), SRGBColorSpace);
    linear.toArray(shades, 3 * k);
  }
  return shades;
}

export class Cloth {
  constructor(mesh, triangles, positions, frames) {
    this.positions = positions;  // frames x particles x 3
    this.frames = frames;
    this.particles = mesh.particles;
    this.geometry = new BufferGeometry();
    this.place = new BufferAttribute(new Float32Array(3 * this.particles), 3);
    this.place.setUsage(DynamicDrawUsage);
    this.colours = new BufferAttribute(new Float32Array(3 * this.particles).fill(1), 3);
    this.colours.setUsage(DynamicDrawUsage);
    this.geometry.setAttribute('position', this.place);
    this.geometry.setAttribute('color', this.colours);
    this.geometry.setIndex(new BufferAttribute(new Uint32Array(triangles), 1));
    const offset = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    this.coloured = new MeshLambertMaterial({ side: DoubleSide, vertexColors: true, ...offset });
    this.front = new MeshLambertMaterial({ side: FrontSide, ...offset });
    this.back = new MeshLambertMaterial({ side: BackSide, ...offset });
    this.tinted = new MeshLambertMaterial({
      side: DoubleSide, transparent: true, opacity: 0.72, ...offset,
    });
    this.surface = new Mesh(this.geometry, this.coloured);
    this.reverse = new Mesh(this.geometry, this.back);
    const lines = new BufferGeometry();
    lines.setAttribute('position', this.place);
    lines.setIndex(threadsOf(mesh, triangles));
    this.threads = new LineSegments(lines,
      new LineBasicMaterial({ transparent: true, opacity: 0.22 }));
    this.object = new Group();
    this.object.add(this.surface, this.reverse, this.threads);
    for (const part of this.object.children) part.frustumCulled = false;
    this.setField(null, null);
    this.applyTheme();
  }

  applyTheme() {
    this.front.color.set(colour('--cloth-front'));
    this.back.color.set(colour('--cloth-back'));
    this.threads.material.color.set(colour('--thread'));
    if (this.tint) this.tinted.color.set(colour(this.tint));
  }

  // One colour for all of it, by its name in the style; null: that of the field or the sides.
  setTint(name) {
    this.tint = name;
    this.chooseMaterial();
    this.applyTheme();
  }

  chooseMaterial() {
    this.surface.material = this.tint ? this.tinted : this.field ? this.coloured : this.front;
    this.reverse.visible = !this.field && !this.tint;
  }

  // `values`: frames x particles; null: the two sides in colours of their own.
  setField(field, values) {
    this.field = field;
    this.values = values;
    this.shades = field ? shadesOf(field) : null;
    this.chooseMaterial();
    if (this.frame !== undefined) this.colour();
  }

  // False where the simulation did not get as far as this frame.
  setFrame(frame) {
    this.frame = frame;
    this.object.visible = frame < this.frames;
    if (!this.object.visible) return false;
    const begin = 3 * this.particles * frame;
    this.place.array.set(this.positions.subarray(begin, begin + 3 * this.particles));
    this.place.needsUpdate = true;
    this.geometry.computeVertexNormals();
    this.geometry.boundingSphere = null;
    this.colour();
    return true;
  }

  colour() {
    if (!this.field || this.frame >= this.frames) return;
    const [low, high] = this.field.range;
    const scale = (kShades - 1) / (high - low || 1);
    const begin = this.particles * this.frame;
    for (let i = 0; i < this.particles; ++i) {
      const value = this.values ? this.values[begin + i] : NaN;
      const k = Number.isFinite(value)
        ? Math.max(0, Math.min(kShades - 1, Math.round((value - low) * scale))) : kShades;
      for (let c = 0; c < 3; ++c) this.colours.array[3 * i + c] = this.shades[3 * k + c];
    }
    this.colours.needsUpdate = true;
  }

  valueAt(particle) {
    return this.values && this.frame < this.frames
      ? this.values[this.particles * this.frame + particle] : NaN;
  }

  positionAt(particle, target) {
    return target.fromArray(this.positions, 3 * (this.particles * this.frame + particle));
  }
}
