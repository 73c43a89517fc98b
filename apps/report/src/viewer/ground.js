// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The ground as a grid of lines, or where there is none a faint one below the cloth.
import { GridHelper, Quaternion, Vector3 } from 'three';

import { colour } from '../theme.js';

// `up`: unit, against gravity. `box`: of the cloth over all frames.
export function groundLayer(ground, up, box) {
  const centre = box.getCenter(new Vector3());
  const extent = box.getSize(new Vector3()).length();
  const cell = 10 ** Math.round(Math.log10(extent / 12));
  const cells = 2 * Math.ceil((0.9 * extent) / cell);
  const grid = new GridHelper(cells * cell, cells);
  grid.material.transparent = true;
  grid.material.vertexColors = false;
  const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), up);
  grid.quaternion.copy(turn);
  const lowest = ground === null ? lowestOf(box, up) - 0.02 * extent : ground;
  // A little below, or its lines would be drawn over cloth that lies on it.
  const sunk = lowest - 0.004 * extent;
  const height = ground === null ? sunk - centre.dot(up) : sunk - centre.z;
  grid.position.copy(centre).addScaledVector(ground === null ? up : new Vector3(0, 0, 1), height);
  const part = {
    applyTheme() {
      grid.material.color.set(colour('--grid'));
      grid.material.opacity = ground === null ? 0.35 : 0.8;
    },
  };
  part.applyTheme();
  return { object: grid, parts: [part], setFrame() {} };
}

function lowestOf(box, up) {
  let lowest = Infinity;
  for (let k = 0; k < 8; ++k) {
    const corner = new Vector3(k & 1 ? box.max.x : box.min.x, k & 2 ? box.max.y : box.min.y,
      k & 4 ? box.max.z : box.min.z);
    lowest = Math.min(lowest, corner.dot(up));
  }
  return lowest;
}
