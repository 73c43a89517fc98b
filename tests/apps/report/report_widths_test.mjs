// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// node report_widths_test.mjs MODULES CHROMIUM OUT: every kind of page at the widths of a phone, a
// tablet and a desk, by day and by night. Nothing is wider than the page, the first screen is
// complete, and its words can be read. Leaves a picture of each first screen.
import assert from 'node:assert/strict';
import path from 'node:path';
import { launch } from './browser.mjs';

const [modules, executablePath, out] = process.argv.slice(2);
const kScreens = [{ width: 390, height: 844 }, { width: 820, height: 1180 }, { width: 1400, height: 900 }];
const kStill = ['comparison', 'study'];
const { open, browser } = await launch(modules, executablePath, out);

// The page's sections are drawn when they come into view, and may be too wide only then.
async function pxTooWide(page) {
  const ids = await page.$$eval('section.card', (sections) => sections.map(({ id }) => id));
  assert.ok(ids.length >= 2);
  for (const id of ids) {
    await page.evaluate((one) => document.getElementById(one).scrollIntoView({ behavior: 'instant' }), id);
    await page.waitForTimeout(30);
  }
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  // What is drawn meanwhile may move the page on.
  await page.waitForFunction(() => {
    const isAtTop = scrollY === 0;
    scrollTo({ top: 0, behavior: 'instant' });
    return isAtTop;
  }, null, { polling: 100 });
  return wide;
}

// Contrast of each kind of words with the page, after WCAG 2, sec. 1.4.3: 21 is black on white.
const contrastsOf = (page) => page.evaluate(() => {
  const luminance = (color) => color.match(/[\d.]+/g).slice(0, 3).map(Number)
    .map((value) => value / 255)
    .map((value) => (value <= 0.03928 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4))
    .reduce((sum, value, k) => sum + value * [0.2126, 0.7152, 0.0722][k], 0);
  const ground = luminance(getComputedStyle(document.body).backgroundColor);
  return ['h1', '.verdict-words li', '.bar .recording'].map((selector) => {
    const ink = luminance(getComputedStyle(document.querySelector(selector)).color);
    return (Math.max(ink, ground) + 0.05) / (Math.min(ink, ground) + 0.05);
  });
});

// What has to be seen before anything is scrolled lies within the screen, above the clock.
async function checkFirstScreen(page, kind, name) {
  const edges = await page.evaluate(() => Object.fromEntries(
    ['h1', 'table.errors', '#view-3d', '.transport'].map((selector) => {
      const box = document.querySelector(selector)?.getBoundingClientRect();
      return [selector, box && { left: box.left, top: box.top, right: box.right, bottom: box.bottom }];
    })));
  const { width, height } = page.viewportSize();
  const clock = edges['.transport'];
  const lowest = clock ? clock.top : height;
  const needed = ['h1'];
  if (!kStill.includes(kind)) needed.push('#view-3d', '.transport');
  if (!kStill.includes(kind) && kind !== 'recording') needed.push('table.errors');
  for (const selector of needed) {
    const box = edges[selector];
    assert.ok(box && box.bottom > box.top, `${name}: ${selector} is there`);
    assert.ok(box.left >= 0 && box.right <= width + 0.5, `${name}: ${selector} is not cut off`);
    assert.ok(box.top >= 0 && box.bottom <= (selector === '.transport' ? height : lowest) + 0.5,
      `${name}: ${selector} is on the first screen (${box.top.toFixed(0)} to ${box.bottom.toFixed(0)} of ${lowest.toFixed(0)} px)`);
  }
}

let checked = 0;
for (const kind of ['run', 'pair', 'diagnosis', 'recording', ...kStill]) {
  const { page, close } = await open(kind, kScreens[0], 'light', { reducedMotion: 'reduce' });
  for (const screen of kScreens) {
    for (const theme of ['light', 'dark']) {
      const name = `${kind}-${screen.width}-${theme}`;
      await page.setViewportSize(screen);
      await page.emulateMedia({ colorScheme: theme });
      await page.waitForFunction((one) => document.documentElement.dataset.theme === one, theme);
      const wide = await pxTooWide(page);
      assert.ok(wide <= 0, `${name}: nothing is wider than the page (${wide} px)`);
      await checkFirstScreen(page, kind, name);
      for (const contrast of await contrastsOf(page)) {
        assert.ok(contrast >= 4.5, `${name}: words stand out (${contrast.toFixed(1)})`);
      }
      await page.screenshot({ path: path.join(out, `${name}-first-screen.png`) });
      ++checked;
    }
  }
  await close();
}
assert.equal(checked, 36);
await browser.close();
console.log('the pages fit their screens');
