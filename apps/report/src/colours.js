// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Colour maps that stay ordered for every eye and in grey: viridis (van der Walt and Smith 2015, by
// a polynomial of degree 6 that stays within 1 % of it), and blue over white to brown about zero.

const kViridis = [
  [0.2777273272, 0.0054073445, 0.3340998053], [0.1050930431, 1.4046135299, 1.3845901626],
  [-0.3308618287, 0.2148475595, 0.0950951630], [-4.6342304990, -5.7991009734, -19.3324409563],
  [6.2282699363, 14.1799333668, 56.6905526007], [4.7763849977, -13.7451453777, -65.3530326334],
  [-5.4354558559, 4.6458526122, 26.3124352496],
];

function viridis(t) {
  return [0, 1, 2].map((c) => {
    let value = 0;
    for (let k = kViridis.length - 1; k >= 0; --k) value = value * t + kViridis[k][c];
    return Math.max(0, Math.min(1, value));
  });
}

const kDiverging = [
  [0.03, 0.19, 0.42], [0.13, 0.40, 0.68], [0.57, 0.77, 0.87], [0.96, 0.96, 0.95],
  [0.96, 0.73, 0.44], [0.72, 0.36, 0.05], [0.42, 0.19, 0.01],
];

function diverging(t) {
  const place = t * (kDiverging.length - 1);
  const k = Math.min(kDiverging.length - 2, Math.floor(place));
  const share = place - k;
  return [0, 1, 2].map((c) => kDiverging[k][c] * (1 - share) + kDiverging[k + 1][c] * share);
}

export const kUnknown = [0.55, 0.55, 0.55];

// sRGB, 0 to 1, of a value; `range`: what the ends of the map stand for.
export function mapColour(value, range, isDiverging) {
  if (!Number.isFinite(value)) return kUnknown;
  const t = Math.max(0, Math.min(1, (value - range[0]) / (range[1] - range[0] || 1)));
  return isDiverging ? diverging(t) : viridis(t);
}

export function cssColour(rgb) {
  return `rgb(${rgb.map((c) => Math.round(255 * c)).join(' ')})`;
}

// A CSS gradient of the whole map, from left to right.
export function cssGradient(isDiverging) {
  const stops = Array.from({ length: 13 }, (_, k) =>
    cssColour(mapColour(k / 12, [0, 1], isDiverging)));
  return `linear-gradient(to right, ${stops.join(', ')})`;
}
