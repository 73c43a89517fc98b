// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The 3D view with its controls, its legend and what is known of the particle that was picked.
import { Vector3 } from 'three';

import { decode } from '../data.js';
import { checkbox, h, segmented, select } from '../dom.js';
import { centreOf } from '../pictures/projection.js';
import { Cloth } from './cloth.js';
import { groundLayer } from './ground.js';
import { addViewKeys } from './keys.js';
import { cameraLayer, handleLayer, markerLayer, obstacleLayer, rayLayer } from './layers.js';
import { legendOf } from './legend.js';
import { ChangingPoints } from './lines.js';
import { onPick } from './picking.js';
import { Probe } from './probe.js';
import { boxOf, Pane, Viewer } from './viewer.js';

// Layers by name: title, colour, whether shown at first.
const kLayers = {
  markers: ['Markers', '--measured', true],
  rays: ['Rays of the camera beside', '--ray', false],
  handles: ['Handles', '--handle', true],
  cameras: ['Cameras', '--frustum', false],
  ground: ['Ground', '--grid', true],
  obstacles: ['Obstacles', '--obstacle', true],
};

async function makePane(report, motion, observations, up, box) {
  const triangles = await decode(report.mesh.triangles);
  const cloth = new Cloth(report.mesh, triangles, await decode(motion.positions), motion.frames);
  const pane = new Pane(motion, cloth);
  const add = (name, layer) => pane.addLayer(name, layer, kLayers[name][2]);
  add('ground', groundLayer(report.ground, up, box));
  if (report.obstacles.length) add('obstacles', await obstacleLayer(report.obstacles));
  if (observations.markers) add('markers', markerLayer(observations, cloth));
  if (observations.tracks) add('rays', rayLayer(observations, report.cameras, cloth));
  if (report.handles.length) add('handles', await handleLayer(report.handles));
  if (report.cameras.length) {
    add('cameras', cameraLayer(report.cameras, 0.16 * box.getSize(new Vector3()).length()));
  }
  const picked = new ChangingPoints('--picked', 12);
  pane.addLayer('picked', {
    object: picked.object, parts: [picked], particle: null,
    setFrame(frame) {
      const shown = this.particle !== null && frame < cloth.frames;
      picked.set(1, (array) => {
        if (shown) {
          const begin = 3 * (cloth.particles * frame + this.particle);
          array.set(cloth.positions.subarray(begin, begin + 3));
        }
        return shown ? 1 : 0;
      });
    },
  }, true);
  return pane;
}

const kOver = '*over';  // no motion's name

export class ViewPanel {
  static async make(report, observations, player) {
    const up = new Vector3(...report.gravity).negate();
    if (up.length() > 0) up.normalize(); else up.set(0, 0, 1);
    const last = report.motions[report.motions.length - 1];
    const box = boxOf(await decode(last.positions));
    const panes = [];
    for (const motion of report.motions) {
      panes.push(await makePane(report, motion, observations, up, box));
    }
    const uv = await decode(report.mesh.uv);
    return new ViewPanel(report, player, panes, up, box, uv);
  }

  constructor(report, player, panes, up, box, uv) {
    this.report = report;
    this.panes = panes;
    this.particle = null;
    // Where no picture stands beside it, and there is room, the start does.
    const isAlone = report.cameras.length > 0 || matchMedia('(max-width: 480px)').matches;
    this.first = isAlone ? panes[panes.length - 1].motion.name : '';
    if (report.shows_both && panes.length > 1) this.first = kOver;
    this.legend = h('div', { class: 'legend' });
    this.titles = h('div', { class: 'pane-titles', 'aria-hidden': 'true' });
    this.divider = h('div', { class: 'pane-divider' });
    this.probe = new Probe(report.fields, uv, () => this.choose(null));
    this.view = h('div', { class: 'view', id: 'view-3d' }, this.divider, this.titles,
      this.legend, this.probe.element);
    this.viewer = new Viewer(this.view, panes, up, box);
    this.viewer.canvas.setAttribute('aria-label', 'The cloth in 3D: drag to turn, wheel to zoom, ' +
      'right-drag to move, click for the values of a particle; keys W, A, S, D turn, + and - ' +
      'zoom, 0 resets');
    this.element = h('figure', { class: 'panel view-panel' }, this.view, this.controls());
    addViewKeys(this.viewer);
    onPick(this.viewer, (particle) => this.choose(particle));
    this.showMotions(this.first);
    this.showField(report.fields[0]?.name ?? '');
    player.onState(() => this.viewer.play(player.isPlaying, player.rate * player.speed));
    player.onFrame((frame) => {
      this.viewer.setFrame(frame);
      this.updateProbe();
    });
  }

  controls() {
    const names = this.panes.map((pane) => pane.motion);
    const motions = segmented('Which motion',
      [...names.map(({ name, title }) => ({ value: name, title })),
        ...(names.length > 1 ? [{ value: '', title: 'Side by side' }] : []),
        ...(this.report.shows_both ? [{ value: kOver, title: 'Over each other' }] : [])],
      this.first, (name) => this.showMotions(name));
    const fields = select('Colour by',
      [...this.report.fields.map(({ name, title }) => ({ value: name, title })),
        { value: '', title: 'Sides of the cloth' }],
      this.report.fields[0]?.name ?? '', (name) => this.showField(name));
    const layers = Object.entries(kLayers)
      .filter(([name]) => this.panes[0].layers.has(name))
      .map(([name, [title, swatch, shown]]) =>
        checkbox(title, shown, (on) => this.showLayer(name, on), `var(${swatch})`));
    layers.push(checkbox('Threads', true, (on) => {
      for (const pane of this.panes) pane.cloth.threads.visible = on;
      this.viewer.invalidate();
    }, 'var(--thread)'));
    const home = h('button', { type: 'button', onclick: () => this.viewer.lookHome() },
      'Reset view');
    return h('figcaption', { class: 'controls' }, motions,
      h('label', { class: 'field-choice' }, h('span', {}, 'Colour'), fields),
      h('details', { class: 'menu' }, h('summary', {}, 'Layers'), h('div', {}, layers, home)));
  }

  showMotions(name) {
    const isOver = name === kOver;
    const shown = name && !isOver ? [name] : this.panes.map((pane) => pane.motion.name);
    // Two cloths in one place are told apart by a colour each.
    for (const pane of this.panes) pane.cloth.setTint(isOver ? `--${pane.motion.name}` : null);
    this.legend.hidden = isOver;
    this.viewer.show(shown, isOver);
    this.titles.replaceChildren(...this.viewer.shown.map((pane) =>
      h('span', { class: `is-${pane.motion.name}` }, pane.motion.title)));
    this.divider.hidden = this.viewer.columns() < 2;
    this.updateProbe();
  }

  showLayer(name, on) {
    for (const pane of this.panes) {
      if (pane.layers.has(name)) pane.layers.get(name).object.visible = on;
    }
    if (name === 'cameras' && on) this.viewer.stepBack(this.report.cameras.map(centreOf));
    this.viewer.refresh();
  }

  // The camera whose rays are drawn.
  setCamera(index) {
    for (const pane of this.panes) {
      if (pane.layers.has('rays')) pane.layers.get('rays').camera = index;
    }
    this.viewer.refresh();
  }

  async showField(name) {
    const field = this.report.fields.find((one) => one.name === name) ?? null;
    this.field = field;
    for (const pane of this.panes) {
      const block = field?.values[pane.motion.name];
      const values = block ? await decode(block) : null;
      if (this.field !== field) return;
      pane.cloth.setField(field, values);
    }
    this.legend.replaceChildren(...(field ? legendOf(field) : []));
    this.viewer.invalidate();
    this.updateProbe();
  }

  choose(particle) {
    this.particle = particle;
    for (const pane of this.panes) pane.layers.get('picked').particle = particle;
    this.viewer.refresh();
    this.updateProbe();
  }

  updateProbe() {
    this.probe.show(this.particle, this.viewer.frame, this.viewer.shown);
  }
}
