// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What is known of one particle at the frame that is shown.
import { Vector3 } from 'three';

import { decode } from '../data.js';
import { h } from '../dom.js';
import { number, quantity } from '../format.js';

export class Probe {
  // `uv`: of the particles, m.
  constructor(fields, uv, onClose) {
    this.fields = fields;
    this.uv = uv;
    this.onClose = onClose;
    this.element = h('div', { class: 'probe', role: 'status', hidden: true });
  }

  // `particle`: null for none; `panes`: those that are shown.
  async show(particle, frame, panes) {
    const asked = `${particle} ${frame} ${panes.length}`;
    this.asked = asked;
    this.element.hidden = particle === null;
    if (particle === null) return;
    const shown = panes.filter((pane) => frame < pane.cloth.frames);
    const rows = [placeRow(particle, shown)];
    for (const field of this.fields) {
      const values = await Promise.all(shown.map(async ({ motion, cloth }) => {
        const block = field.values[motion.name];
        return block ? (await decode(block))[cloth.particles * frame + particle] : NaN;
      }));
      rows.push([field.title, ...values.map((value) => quantity(value, field.unit))]);
    }
    if (this.asked === asked) this.fill(particle, shown, rows);
  }

  fill(particle, shown, rows) {
    const [u, v] = [this.uv[2 * particle], this.uv[2 * particle + 1]];
    const head = ['', ...shown.map((pane) => pane.motion.title)];
    this.element.replaceChildren(
      h('strong', {}, `Particle ${particle}`),
      h('span', {}, ` (u, v) = (${number(u, 3)}, ${number(v, 3)}) m`),
      h('button', { type: 'button', 'aria-label': 'Close', onclick: this.onClose }, '×'),
      h('table', {}, h('tr', {}, head.map((text) => h('th', {}, text))),
        rows.map((row) => h('tr', {}, row.map((text) => h('td', {}, text))))));
  }
}

function placeRow(particle, shown) {
  const place = new Vector3();
  return ['place', ...shown.map(({ cloth }) => {
    const numbers = cloth.positionAt(particle, place).toArray();
    return `${numbers.map((coordinate) => coordinate.toFixed(3)).join(', ')} m`;
  })];
}
