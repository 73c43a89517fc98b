// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The page on paper, or saved as PDF: whole, on white, with the present frame. A browser prints what
// is there when the handler returns, so what takes time to be decoded is made ready before.
import { h, showAll, showNext } from './dom.js';
import { withTheme } from './theme.js';

const kIdle = window.requestIdleCallback ?? ((work) => setTimeout(work, 200));

// One thing at a time, whenever the browser has nothing better to do.
function makeReady(player) {
  const next = () => {
    if (showNext()) kIdle(next, { timeout: 1500 });
    else showAll();
  };
  kIdle(next, { timeout: 3000 });
  player.onState(() => {
    if (!player.isPlaying) kIdle(() => { if (!player.isPlaying) showAll(); }, { timeout: 1500 });
  });
}

// The 3D view's picture; what WebGL drew is gone by the time that a browser prints.
function copyOf(viewer) {
  viewer.draw();
  const { canvas } = viewer;
  const copy = h('canvas', { class: 'on-paper', width: canvas.width, height: canvas.height });
  copy.getContext('2d').drawImage(canvas, 0, 0);
  canvas.after(copy);
  return copy;
}

export function preparePaper(player, viewer) {
  makeReady(player);
  let undo = [];
  window.addEventListener('beforeprint', () => {
    player.pause();
    undo.push(withTheme('light'));
    showAll();
    for (const folded of document.querySelectorAll('details.folded:not([open])')) {
      folded.open = true;
      undo.push(() => { folded.open = false; });
    }
    if (!viewer) return;
    const copy = copyOf(viewer);
    undo.push(() => copy.remove());
  });
  window.addEventListener('afterprint', () => {
    for (const step of undo) step();
    undo = [];
  });
}
