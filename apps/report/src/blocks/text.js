// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Blocks of words: paragraphs, a file's text, a heading within a section.
import { h } from '../dom.js';

// A block's content under its title, closed at first where it is folded.
export function folded(block, content) {
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

export function headingBlock(block) {
  return h('h3', { class: 'block-heading' }, block.text);
}
