// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The one clock of the page: which frame is shown, and whether it runs.

const kSlowly = 120;  // ms

export class Player {
  constructor({ frames, rate }) {
    this.frames = frames;
    this.rate = rate;  // Hz
    this.speed = 1;
    this.frame = 0;
    this.isPlaying = false;
    this.frameListeners = new Set();
    this.stateListeners = new Set();
    this.tick = this.tick.bind(this);
  }

  onFrame(listener) {
    this.frameListeners.add(listener);
    listener(this.frame);
    return () => this.frameListeners.delete(listener);
  }

  // For what nobody reads 30 times a second, such as numbers: while the clock runs only now and then,
  // so that the browser does not draw its part of the page with every picture.
  onFrameSlowly(listener) {
    let last = -Infinity;
    this.onFrame((frame) => {
      const now = performance.now();
      if (this.isPlaying && now - last < kSlowly) return;
      last = now;
      listener(frame);
    });
    this.onState(() => listener(this.frame));
  }

  onState(listener) {
    this.stateListeners.add(listener);
    listener(this);
  }

  seek(frame) {
    const next = Math.max(0, Math.min(this.frames - 1, Math.round(frame)));
    this.exact = next;
    if (next === this.frame) return;
    this.frame = next;
    for (const listener of this.frameListeners) listener(next);
  }

  play() {
    if (this.isPlaying) return;
    this.isPlaying = true;
    this.last = performance.now();
    this.exact = this.frame;
    requestAnimationFrame(this.tick);
    this.tellState();
  }

  pause() {
    this.isPlaying = false;
    this.tellState();
  }

  toggle() {
    if (this.isPlaying) this.pause(); else this.play();
  }

  setSpeed(speed) {
    this.speed = speed;
    this.tellState();
  }

  tellState() {
    for (const listener of this.stateListeners) listener(this);
  }

  tick(now) {
    if (!this.isPlaying) return;
    // A page that was hidden, or busy, goes on where it was rather than jumping.
    const passed = Math.min(0.1, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    this.exact += passed * this.rate * this.speed;
    if (this.exact >= this.frames) this.exact = 0;
    const frame = Math.min(this.frames - 1, Math.floor(this.exact));
    if (frame !== this.frame) {
      this.frame = frame;
      for (const listener of this.frameListeners) listener(frame);
    }
    requestAnimationFrame(this.tick);
  }
}
