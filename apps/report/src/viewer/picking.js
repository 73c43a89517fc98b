// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Asking the cloth: which particle is under the pointer?
import { Raycaster, Vector2, Vector3 } from 'three';

const kClick = 5;  // px that a pointer may move between down and up

// The particle nearest to where the pane's cloth is hit; null where it is not.
export function pick(viewer, x, y) {
  const columns = viewer.columns();
  const index = Math.min(columns - 1,
    Math.floor((x / viewer.container.clientWidth) * columns));
  const { left, width, height } = viewer.rectangle(index);
  viewer.eye.aspect = width / height;
  viewer.eye.updateProjectionMatrix();
  const ray = new Raycaster();
  ray.setFromCamera(new Vector2((2 * (x - left)) / width - 1, 1 - (2 * y) / height), viewer.eye);
  const { cloth } = viewer.shown[index];
  const hits = cloth.object.visible
    ? ray.intersectObjects([cloth.surface, cloth.reverse].filter((part) => part.visible)) : [];
  if (hits.length === 0) return null;
  const corner = new Vector3();
  const { face, point } = hits[0];
  return [face.a, face.b, face.c].reduce((best, particle) =>
    (cloth.positionAt(particle, corner).distanceTo(point) <
     cloth.positionAt(best, new Vector3()).distanceTo(point) ? particle : best));
}

// Calls choose(particle or null) for each click that is no drag.
export function onPick(viewer, choose) {
  let down = null;
  viewer.canvas.addEventListener('pointerdown', (event) => {
    down = [event.clientX, event.clientY];
  });
  viewer.canvas.addEventListener('pointerup', (event) => {
    if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > kClick) return;
    const box = viewer.canvas.getBoundingClientRect();
    choose(pick(viewer, event.clientX - box.left, event.clientY - box.top));
  });
}
