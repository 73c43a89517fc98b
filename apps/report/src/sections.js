// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The sections below the first screen, from data: a section is a title, a line, and blocks of the
// kinds below. Unknown kinds say so and harm nothing.
import { barsBlock } from './blocks/bars.js';
import { heatmapBlock } from './blocks/heatmap.js';
import { intervalPairsBlock } from './blocks/interval_pairs.js';
import { intervalsBlock } from './blocks/intervals.js';
import { linesBlock } from './blocks/lines.js';
import { pictureBlock } from './blocks/picture.js';
import { tableBlock } from './blocks/table.js';
import { codeBlock, headingBlock, textBlock } from './blocks/text.js';
import { h } from './dom.js';
import { cameraGrid } from './pictures/picture_panel.js';

const kBlocks = {
  text: textBlock,
  heading: headingBlock,
  picture: pictureBlock,
  table: tableBlock,
  code: codeBlock,
  lines: linesBlock,
  bars: barsBlock,
  intervals: intervalsBlock,
  interval_pairs: intervalPairsBlock,
  heatmap: heatmapBlock,
  cameras: (_, { pictures, player, picturePanel }) => cameraGrid(pictures, player, picturePanel),
};

// Blocks that are narrow enough to stand beside one another.
const kNarrow = new Set(['lines', 'heatmap']);

const isMap = (block) => block.kind === 'heatmap';

function makeBlock(block, context) {
  const make = kBlocks[block.kind];
  const element = make ? make(block, context)
    : h('p', {}, `This page does not know blocks of the kind "${block.kind}".`);
  element.classList.add(block.narrow ?? kNarrow.has(block.kind) ? 'narrow' : 'wide');
  return element;
}

export function makeSection(section, context) {
  return h('section', { class: 'card', id: section.id, 'aria-labelledby': `${section.id}-title` },
    h('h2', { id: `${section.id}-title` }, section.title),
    section.lead ? h('p', { class: 'lead' }, section.lead) : null,
    h('div', { class: section.blocks.filter(isMap).length > 2 ? 'blocks maps' : 'blocks' },
      section.blocks.map((block) => makeBlock(block, { ...context, section }))));
}

export function makeLinks(sections) {
  return h('nav', { 'aria-label': 'Sections' },
    sections.map((section) => h('a', { href: `#${section.id}` }, section.short ?? section.title)));
}
