// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Short texts in the 3D view.
import { CanvasTexture, Sprite, SpriteMaterial, SRGBColorSpace } from 'three';

import { colour } from '../theme.js';

const kHeight = 48;     // px of the texture
const kShown = 0.023;   // of the view, whatever the distance

export function makeLabel(text) {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d');
  const font = `600 ${kHeight * 0.6}px system-ui, sans-serif`;
  context.font = font;
  canvas.width = Math.ceil(context.measureText(text).width) + 24;
  canvas.height = kHeight;
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  const object = new Sprite(new SpriteMaterial({
    map: texture, transparent: true, depthWrite: false, sizeAttenuation: false,
  }));
  object.scale.set((kShown * canvas.width) / kHeight, kShown, 1);
  object.center.set(0.5, -0.3);
  const label = {
    object,
    applyTheme() {
      context.clearRect(0, 0, canvas.width, canvas.height);
      context.font = font;
      context.textAlign = 'center';
      context.textBaseline = 'middle';
      context.fillStyle = colour('--ink-soft');
      context.fillText(text, canvas.width / 2, canvas.height / 2);
      texture.needsUpdate = true;
    },
  };
  label.applyTheme();
  return label;
}
