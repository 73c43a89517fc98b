// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Light or dark: as the system has it, or as chosen here.
import { h } from './dom.js';

const listeners = new Set();
const kKey = 'clothfit-report-theme';

function stored() {
  try {
    return localStorage.getItem(kKey);
  } catch {
    return null;  // pages from disk may have no storage
  }
}

function store(theme) {
  try {
    localStorage.setItem(kKey, theme);
  } catch { /* the choice then holds for this visit */ }
}

export function isDark() {
  return document.documentElement.dataset.theme === 'dark';
}

export function onTheme(listener) {
  listeners.add(listener);
}

// The value of a colour of the style sheet, such as '--after'.
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

function apply(theme) {
  document.documentElement.dataset.theme = theme;
  for (const listener of listeners) listener();
}

// Sets a theme for the time being; returns what sets the one before again.
export function withTheme(theme) {
  const before = document.documentElement.dataset.theme;
  apply(theme);
  return () => apply(before);
}

export function makeThemeButton() {
  const system = matchMedia('(prefers-color-scheme: dark)');
  apply(stored() ?? (system.matches ? 'dark' : 'light'));
  system.addEventListener('change', () => {
    if (!stored()) apply(system.matches ? 'dark' : 'light');
  });
  return h('button', {
    type: 'button', class: 'theme', 'aria-label': 'Light or dark', title: 'Light or dark',
    onclick: () => {
      store(isDark() ? 'light' : 'dark');
      apply(isDark() ? 'light' : 'dark');
    },
  }, '◐');
}
