// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The pictures of one camera, decoded when they are wanted and for a while kept.
import { decode } from '../data.js';

const kKept = 90;

export class PictureStore {
  constructor(camera) {
    this.block = camera.pictures;
    this.kept = new Map();  // by index, the oldest first
    this.waiting = new Set();
  }

  get isEmpty() {
    return !this.block;
  }

  // Index of the last picture that is not after the frame.
  indexAt(frame) {
    const { frames } = this.block;
    let index = 0;
    while (index + 1 < frames.length && frames[index + 1] <= frame) ++index;
    return index;
  }

  frameOf(index) {
    return this.block.frames[index];
  }

  // The picture if it is ready; else null, and onReady() is called when it is.
  get(index, onReady) {
    if (this.kept.has(index)) return this.kept.get(index);
    if (!this.waiting.has(index)) this.load(index).then(onReady);
    return null;
  }

  prefetch(index) {
    const { frames } = this.block;
    for (let k = 1; k <= 3; ++k) {
      const next = (index + k) % frames.length;
      if (!this.kept.has(next) && !this.waiting.has(next)) this.load(next);
    }
  }

  async load(index) {
    this.waiting.add(index);
    const bytes = await decode(this.block);
    const { ends } = this.block;
    const jpeg = bytes.subarray(index > 0 ? ends[index - 1] : 0, ends[index]);
    const image = await createImageBitmap(new Blob([jpeg], { type: 'image/jpeg' }));
    this.waiting.delete(index);
    this.kept.set(index, image);
    if (this.kept.size > kKept) {
      const [oldest] = this.kept.keys();
      this.kept.get(oldest).close();
      this.kept.delete(oldest);
    }
  }
}
