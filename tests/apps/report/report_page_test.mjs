// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// node report_page_test.mjs MODULES CHROMIUM PAGE OUT: opens the page from disk and uses it as a
// person does. Leaves a picture of every section, by day, by night and at the width of a phone.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const [modules, executablePath, file, out] = process.argv.slice(2);
const { chromium } = createRequire(path.join(path.resolve(modules), 'x.js'))('playwright-core');
const url = pathToFileURL(path.resolve(file)).href;
const kDesk = { width: 1440, height: 900 };
const kPhone = { width: 390, height: 844 };

const browser = await chromium.launch({
  executablePath,
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
    '--ignore-gpu-blocklist'],
});

// A page that fails the test where it complains, or asks for anything but itself.
async function open(viewport, colorScheme, more = {}) {
  const context = await browser.newContext({ viewport, colorScheme, ...more });
  const page = await context.newPage();
  const complaints = [];
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => {
    if (!/^(blob|data):/.test(request.url()) && request.url() !== url) {
      complaints.push(`asks for ${request.url()}`);
    }
  });
  await page.goto(url);
  await page.waitForSelector('html[data-ready]', { timeout: 60000 });
  return { page, close: async () => { assert.deepEqual(complaints, []); await context.close(); } };
}

const frameOf = (page) => page.evaluate(() => clothfit.player.frame);

// What both views show: the 3D view's frame, and the picture's pixels.
const viewsOf = (page) => page.evaluate(() => {
  const canvas = clothfit.picturePanel.view.canvas;
  return { frame: clothfit.viewPanel.viewer.frame, picture: canvas.toDataURL().length + ':' +
    canvas.toDataURL().slice(-4000) };
});

async function testPlaying() {
  const { page, close } = await open(kDesk, 'light');
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
  await page.keyboard.press('ArrowRight');
  assert.notEqual(await frameOf(page), paused, 'arrow keys step');
  const eye = () => page.evaluate(() => clothfit.viewPanel.viewer.eye.position.toArray().join());
  const from = await eye();
  await page.keyboard.press('d');
  assert.notEqual(await eye(), from, 'keys turn the view');
  await close();
}

async function testSlider() {
  const { page, close } = await open(kDesk, 'light', { reducedMotion: 'reduce' });
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

async function testPicking() {
  const { page, close } = await open(kDesk, 'light', { reducedMotion: 'reduce' });
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

async function takePictures(name, viewport, theme) {
  const { page, close } = await open(viewport, theme, { reducedMotion: 'reduce' });
  await page.evaluate(() => clothfit.player.seek(14));
  await page.waitForTimeout(400);
  await page.screenshot({ path: path.join(out, `${name}-first.png`) });
  const ids = await page.$$eval('section.card', (sections) => sections.map(({ id }) => id));
  assert.ok(ids.length >= 6);
  for (const id of ids) {
    await page.locator(`#${id}`).scrollIntoViewIfNeeded();
    await page.waitForTimeout(250);
    await page.locator(`#${id}`).screenshot({ path: path.join(out, `${name}-${id}.png`) });
  }
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(wide <= 0, `nothing is wider than the page (${wide} px)`);
  await close();
}

await testPlaying();
await testSlider();
await testPicking();
await takePictures('light', kDesk, 'light');
await takePictures('dark', kDesk, 'dark');
await takePictures('phone', kPhone, 'light');
await browser.close();
console.log('the page works');
