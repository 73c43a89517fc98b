// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How many pixels the 3D view can afford: all of them at rest; fewer while it moves and pictures
// come later than they are wanted.
const kLate = 1.25;     // times the wanted interval
const kLeast = 0.45;    // of the pixels' side
const kStep = 0.8;
const kJudged = 6;      // pictures between two changes

export class Pace {
  // `first`: the share that a movement begins with.
  constructor(first) {
    this.share = first;
    this.isMoving = false;
  }

  // `wanted`: s between pictures.
  move(isMoving, wanted) {
    this.isMoving = isMoving;
    this.wanted = Math.max(1 / 60, wanted);
    this.last = null;
    this.intervals = [];
  }

  // Tells of a picture; true where the share has changed. The median passes over a single pause.
  drawn(now) {
    if (!this.isMoving) return false;
    if (this.last !== null) this.intervals.push((now - this.last) / 1000);
    this.last = now;
    if (this.intervals.length < kJudged) return false;
    const middle = [...this.intervals].sort((a, b) => a - b)[kJudged >> 1];
    this.intervals = [];
    if (middle < kLate * this.wanted || this.share <= kLeast) return false;
    this.share = Math.max(kLeast, kStep * this.share);
    return true;
  }

  get now() {
    return this.isMoving ? this.share : 1;
  }
}
