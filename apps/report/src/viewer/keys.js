// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Turning and zooming the 3D view by keys: W, A, S, D, + and -, and 0 for the view at first.
import { Vector3 } from 'three';

const kTurn = (5 * Math.PI) / 180;
const kSteepest = 0.97;  // of the cosine between the line of sight and the vertical

// Turns the eye about the vertical, and up or down as long as it stays beside the vertical.
function turn(viewer, about, upwards) {
  const { eye, controls, home: { up } } = viewer;
  const offset = eye.position.clone().sub(controls.target).applyAxisAngle(up, about);
  const side = new Vector3().crossVectors(offset, up).normalize();
  const lifted = offset.clone().applyAxisAngle(side, upwards);
  const isSteep = Math.abs(lifted.clone().normalize().dot(up)) > kSteepest;
  eye.position.copy(controls.target).add(isSteep ? offset : lifted);
  controls.update();
}

function zoom(viewer, factor) {
  const { eye, controls } = viewer;
  eye.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
  controls.update();
}

export function addViewKeys(viewer) {
  const actions = {
    a: () => turn(viewer, -kTurn, 0),
    d: () => turn(viewer, kTurn, 0),
    w: () => turn(viewer, 0, kTurn),
    s: () => turn(viewer, 0, -kTurn),
    '+': () => zoom(viewer, 0.9),
    '-': () => zoom(viewer, 1 / 0.9),
    0: () => viewer.lookHome(),
  };
  document.addEventListener('keydown', (event) => {
    const isTyping = /^(SELECT|TEXTAREA)$/.test(event.target.tagName);
    if (isTyping || event.ctrlKey || event.metaKey || event.altKey) return;
    actions[event.key.toLowerCase()]?.();
  });
}
