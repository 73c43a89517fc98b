// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Blocks of kind "picture": a file in SVG or PNG as it is, on white as it was drawn.
import { decode } from '../data.js';
import { h, whenNear } from '../dom.js';

export function pictureBlock(block) {
  const image = h('img', { alt: block.title });
  const element = h('figure', { class: 'chart picture' }, h('figcaption', {}, block.title), image);
  whenNear(element, async () => {
    const blob = new Blob([await decode(block.image)], { type: block.type });
    image.src = URL.createObjectURL(blob);
  });
  return element;
}
