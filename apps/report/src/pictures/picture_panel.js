// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The large picture beside the 3D view, with the choice of camera and overlays; and all cameras
// side by side.
import { checkbox, h, select } from '../dom.js';
import { CameraView, kInk } from './camera_view.js';

function overlayChecks(context) {
  const add = (name, title, swatch) =>
    checkbox(title, context.layers.has(name), (on) => context.setLayer(name, on), swatch);
  const { cameras, motions, observations } = context.report;
  return [
    cameras.some((camera) => camera.outlines) ? add('measured', 'Measured', kInk.measured) : null,
    ...motions.map(({ name, title }) => add(name, title, kInk[name] ?? '#fff')),
    observations.tracks ? add('points', 'Tracks', kInk.miss) : null,
  ];
}

// The camera that sees most: the first one with pictures.
function firstCamera(cameras) {
  return Math.max(0, cameras.findIndex((camera) => camera.pictures));
}

export class PicturePanel {
  constructor(context, player, onCamera) {
    this.onCamera = onCamera;
    const { cameras } = context.report;
    this.index = firstCamera(cameras);
    this.view = new CameraView(context, this.index, player);
    this.choice = select('Camera', cameras.map((camera, index) => ({
      value: String(index),
      title: camera.name + (camera.held_out ? ' (held out)' : ''),
    })), String(this.index), (value) => this.setCamera(Number(value)));
    this.element = h('figure', { class: 'panel picture-panel' },
      h('div', { class: 'view', id: 'view-picture' }, this.view.element),
      h('figcaption', { class: 'controls' },
        h('label', { class: 'field-choice' }, h('span', {}, 'Camera'), this.choice),
        h('span', { class: 'checks' }, overlayChecks(context))));
  }

  setCamera(index) {
    this.index = index;
    this.choice.value = String(index);
    this.view.setCamera(index);
    this.onCamera(index);
  }
}

// The block of kind "cameras".
export function cameraGrid(context, player, panel) {
  const views = context.report.cameras.map((camera, index) => {
    const view = new CameraView(context, index, player, { maxWidth: 480 });
    return h('button', {
      type: 'button', class: 'camera-tile', title: `Show ${camera.name} beside the 3D view`,
      onclick: () => {
        panel.setCamera(index);
        panel.element.scrollIntoView({ behavior: 'smooth', block: 'center' });
      },
    }, view.element, h('span', { class: 'camera-name' }, camera.name,
      camera.held_out ? h('em', {}, ' held out') : null));
  });
  return h('div', { class: 'camera-grid' }, views);
}
