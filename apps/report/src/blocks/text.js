// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Blocks of words: paragraphs, a file's text, a table.
import { h } from '../dom.js';
import { number } from '../format.js';

function folded(block, content) {
  if (!block.folded) {
    return block.title
      ? h('div', {}, h('p', { class: 'block-title' }, block.title), content) : content;
  }
  return h('details', { class: 'folded' }, h('summary', {}, block.title), content);
}

export function textBlock(block) {
  return h('div', { class: 'prose' }, block.paragraphs.map((text) => h('p', {}, text)));
}

export function codeBlock(block) {
  return folded(block, h('pre', { tabindex: 0 }, h('code', {}, block.text)));
}

function cell(value, column) {
  const text = typeof value === 'number' ? number(value) : value ?? '–';
  const content = column.code ? h('code', {}, text) : String(text);
  return h('td', { class: column.number ? 'number' : null }, content);
}

export function tableBlock(block) {
  const titles = block.columns.some((column) => column.title)
    ? h('thead', {}, h('tr', {}, block.columns.map((column) =>
      h('th', { class: column.number ? 'number' : null, scope: 'col' },
        column.unit ? `${column.title}, ${column.unit}` : column.title)))) : null;
  const rows = block.rows.map((row) =>
    h('tr', {}, row.map((value, index) => cell(value, block.columns[index]))));
  return folded(block, h('div', { class: 'table-scroll', tabindex: 0 },
    h('table', {}, titles, h('tbody', {}, rows))));
}
