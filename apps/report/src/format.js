// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers as people read them.

export function number(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
    return `${Number(mantissa)}×10${superscript(Number(exponent))}`;
  }
  return String(Number(value.toPrecision(digits)));
}

function superscript(exponent) {
  const digits = '⁰¹²³⁴⁵⁶⁷⁸⁹';
  const text = [...String(Math.abs(exponent))].map((digit) => digits[Number(digit)]).join('');
  return (exponent < 0 ? '⁻' : '') + text;
}

export function seconds(value) {
  return `${value.toFixed(2)} s`;
}

// Lengths in mm, shares in %: { factor, unit } to show a quantity of this unit with.
export function shownUnit(unit) {
  if (unit === 'm') return { factor: 1e3, unit: 'mm' };
  if (unit === '1') return { factor: 1e2, unit: '%' };
  return { factor: 1, unit };
}

// m^2 as people write it.
export function unitText(unit) {
  return (unit ?? '').replaceAll('^2', '²').replaceAll('^3', '³');
}

export function quantity(value, unit, digits = 3) {
  const shown = shownUnit(unit);
  return `${number(value * shown.factor, digits)} ${unitText(shown.unit)}`;
}
