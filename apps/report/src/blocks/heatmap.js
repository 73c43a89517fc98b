// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Blocks of kind "heatmap": numbers over (u, v), or over any two axes; one map, or one a frame that
// follows the clock. Maps of one group share their colours.
import { cssGradient, kUnknown, mapColour } from '../colours.js';
import { h, onSeen, whenNear } from '../dom.js';
import { number, unitText } from '../format.js';

function frameOf(block, frame) {
  return block.frames ? block.values[Math.min(frame, block.values.length - 1)] : block.values;
}

function rangeOf(blocks) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of blocks.flatMap((block) => block.values.flat(2))) {
    if (value === null) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  const isDiverging = blocks[0].diverging;
  const most = Math.max(Math.abs(low), Math.abs(high)) || 1;
  return isDiverging ? [-most, most] : [Math.min(0, low), high > low ? high : low + 1];
}

function paint(canvas, rows, range, isDiverging) {
  canvas.width = rows[0].length;
  canvas.height = rows.length;
  const context = canvas.getContext('2d');
  const image = context.createImageData(canvas.width, canvas.height);
  rows.forEach((row, j) => row.forEach((value, i) => {
    const rgb = value === null ? kUnknown : mapColour(value, range, isDiverging);
    const at = 4 * (i + (rows.length - 1 - j) * canvas.width);  // v runs upwards
    image.data.set([255 * rgb[0], 255 * rgb[1], 255 * rgb[2], 255], at);
  }));
  context.putImageData(image, 0, 0);
}

function ends(axis) {
  return [number(axis.range[0], 3), `${axis.title}${axis.unit ? `, ${axis.unit}` : ''}`,
    number(axis.range[1], 3)];
}

export function heatmapBlock(block, { player, section }) {
  const canvas = h('canvas', { role: 'img', 'aria-label': `${block.value.title}: ${block.title}` });
  const readout = h('span', { class: 'readout' }, '\u00a0');
  const group = section.blocks.filter((other) =>
    other === block || (block.group && other.kind === 'heatmap' && other.group === block.group));
  const range = rangeOf(group);
  const unit = unitText(block.value.unit);
  canvas.addEventListener('pointermove', (event) => {
    const rows = frameOf(block, player.frame);
    const box = canvas.getBoundingClientRect();
    const i = Math.floor(((event.clientX - box.left) / box.width) * rows[0].length);
    const j = Math.floor((1 - (event.clientY - box.top) / box.height) * rows.length);
    const value = rows[j]?.[i];
    readout.textContent = value === undefined ? '\u00a0'
      : `${number(value, 3)} ${value === null ? '' : unit}`;
  });
  canvas.addEventListener('pointerleave', () => { readout.textContent = '\u00a0'; });
  const draw = (frame) => paint(canvas, frameOf(block, frame), range, block.diverging);
  const size = (axis) => axis.range[1] - axis.range[0] || 1;
  canvas.style.aspectRatio = block.stretch ? '1' : `${Math.max(0.4, Math.min(2.5, size(block.u) / size(block.v)))}`;
  const element = h('figure', { class: 'chart heatmap' },
    h('figcaption', {}, block.title, readout),
    h('div', { class: 'heat-body' },
      h('div', { class: 'heat-v' }, ends(block.v).reverse().map((text) => h('span', {}, text))),
      canvas,
      h('div', { class: 'heat-u' }, ends(block.u).map((text) => h('span', {}, text)))),
    h('div', { class: 'legend-row' },
      h('span', {}, `${block.value.title}, ${unit}`), h('span', {}, number(range[0], 2)),
      h('span', { class: 'ramp', style: `background: ${cssGradient(block.diverging)}` }),
      h('span', {}, number(range[1], 3))));
  if (block.frames) {
    let isSeen = false;
    onSeen(element, (seen) => {
      isSeen = seen;
      if (seen) draw(player.frame);
    });
    player.onFrame((frame) => { if (isSeen) draw(frame); });
  } else {
    whenNear(element, () => draw(0));
  }
  return element;
}
