// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Blocks of kind "bars": one bar an item on a common axis, with intervals where they are known.
import { h } from '../dom.js';
import { number, unitText } from '../format.js';

function ends(block) {
  const values = block.items.flatMap((item) =>
    [item.value, ...(item.interval ?? [])].filter(Number.isFinite));
  return [Math.min(0, ...values), Math.max(0, ...values) || 1];
}

function row(item, block, [low, high]) {
  const share = (value) => `${(100 * (value - low)) / (high - low)}%`;
  const width = (from, to) => `${(100 * Math.abs(to - from)) / (high - low)}%`;
  const left = share(Math.min(0, item.value));
  const [lower, upper] = item.interval ?? [];
  const whisker = Number.isFinite(lower) && Number.isFinite(upper)
    ? h('span', { class: 'whisker', style: `left: ${share(lower)}; width: ${width(lower, upper)}` })
    : null;
  return h('div', { class: `bar-row ${item.muted ? 'muted' : ''} ${item.marked ? 'marked' : ''}`, role: 'listitem' },
    h('span', { class: 'bar-name' }, item.name),
    h('span', { class: 'bar-track' },
      h('span', { class: 'bar', style: `left: ${left}; width: ${width(0, item.value)}` }), whisker),
    h('span', { class: 'bar-value' }, `${number(item.value, 3)} ${unitText(block.unit)}`,
      item.note ? h('small', {}, item.note) : null));
}

export function barsBlock(block) {
  const range = ends(block);
  return h('figure', { class: 'chart' }, h('figcaption', {}, block.title),
    h('div', { class: 'bars', role: 'list' }, block.items.map((item) => row(item, block, range))));
}
