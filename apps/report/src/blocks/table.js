// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Blocks of kind "table". One that can be sorted has buttons for heads: the first click sorts from
// small to large, the next from large to small; what is not known stays last.
import { h } from '../dom.js';
import { number } from '../format.js';
import { folded } from './text.js';

// A text that leads to another page beside this one is { text, href }; no other place is led to.
function link({ text, href }) {
  return href.startsWith('./') ? h('a', { href }, text) : text;
}

function cell(value, column) {
  if (value?.href) return h('td', {}, link(value));
  const text = typeof value === 'number' ? number(value) : value ?? '–';
  const content = column.code ? h('code', {}, text) : String(text);
  return h('td', { class: column.number ? 'number' : column.wide ? 'wide-cell' : null }, content);
}

function titleOf(column) {
  return column.unit ? `${column.title}, ${column.unit}` : column.title;
}

// Texts by their leading number where they have one, such as "12 (3 to 40)".
function keyOf(value) {
  if (typeof value === 'number') return value;
  if (value?.href) return value.text;
  const leading = Number.parseFloat(value);
  return Number.isFinite(leading) ? leading : String(value);
}

function compare(a, b) {
  const [left, right] = [keyOf(a), keyOf(b)];
  if (typeof left === typeof right) return left < right ? -1 : Number(left > right);
  return typeof left === 'number' ? -1 : 1;
}

const isUnknown = (value) => value === null || value === '' || value === '-';

function sorted(rows, index, sign) {
  const known = rows.filter((row) => !isUnknown(row[index]));
  known.sort((a, b) => sign * compare(a[index], b[index]));
  return [...known, ...rows.filter((row) => isUnknown(row[index]))];
}

function head(block, index, onSort) {
  const column = block.columns[index];
  const content = block.sortable
    ? h('button', { type: 'button', class: 'sort', onclick: () => onSort(index) }, titleOf(column))
    : titleOf(column);
  return h('th', { class: column.number ? 'number' : null, scope: 'col' }, content);
}

export function tableBlock(block) {
  const body = h('tbody');
  const fill = (rows) => body.replaceChildren(...rows.map((row) =>
    h('tr', {}, row.map((value, index) => cell(value, block.columns[index])))));
  let order = { index: -1, sign: 1 };
  const heads = block.columns.map((_, index) => head(block, index, (chosen) => {
    order = { index: chosen, sign: order.index === chosen ? -order.sign : 1 };
    heads.forEach((element, k) => element.setAttribute('aria-sort',
      k !== chosen ? 'none' : order.sign > 0 ? 'ascending' : 'descending'));
    fill(sorted(block.rows, order.index, order.sign));
  }));
  fill(block.rows);
  const hasTitles = block.columns.some((column) => column.title);
  return folded(block, h('div', { class: 'table-scroll', tabindex: 0 },
    h('table', {}, hasTitles ? h('thead', {}, h('tr', {}, heads)) : null, body)));
}
