// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Blocks of kind "intervals": quantities with units of their own, each on its own axis: what was
// known before, what is known after, the start, the value and, where it is known, the truth.
import { h } from '../dom.js';
import { number, unitText } from '../format.js';

// Maps a value to a share of the row's axis, which holds `shown` and little more. `item`: its scale
// and bounds.
export function axisOf(item, shown) {
  const isLog = item.scale === 'log';
  const to = (value) => (isLog ? Math.log(value) : value);
  const from = (value) => (isLog ? Math.exp(value) : value);
  const isUsable = (value) => Number.isFinite(value) && (!isLog || value > 0);
  const values = shown.filter(isUsable).map(to);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const margin = 0.04 * (high - low) || 1;
  const share = (value) => {
    if (!Number.isFinite(value)) return null;
    const place = isUsable(value) ? to(value) : low - margin;
    return (100 * (place - low + margin)) / (high - low + 2 * margin);
  };
  return { share, ends: [from(low), from(high)] };
}

// An end of an interval that is not beyond what is possible.
export function clipped(item, value) {
  return value === null ? null : Math.min(item.bounds[1], Math.max(item.bounds[0], value));
}

export function span(axis, [lower, upper], kind, item) {
  const [left, right] = [axis.share(Math.max(lower ?? -Infinity, item.bounds[0])),
    axis.share(Math.min(upper ?? Infinity, item.bounds[1]))];
  if (left === null || right === null) return null;
  const from = Math.max(0, left);
  const width = Math.min(100, right) - from;
  return h('span', { class: kind, style: `left: ${from}%; width: ${width}%` });
}

export function mark(axis, value, kind, title) {
  const place = axis.share(value);
  return place === null || value === null ? null
    : h('span', { class: kind, style: `left: ${place}%`, title: `${title}: ${number(value)}` });
}

export function axisEnds(axis, item) {
  return h('span', { class: 'axis-ends' }, h('span', {}, number(axis.ends[0], 2)),
    h('span', {}, item.scale === 'log' ? 'log' : ''), h('span', {}, number(axis.ends[1], 2)));
}

function row(item) {
  const axis = axisOf(item, [
    ...[...(item.prior ?? []), ...(item.interval ?? [])].map((value) => clipped(item, value)),
    item.value, item.start, item.truth]);
  const [lower, upper] = item.interval ?? [null, null];
  return h('div', { class: `interval-row ${item.muted ? 'muted' : ''}`, role: 'listitem' },
    h('span', { class: 'interval-name' }, h('code', {}, item.name),
      item.doc ? h('small', {}, item.doc) : null),
    h('span', { class: 'interval-axis' },
      h('span', { class: 'axis-line' },
        item.prior ? span(axis, item.prior, 'prior', item) : null,
        item.interval ? span(axis, item.interval, 'posterior', item) : null,
        mark(axis, item.start, 'start', 'start'), mark(axis, item.truth, 'truth', 'truth'),
        mark(axis, item.value, 'value', 'value')),
      axisEnds(axis, item)),
    h('span', { class: 'interval-value' },
      h('strong', {}, number(item.value)), ` ${item.unit === '1' ? '' : unitText(item.unit)}`,
      item.interval ? h('small', {}, `${number(lower)} … ${number(upper)}`) : null,
      item.note ? h('small', { class: 'note' }, item.note) : null));
}

export function intervalsBlock(block) {
  const hasTruth = block.items.some((item) => Number.isFinite(item.truth));
  const hasPrior = block.items.some((item) => item.prior);
  const key = [...(hasPrior ? [['prior', 'before the fit']] : []),
    ['posterior', hasPrior ? 'after it' : 'interval'], ['start', block.start ?? 'start'],
    ['value', 'value'], ...(hasTruth ? [['truth', 'truth']] : [])];
  return h('figure', { class: 'intervals' },
    h('figcaption', { class: 'key' }, key.map(([kind, title]) =>
      h('span', {}, h('span', { class: `key-mark ${kind}` }), title))),
    h('div', { role: 'list' }, block.items.map(row)));
}
