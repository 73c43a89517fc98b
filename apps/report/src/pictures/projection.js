// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Cameras as the fit has them: OpenCV's lens, x_camera = R x_world + t.

export function centreOf(camera) {
  const { rotation: r, translation: t } = camera;
  return [0, 1, 2].map((c) => -(r[c] * t[0] + r[3 + c] * t[1] + r[6 + c] * t[2]));
}

// A vector of the camera's frame in the world.
export function toWorld(camera, v) {
  const { rotation: r } = camera;
  return [0, 1, 2].map((c) => r[c] * v[0] + r[3 + c] * v[1] + r[6 + c] * v[2]);
}

// Writes the pixels (x, y) of `count` points and returns which lie before the camera.
export function project(camera, points, begin, count, pixels, inFront) {
  const { rotation: r, translation: t, focal, centre, distortion: [k1, k2, p1, p2, k3] } = camera;
  for (let i = 0; i < count; ++i) {
    const x = points[begin + 3 * i];
    const y = points[begin + 3 * i + 1];
    const z = points[begin + 3 * i + 2];
    const depth = r[6] * x + r[7] * y + r[8] * z + t[2];
    const a = (r[0] * x + r[1] * y + r[2] * z + t[0]) / depth;
    const b = (r[3] * x + r[4] * y + r[5] * z + t[1]) / depth;
    const r2 = a * a + b * b;
    const radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
    pixels[2 * i] = focal[0] * (a * radial + 2 * p1 * a * b + p2 * (r2 + 2 * a * a)) + centre[0];
    pixels[2 * i + 1] =
      focal[1] * (b * radial + p1 * (r2 + 2 * b * b) + 2 * p2 * a * b) + centre[1];
    inFront[i] = depth > 1e-6 ? 1 : 0;
  }
}

// The unit direction in the world of the ray through a pixel, by fixed-point iteration.
export function rayThrough(camera, px, py) {
  const { focal, centre, distortion: [k1, k2, p1, p2, k3] } = camera;
  const x = (px - centre[0]) / focal[0];
  const y = (py - centre[1]) / focal[1];
  let a = x;
  let b = y;
  for (let round = 0; round < 12; ++round) {
    const r2 = a * a + b * b;
    const radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
    [a, b] = [(x - 2 * p1 * a * b - p2 * (r2 + 2 * a * a)) / radial,
      (y - p1 * (r2 + 2 * b * b) - 2 * p2 * a * b) / radial];
  }
  const length = Math.hypot(a, b, 1);
  return toWorld(camera, [a / length, b / length, 1 / length]);
}
