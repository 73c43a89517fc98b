// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the cloth's colours mean.
import { cssGradient } from '../colours.js';
import { h } from '../dom.js';
import { number, shownUnit, unitText } from '../format.js';

export function legendOf(field) {
  const { factor, unit } = shownUnit(field.unit);
  const [low, high] = field.range;
  return [
    h('span', { class: 'legend-title' }, `${field.title}, ${unitText(unit)}`),
    h('span', { class: 'ramp', style: `background: ${cssGradient(field.diverging)}` }),
    h('span', { class: 'legend-ends' }, h('span', {}, number(low * factor, 2)),
      h('span', {}, `${number(high * factor, 2)}${field.diverging ? '' : ' and more'}`)),
  ];
}
