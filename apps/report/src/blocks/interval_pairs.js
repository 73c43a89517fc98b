// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Blocks of kind "interval_pairs": what two runs found for the same quantities, one axis a quantity,
// one bar a run.
import { h } from '../dom.js';
import { number, unitText } from '../format.js';
import { axisEnds, axisOf, clipped, mark, span } from './intervals.js';

const kRoles = ['before', 'after'];  // have colours of their own

function sideOnAxis(axis, side, item, index) {
  return h('span', { class: `axis-line of-${kRoles[index]} ${side.muted ? 'muted' : ''}` },
    side.interval ? span(axis, side.interval, 'posterior', item) : null,
    mark(axis, item.truth, 'truth', 'truth'), mark(axis, side.value, 'value', 'value'));
}

function sideInWords(side, item, name, index) {
  const [lower, upper] = side.interval ?? [];
  return h('span', { class: `pair-side ${side.muted ? 'muted' : ''}` },
    h('span', { class: `pair-name is-${kRoles[index]}` }, name),
    h('span', {}, h('strong', {}, number(side.value)),
      ` ${item.unit === '1' ? '' : unitText(item.unit)}`,
      side.interval ? h('small', {}, `${number(lower)} … ${number(upper)}`) : null,
      side.note ? h('small', { class: 'note' }, side.note) : null));
}

function row(item, names) {
  const axis = axisOf(item, [...item.sides.flatMap((side) =>
    [side.value, ...(side.interval ?? []).map((value) => clipped(item, value))]), item.truth]);
  return h('div', { class: `interval-row ${item.marked ? 'marked' : ''}`, role: 'listitem' },
    h('span', { class: 'interval-name' }, h('code', {}, item.name),
      item.doc ? h('small', {}, item.doc) : null,
      item.difference ? h('small', { class: 'pair-difference' }, item.difference) : null),
    h('span', { class: 'interval-axis' },
      item.sides.map((side, index) => sideOnAxis(axis, side, item, index)), axisEnds(axis, item)),
    h('span', { class: 'interval-value' },
      item.sides.map((side, index) => sideInWords(side, item, names[index], index))));
}

export function intervalPairsBlock(block) {
  const hasTruth = block.items.some((item) => Number.isFinite(item.truth));
  const key = block.names.map((name, index) =>
    h('span', { class: `of-${kRoles[index]}` }, h('span', { class: 'key-mark posterior' }), name));
  if (hasTruth) key.push(h('span', {}, h('span', { class: 'key-mark truth' }), 'truth'));
  return h('figure', { class: 'intervals pairs' }, h('figcaption', { class: 'key' }, key),
    h('div', { role: 'list' }, block.items.map((item) => row(item, block.names))));
}
