// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// node report_page_test.mjs MODULES CHROMIUM OUT: opens the pages OUT/run.html, pair.html,
// diagnosis.html, comparison.html and study.html from disk and uses them as a person does. Leaves a picture of every
// section, by day, by night and at the width of a phone.
import assert from 'node:assert/strict';
import path from 'node:path';
import { launch } from './browser.mjs';

const [modules, executablePath, out] = process.argv.slice(2);
const kDesk = { width: 1440, height: 900 };
const kPhone = { width: 390, height: 844 };
const { open, browser } = await launch(modules, executablePath, out);

const frameOf = (page) => page.evaluate(() => clothfit.player.frame);

// What both views show: the 3D view's frame, and the picture's pixels.
const viewsOf = (page) => page.evaluate(() => {
  const canvas = clothfit.picturePanel.view.canvas;
  return { frame: clothfit.viewPanel.viewer.frame, picture: canvas.toDataURL().length + ':' +
    canvas.toDataURL().slice(-4000) };
});

async function testPlaying() {
  const { page, close } = await open('run', kDesk, 'light');
  const drawn = () => page.evaluate(() => [clothfit.viewPanel.viewer.frames, performance.now()]);
  const [begin, beginTime] = await drawn();
  // However slow the machine is: frames come.
  await page.waitForFunction((least) => clothfit.viewPanel.viewer.frames >= least, begin + 20,
    { timeout: 60000 });
  const [end, endTime] = await drawn();
  const rate = (1000 * (end - begin)) / (endTime - beginTime);
  const paint = await page.evaluate(() =>
    performance.getEntriesByName('first-contentful-paint')[0]?.startTime);
  console.log(`first paint ${Math.round(paint)} ms, ${rate.toFixed(1)} frames/s drawn`);
  await page.keyboard.press(' ');
  const paused = await frameOf(page);
  await page.waitForTimeout(300);
  assert.equal(await frameOf(page), paused, 'the space bar pauses');
  await page.evaluate(() => clothfit.player.seek(5));  // wherever it paused, the last frame may be
  await page.keyboard.press('ArrowRight');
  assert.equal(await frameOf(page), 6, 'arrow keys step');
  const eye = () => page.evaluate(() => clothfit.viewPanel.viewer.eye.position.toArray().join());
  const from = await eye();
  await page.keyboard.press('d');
  assert.notEqual(await eye(), from, 'keys turn the view');
  await close();
}

async function testSlider() {
  const { page, close } = await open('run', kDesk, 'light', { reducedMotion: 'reduce' });
  assert.equal(await page.evaluate(() => clothfit.player.isPlaying), false, 'no motion unasked');
  await page.waitForTimeout(500);
  const first = await viewsOf(page);
  await page.locator('#frame-slider').fill('15');
  await page.waitForTimeout(500);
  const second = await viewsOf(page);
  assert.equal(second.frame, 15, 'the slider drives the 3D view');
  assert.notEqual(second.picture, first.picture, 'and the picture');
  await page.locator('#errors').scrollIntoViewIfNeeded();
  await page.waitForSelector('#errors .u-over');
  await page.locator('#errors .u-over').first().click({ position: { x: 5, y: 40 } });
  assert.ok(await frameOf(page) < 3, 'a click on a chart goes to its frame');
  await close();
}

// The recording is synthetic: the page says how many intervals hold its truth.
async function testParameters() {
  const { page, close } = await open('run', kDesk, 'light', { reducedMotion: 'reduce' });
  const text = await page.locator('#parameters').innerText();
  const [, held, known] = text.match(/(\d+) of (\d+) intervals hold the truth\./);
  assert.ok(Number(known) > 0 && Number(held) <= Number(known));
  assert.ok(await page.locator('#parameters .interval-row .truth').count() >= Number(known));
  await close();
}

async function testPicking() {
  const { page, close } = await open('run', kDesk, 'light', { reducedMotion: 'reduce' });
  const place = await page.evaluate(() => {
    const { viewer } = clothfit.viewPanel;
    const { cloth } = viewer.shown[0];
    viewer.draw();
    viewer.eye.updateMatrixWorld();
    const point = cloth.positionAt(Math.floor(cloth.particles / 2), viewer.eye.position.clone());
    point.project(viewer.eye);
    const box = viewer.canvas.getBoundingClientRect();
    return [box.left + (0.5 + 0.5 * point.x) * box.width,
      box.top + (0.5 - 0.5 * point.y) * box.height];
  });
  await page.mouse.click(...place);
  await page.waitForFunction(() => document.querySelector('.probe table'));
  const text = await page.locator('.probe').innerText();
  assert.match(text, /Particle \d+/);
  assert.match(text, /Largest strain/, 'picking shows the values of a particle');
  await page.screenshot({ path: path.join(out, 'picking.png') });
  await close();
}

// The head of a column sorts its table, and sorts it the other way when clicked again.
async function testSorting() {
  const { page, close } = await open('comparison', kDesk, 'light');
  assert.equal(await page.locator('.transport').count(), 0, 'no clock where nothing moves');
  const table = page.locator('#standings table').first();
  const column = () => table.locator('tbody tr td:nth-child(2)').allInnerTexts();
  const first = await column();
  await table.locator('.sort').nth(1).click();
  assert.deepEqual(await column(), first, 'the least error stands first already');
  await table.locator('.sort').nth(1).click();
  assert.deepEqual(await column(), [...first].reverse());
  await page.locator('#errors').scrollIntoViewIfNeeded();
  await page.waitForSelector('#errors .u-over');
  await close();
}

// The map of the missing force follows the clock, and the 3D view can be coloured by it.
async function testDiagnosis() {
  const { page, close } = await open('diagnosis', kDesk, 'light', { reducedMotion: 'reduce' });
  const fields = await page.getByLabel('Colour by').locator('option').allInnerTexts();
  assert.ok(fields.includes('Missing force'));
  await page.getByLabel('Colour by').selectOption('missing_force');
  await page.waitForFunction(() => document.querySelector('.legend').innerText.includes('force'));
  assert.equal(await page.locator('#ranking .marked').count(), 4, 'wind and gust, twice');
  await close();
}

// Two runs: both cloths in one view, or apart; both intervals on one axis; both errors in one chart.
async function testPair() {
  const { page, close } = await open('pair', kDesk, 'light', { reducedMotion: 'reduce' });
  const view = () => page.evaluate(() => {
    const { viewer } = clothfit.viewPanel;
    return [viewer.shown.length, viewer.columns(), viewer.panes.map(({ cloth }) => cloth.tint)];
  });
  assert.deepEqual(await view(), [2, 1, ['--before', '--after']], 'over each other at first');
  assert.equal(await page.locator('.legend').isVisible(), false);
  // A frame in which they differ: each alone, and both together, are three pictures.
  const pictures = [];
  for (const title of ['run', 'other', 'Over each other']) {
    await page.locator('.view-panel .segmented').getByText(title, { exact: true }).click();
    await page.evaluate(() => clothfit.player.seek(20));
    await page.waitForTimeout(300);
    pictures.push(await page.evaluate(() => {
      clothfit.viewPanel.viewer.draw();
      return clothfit.viewPanel.viewer.canvas.toDataURL();
    }));
  }
  assert.equal(new Set(pictures).size, 3);
  await page.getByText('Side by side').click();
  assert.deepEqual(await view(), [2, 2, [null, null]]);
  await page.getByLabel('Colour by').selectOption('apart');
  await page.waitForFunction(() => document.querySelector('.legend').innerText.includes('Distance'));
  const rows = page.locator('#parameters .interval-row');
  assert.ok(await rows.count() >= 5);
  for (let i = 0; i < await rows.count(); ++i) {
    assert.equal(await rows.nth(i).locator('.axis-line').count(), 2);
    assert.equal(await rows.nth(i).locator('.pair-side').count(), 2);
  }
  await page.locator('#errors').scrollIntoViewIfNeeded();
  await page.waitForSelector('#errors .u-over');
  const series = await page.locator('#errors .chart').first().locator('.u-series').allInnerTexts();
  assert.ok(series.some((text) => /run/.test(text)) && series.some((text) => /other/.test(text)));
  await close();
}

// What is on paper, by day though the screen is dark, without having been scrolled to; and that the
// screen is as before.
async function testPaper(kind) {
  const { page, close } = await open(kind, kDesk, 'dark', { reducedMotion: 'reduce' });
  const isStill = kind === 'study' || kind === 'comparison';
  if (!isStill) await page.evaluate(() => clothfit.player.seek(14));
  await page.waitForFunction(() =>
    [...document.querySelectorAll('img')].every((image) => image.naturalWidth > 0));
  await page.waitForTimeout(500);
  await page.evaluate(() => {
    // Nothing drawn; of the 3D view one colour is nothing, of a map it may be all there is.
    const isBlank = (canvas) => {
      const copy = document.createElement('canvas');
      copy.width = copy.height = 64;
      const context = copy.getContext('2d');
      context.drawImage(canvas, 0, 0, 64, 64);
      const colours = new Set(new Uint32Array(context.getImageData(0, 0, 64, 64).data.buffer));
      return colours.size === 1 && (colours.has(0) || canvas.matches('.on-paper'));
    };
    addEventListener('beforeprint', () => queueMicrotask(() => {
      const canvases = [...document.querySelectorAll('.on-paper, #sections canvas')];
      window.paper = {
        theme: document.documentElement.dataset.theme,
        blank: canvases.filter(isBlank).length,
        canvases: canvases.length,
        empty: [...document.querySelectorAll('.plot')].filter((plot) => !plot.firstChild).length,
        folded: document.querySelectorAll('details.folded:not([open])').length,
      };
    }));
  });
  const opened = () => page.locator('details[open]').count();
  const before = await opened();
  const pdf = await page.pdf({ format: 'A4', path: path.join(out, `${kind}.pdf`) });
  assert.ok(pdf.length > 20000);
  const { paper, theme, copies } = await page.evaluate(() => ({
    paper, theme: document.documentElement.dataset.theme,
    copies: document.querySelectorAll('.on-paper').length,
  }));
  assert.equal(paper.theme, 'light');
  assert.deepEqual([paper.blank, paper.empty, paper.folded], [0, 0, 0], `${kind}: all is on paper`);
  if (!isStill) assert.ok(paper.canvases >= 3, `${kind}: ${paper.canvases} canvases`);
  assert.deepEqual([theme, copies, await opened()], ['dark', 0, before], 'the screen is as before');
  await close();
}

// Verdict, cloth and clock are on the first screen of a phone; the other sentences a touch away.
async function testPhone() {
  const { page, close } = await open('run', kPhone, 'light', { reducedMotion: 'reduce' });
  const edge = (selector, side) => page.evaluate(([one, which]) =>
    document.querySelector(one).getBoundingClientRect()[which], [selector, side]);
  assert.ok(await edge('#view-3d', 'bottom') <= await edge('.transport', 'top'),
    'the cloth is whole above the clock');
  assert.ok(await edge('#view-3d', 'height') >= 200);
  const sentences = page.locator('.verdict-words li:visible');
  assert.equal(await sentences.count(), 1);
  await page.locator('.more').click();
  assert.ok(await sentences.count() > 1, 'a touch shows the others');
  await close();
}

async function takePictures(kind, name, viewport, theme) {
  const { page, close } = await open(kind, viewport, theme, { reducedMotion: 'reduce' });
  await page.evaluate(() => clothfit.player.seek(14));
  await page.waitForTimeout(400);
  await page.screenshot({ path: path.join(out, `${kind}-${name}-first.png`) });
  const ids = await page.$$eval('section.card', (sections) => sections.map(({ id }) => id));
  assert.ok(ids.length >= 3);
  for (const id of ids) {
    await page.locator(`#${id}`).scrollIntoViewIfNeeded();
    await page.waitForTimeout(250);
    await page.locator(`#${id}`).screenshot({ path: path.join(out, `${kind}-${name}-${id}.png`) });
  }
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(wide <= 0, `nothing is wider than the page (${wide} px)`);
  await close();
}

await testPlaying();
await testSlider();
await testPicking();
await testParameters();
await testSorting();
await testDiagnosis();
await testPair();
await testPhone();
for (const kind of ['run', 'pair', 'diagnosis', 'comparison', 'study']) await testPaper(kind);
for (const kind of ['run', 'pair', 'diagnosis', 'comparison', 'study']) {
  await takePictures(kind, 'light', kDesk, 'light');
  await takePictures(kind, 'dark', kDesk, 'dark');
  await takePictures(kind, 'phone', kPhone, 'light');
}
await browser.close();
console.log('the pages work');
