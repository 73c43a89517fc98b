// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The bar at the foot of the page: play, scrub, speed; and the keys that do the same.
import { h, select } from './dom.js';
import { seconds } from './format.js';

const kSpeeds = [0.1, 0.25, 0.5, 1, 2];

function heldOutMarks(clock) {
  const last = Math.max(1, clock.frames - 1);
  return clock.held_out.map(([first, end]) =>
    h('span', {
      class: 'held-out',
      title: 'held out',
      style: `left: ${(100 * first) / last}%; width: ${(100 * (end - first)) / last}%`,
    }));
}

function addKeys(player) {
  const steps = { ArrowLeft: -1, ArrowRight: 1, ',': -1, '.': 1, PageUp: -10, PageDown: 10 };
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const tag = event.target.tagName;
    if (tag === 'INPUT' || tag === 'SELECT' || tag === 'TEXTAREA') return;
    const isButton = tag === 'BUTTON' || tag === 'SUMMARY' || tag === 'A';
    if (event.key === ' ' && !isButton) {
      player.toggle();
    } else if ((event.key === 'ArrowLeft' || event.key === 'ArrowRight') && event.shiftKey) {
      player.seek(player.frame + 10 * steps[event.key]);
    } else if (event.key in steps && !event.key.startsWith('Page')) {
      player.pause();
      player.seek(player.frame + steps[event.key]);
    } else {
      return;
    }
    event.preventDefault();
  });
}

export function makeTransport(player, clock) {
  const play = h('button', { type: 'button', class: 'play', onclick: () => player.toggle() });
  const slider = h('input', {
    type: 'range', min: 0, max: clock.frames - 1, step: 1, value: 0, 'aria-label': 'Frame',
    id: 'frame-slider',
    oninput: () => {
      const frame = Number(slider.value);  // pausing sets the slider to the clock's
      player.pause();
      player.seek(frame);
    },
  });
  const text = h('output', { class: 'now', for: 'frame-slider' });
  const speed = select('Speed',
    kSpeeds.map((value) => ({ value: String(value), title: `${value}×` })), '1',
    (value) => player.setSpeed(Number(value)));
  player.onState(() => {
    play.textContent = player.isPlaying ? '❚❚' : '►';
    play.setAttribute('aria-label', player.isPlaying ? 'Pause' : 'Play');
  });
  player.onFrameSlowly((frame) => {
    slider.value = frame;
    const isHeldOut = clock.held_out.some(([first, last]) => frame >= first && frame <= last);
    const state = isHeldOut ? 'held out' : frame <= clock.last_fitted ? 'fitted' : 'not fitted';
    slider.setAttribute('aria-valuetext', `frame ${frame}, ${state}`);
    text.replaceChildren(
      h('span', { class: 'frame' }, `${frame} / ${clock.frames - 1}`),
      h('span', { class: 'time' }, seconds(frame / clock.rate)),
      h('span', { class: `state ${isHeldOut ? 'is-held-out' : ''}` }, state));
  });
  addKeys(player);
  return h('div', { class: 'transport', role: 'group', 'aria-label': 'Time' },
    play, h('div', { class: 'track' }, h('div', { class: 'marks' }, heldOutMarks(clock)), slider),
    text, speed);
}
