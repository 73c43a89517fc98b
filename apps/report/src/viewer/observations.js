// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What was measured, found again by frame: markers, tracks, and the cloth's points they belong to.
import { decode } from '../data.js';

// first[f]: index of the first item of frame f; items are in the order of frames.
function firstOfFrames(items, width, frames) {
  const first = new Int32Array(frames + 1);
  for (let i = 0; i < items.length; i += width) ++first[items[i] + 1];
  for (let f = 0; f < frames; ++f) first[f + 1] += first[f];
  return first;
}

export async function loadObservations(report) {
  const { points, markers, tracks } = report.observations;
  const frames = report.clock.frames;
  const loaded = {
    nodes: await decode(points.nodes), weights: await decode(points.weights),
    markers: null, tracks: null,
  };
  if (markers) {
    const items = await decode(markers.items);
    loaded.markers = {
      items, first: firstOfFrames(items, 2, frames), positions: await decode(markers.positions),
    };
  }
  if (tracks) {
    const items = await decode(tracks.items);
    loaded.tracks = {
      items, first: firstOfFrames(items, 3, frames), pixels: await decode(tracks.pixels),
    };
  }
  return loaded;
}

// The place of a point of the cloth, written to target[at..at+2]. `begin`: where the frame's
// positions begin.
export function pointOnCloth(observations, point, positions, begin, target, at) {
  for (let c = 0; c < 3; ++c) {
    let sum = 0;
    for (let k = 0; k < 3; ++k) {
      const node = observations.nodes[3 * point + k];
      sum += observations.weights[3 * point + k] * positions[begin + 3 * node + c];
    }
    target[at + c] = sum;
  }
}
