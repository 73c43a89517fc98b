// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The report's data: JSON in one script element, large arrays in others, as blocks. The schema is
// in docs/report-internals.md.
import { unzlibSync } from 'fflate';

const kNoValue = 65535;
const kSteps = 65534;

export function readReport() {
  return JSON.parse(document.getElementById('report-data').textContent);
}

function bytesOf(block) {
  const text = document.getElementById(`blob-${block.blob}`).textContent;
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflate(bytes) {
  if (typeof DecompressionStream === 'undefined') return unzlibSync(bytes);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Byte planes of differences between rows, back to integers.
function unpackRows(planes, count, row, width) {
  const values = width === 2 ? new Uint16Array(count) : new Int32Array(count);
  for (let i = 0; i < count; ++i) {
    let value = i < row ? 0 : values[i - row];
    let difference = 0;
    for (let plane = 0; plane < width; ++plane) {
      difference |= planes[plane * count + i] << (8 * plane);
    }
    value += difference;
    values[i] = value;
  }
  return values;
}

async function decodeBlock(block) {
  const bytes = bytesOf(block);
  if (block.type === 'bytes') return bytes;
  const count = block.shape.reduce((product, size) => product * size, 1);
  const row = block.shape.slice(1).reduce((product, size) => product * size, 1);
  const integers = unpackRows(await inflate(bytes), count, row, block.type === 'u16' ? 2 : 4);
  if (block.type === 'i32') return integers;
  const components = block.shape[block.shape.length - 1];
  const scale = block.lower.map((lower, c) => (block.upper[c] - lower) / kSteps);
  const values = new Float32Array(count);
  for (let i = 0; i < count; ++i) {
    const c = i % components;
    values[i] = integers[i] === kNoValue ? NaN : block.lower[c] + integers[i] * scale[c];
  }
  return values;
}

const decoded = new Map();

// Each block is decoded once, when it is first asked for.
export function decode(block) {
  if (!decoded.has(block.blob)) decoded.set(block.blob, decodeBlock(block));
  return decoded.get(block.blob);
}
