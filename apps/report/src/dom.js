// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Elements in few words.

// h('button', { class: 'x', onclick: f, 'aria-label': 'Play' }, child, ...): children are elements
// or texts; null is left out.
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith('on')) {
      element.addEventListener(name.slice(2), value);
    } else {
      element.setAttribute(name, value === true ? '' : value);
    }
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

// One of several: buttons side by side. `choices`: [{ value, title }].
export function segmented(label, choices, value, onChoose) {
  const buttons = choices.map((choice) =>
    h('button', {
      type: 'button',
      'aria-pressed': String(choice.value === value),
      onclick: () => {
        choices.forEach((other, index) =>
          buttons[index].setAttribute('aria-pressed', String(other === choice)));
        onChoose(choice.value);
      },
    }, choice.title));
  return h('div', { class: 'segmented', role: 'group', 'aria-label': label }, buttons);
}

export function checkbox(title, checked, onChange, swatch) {
  const input = h('input', { type: 'checkbox', checked, onchange: () => onChange(input.checked) });
  const mark = swatch ? h('span', { class: 'swatch', style: `--swatch: ${swatch}` }) : null;
  return h('label', { class: 'check' }, input, mark, h('span', {}, title));
}

export function select(label, choices, value, onChange) {
  const element = h('select', { 'aria-label': label, onchange: () => onChange(element.value) },
    choices.map((choice) =>
      h('option', { value: choice.value, selected: choice.value === value }, choice.title)));
  return element;
}

// What waits until it is seen: functions that show it now.
const waiting = new Set();  // for the first time
const followers = new Set();  // for every frame

// Calls once() when the element first comes near the screen, or when all is to be shown.
export function whenNear(element, once) {
  const show = () => {
    observer.disconnect();
    if (waiting.delete(show)) once();
  };
  const observer = new IntersectionObserver((entries) => {
    if (entries.some((entry) => entry.isIntersecting)) show();
  }, { rootMargin: '300px' });
  waiting.add(show);
  observer.observe(element);
}

// Tells whenever the element comes into view or leaves it. All that is to be shown, such as on
// paper, is told to be seen for a moment.
export function onSeen(element, tell) {
  let isSeen = false;
  new IntersectionObserver((entries) => {
    isSeen = entries[entries.length - 1].isIntersecting;
    tell(isSeen);
  }).observe(element);
  followers.add(() => {
    if (isSeen) return;
    tell(true);
    tell(false);
  });
}

// Shows the next thing that waits; false where nothing did.
export function showNext() {
  const [next] = waiting;
  next?.();
  return Boolean(next);
}

// Shows everything, at the present frame.
export function showAll() {
  while (showNext());
  for (const show of followers) show();
}
