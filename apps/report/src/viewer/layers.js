// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the 3D view shows beside the cloth, layer by layer: each has an object to show or hide, and
// most change with the frame.
import {
  BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshLambertMaterial,
} from 'three';

import { decode } from '../data.js';
import { centreOf, rayThrough, toWorld } from '../pictures/projection.js';
import { colour } from '../theme.js';
import { makeLabel } from './label.js';
import { ChangingLines, ChangingPoints } from './lines.js';
import { pointOnCloth } from './observations.js';

// Measured markers, and lines to where the cloth has them.
export function markerLayer(observations, cloth) {
  const { first, items, positions } = observations.markers;
  const isCrowded = positions.length / 3 / (first.length - 1) > 150;  // markers a frame
  const dots = new ChangingPoints('--measured', isCrowded ? 3 : 6);
  const misses = new ChangingLines('--miss');
  const object = new Group();
  object.add(misses.object, dots.object);
  return {
    object,
    parts: [dots, misses],
    setFrame(frame) {
      const [begin, end] = [first[frame], first[frame + 1]];
      dots.set(end - begin, (array) => {
        array.set(positions.subarray(3 * begin, 3 * end));
        return end - begin;
      });
      const reached = frame < cloth.frames ? end : begin;
      misses.set(end - begin, (array) => {
        for (let i = begin; i < reached; ++i) {
          const at = 6 * (i - begin);
          array.set(positions.subarray(3 * i, 3 * i + 3), at);
          pointOnCloth(observations, items[2 * i + 1], cloth.positions,
            3 * cloth.particles * frame, array, at + 3);
        }
        return 2 * (reached - begin);
      });
    },
  };
}

// Rays through the tracks of one camera, from its centre to beside the cloth.
export function rayLayer(observations, cameras, cloth) {
  const rays = new ChangingLines('--ray', 0.45);
  const { first, items, pixels } = observations.tracks;
  return {
    object: rays.object,
    parts: [rays],
    camera: 0,
    setFrame(frame) {
      const camera = cameras[this.camera];
      const centre = centreOf(camera);
      const [begin, end] = [first[frame], frame < cloth.frames ? first[frame + 1] : first[frame]];
      rays.set(end - begin, (array) => {
        let count = 0;
        for (let i = begin; i < end; ++i) {
          if (items[3 * i + 1] !== this.camera) continue;
          const at = 3 * count;
          pointOnCloth(observations, items[3 * i + 2], cloth.positions,
            3 * cloth.particles * frame, array, at);
          const direction = rayThrough(camera, pixels[2 * i], pixels[2 * i + 1]);
          const along = [0, 1, 2].reduce((sum, c) =>
            sum + (array[at + c] - centre[c]) * direction[c], 0);
          for (let c = 0; c < 3; ++c) {
            array[at + c] = centre[c];
            array[at + 3 + c] = centre[c] + along * direction[c];
          }
          count += 2;
        }
        return count;
      });
    },
  };
}

// Cameras as frusta with their names.
export function cameraLayer(cameras, length) {
  const frusta = new ChangingLines('--frustum');
  const object = new Group();
  object.add(frusta.object);
  const parts = [frusta];
  const corners = cameras.map((camera) => {
    const centre = centreOf(camera);
    const [width, height] = camera.size;
    return [[0, 0], [width, 0], [width, height], [0, height]].map(([x, y]) => {
      const v = [(x - camera.centre[0]) / camera.focal[0],
        (y - camera.centre[1]) / camera.focal[1], 1];
      return toWorld(camera, v.map((value) => value * length)).map((value, c) => value + centre[c]);
    });
  });
  frusta.set(8 * cameras.length, (array) => {
    let at = 0;
    cameras.forEach((camera, index) => {
      const centre = centreOf(camera);
      corners[index].forEach((corner, k) => {
        array.set([...centre, ...corner, ...corner, ...corners[index][(k + 1) % 4]], at);
        at += 12;
      });
      const label = makeLabel(camera.name);
      label.object.position.set(...centre);
      object.add(label.object);
      parts.push(label);
    });
    return at / 3;
  });
  return { object, parts, setFrame() {} };
}

// Held points and the paths they take.
export async function handleLayer(handles) {
  const dots = new ChangingPoints('--handle', 11);
  const paths = new ChangingLines('--handle', 0.35);
  const object = new Group();
  object.add(dots.object, paths.object);
  const places = await Promise.all(handles.map((handle) => decode(handle.positions)));
  paths.set(places.reduce((sum, place) => sum + place.length / 3, 0), (array) => {
    let at = 0;
    for (const place of places) {
      for (let i = 3; i < place.length; i += 3) {
        array.set(place.subarray(i - 3, i + 3), at);
        at += 6;
      }
    }
    return at / 3;
  });
  return {
    object,
    parts: [dots, paths],
    setFrame(frame) {
      dots.set(handles.length, (array) => {
        let count = 0;
        handles.forEach((handle, index) => {
          const isHeld = handle.released_after === null || frame <= handle.released_after + 1e-6;
          if (!isHeld || 3 * frame >= places[index].length) return;
          array.set(places[index].subarray(3 * frame, 3 * frame + 3), 3 * count++);
        });
        return count;
      });
    },
  };
}

// Solid things beside the cloth; the positions of one that moves are frames x vertices x 3.
export async function obstacleLayer(obstacles) {
  const object = new Group();
  const movers = [];
  for (const obstacle of obstacles) {
    const positions = await decode(obstacle.positions);
    const count = 3 * obstacle.positions.shape.at(-2);
    const geometry = new BufferGeometry();
    const place = new BufferAttribute(positions.slice(0, count), 3);
    geometry.setAttribute('position', place);
    geometry.setIndex(new BufferAttribute(new Uint32Array(await decode(obstacle.triangles)), 1));
    geometry.computeVertexNormals();
    // Cloth sinks into what gives way, and stays visible there.
    const material = new MeshLambertMaterial({
      color: colour('--obstacle'), side: DoubleSide, transparent: true, opacity: 0.7, depthWrite: false,
    });
    object.add(new Mesh(geometry, material));
    movers.push({ positions, count, place, geometry, material });
  }
  return {
    object,
    parts: movers.map(({ material }) => ({
      applyTheme: () => material.color.set(colour('--obstacle')),
    })),
    setFrame(frame) {
      for (const { positions, count, place, geometry } of movers) {
        const begin = Math.min(frame * count, positions.length - count);
        place.array.set(positions.subarray(begin, begin + count));
        place.needsUpdate = true;
        geometry.boundingSphere = null;
      }
    },
  };
}
