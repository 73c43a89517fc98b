// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Points and lines whose number changes from frame to frame.
import {
  BufferAttribute, BufferGeometry, CanvasTexture, DynamicDrawUsage, LineBasicMaterial, LineSegments,
  Points, PointsMaterial,
} from 'three';

import { colour } from '../theme.js';

// Makes room for 3 * `count` numbers and lets fill(array) write them; it returns how many points.
function update(geometry, count, fill) {
  let place = geometry.getAttribute('position');
  if (!place || place.count < count) {
    place = new BufferAttribute(new Float32Array(3 * Math.max(16, 2 * count)), 3);
    place.setUsage(DynamicDrawUsage);
    geometry.setAttribute('position', place);
  }
  geometry.setDrawRange(0, fill(place.array));
  place.needsUpdate = true;
}

export class ChangingLines {
  constructor(colourName, opacity = 1) {
    this.colourName = colourName;
    this.object = new LineSegments(new BufferGeometry(),
      new LineBasicMaterial({ transparent: opacity < 1, opacity }));
    this.object.frustumCulled = false;
    this.applyTheme();
  }

  applyTheme() {
    this.object.material.color.set(colour(this.colourName));
  }

  // fill writes both ends of each line, and returns twice their number.
  set(numLines, fill) {
    update(this.object.geometry, 2 * numLines, fill);
  }
}

function disc() {
  const size = 64;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  const context = canvas.getContext('2d');
  context.fillStyle = '#fff';
  context.beginPath();
  context.arc(size / 2, size / 2, size / 2 - 2, 0, 2 * Math.PI);
  context.fill();
  return new CanvasTexture(canvas);
}

export class ChangingPoints {
  constructor(colourName, pixels) {
    this.colourName = colourName;
    this.pixels = pixels;
    this.object = new Points(new BufferGeometry(), new PointsMaterial({
      size: pixels, sizeAttenuation: false, map: disc(), alphaTest: 0.5, transparent: false,
    }));
    this.object.frustumCulled = false;
    this.applyTheme();
  }

  applyTheme() {
    this.object.material.color.set(colour(this.colourName));
  }

  setPixelRatio(ratio) {
    this.object.material.size = this.pixels * ratio;
  }

  set(count, fill) {
    update(this.object.geometry, count, fill);
  }
}
