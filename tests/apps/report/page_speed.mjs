// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// node page_speed.mjs MODULES CHROMIUM SECONDS ROUNDS PAGE.html...: how fast pages of `clothfit report`
// play where the processor draws: pictures a second, processor time a picture by Chromium's
// processes, first paint. The pages take turns, so that a machine that is also used by others
// slows all of them; the medians of the rounds are printed. Nothing is asserted.
import { createRequire } from 'node:module';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const [modules, executablePath, seconds, rounds, ...files] = process.argv.slice(2);
const { chromium } = createRequire(path.join(path.resolve(modules), 'x.js'))('playwright-core');
const kWarmUp = 3000;  // ms, in which the 3D view finds its number of pixels

// Processor time so far, s, of each kind of Chromium's processes.
async function processorTimes(session) {
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  const times = {};
  for (const { type, cpuTime } of processInfo) times[type] = (times[type] ?? 0) + cpuTime;
  return times;
}

const drawn = (page) => page.evaluate(() => clothfit.viewPanel.viewer.frames);

async function play(file) {
  const browser = await chromium.launch({
    executablePath,
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
      '--ignore-gpu-blocklist'],
  });
  const session = await browser.newBrowserCDPSession();
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  await page.goto(pathToFileURL(path.resolve(file)).href);
  await page.waitForSelector('html[data-ready]', { timeout: 60000 });
  const firstPaint = await page.evaluate(() =>
    performance.getEntriesByName('first-contentful-paint')[0]?.startTime);
  const ready = await page.evaluate(() => performance.now());
  await page.waitForTimeout(kWarmUp);
  const [begin, before, beginTime] =
    [await drawn(page), await processorTimes(session), performance.now()];
  await page.waitForTimeout(1000 * seconds);
  const [end, after, endTime] =
    [await drawn(page), await processorTimes(session), performance.now()];
  await browser.close();
  const pictures = end - begin;
  const result = {
    'first paint ms': firstPaint, 'ready ms': ready,
    'pictures/s': (1000 * pictures) / (endTime - beginTime), 'ms/picture': 0,
  };
  for (const type of ['browser', 'renderer', 'GPU']) {
    result[`${type} ms`] = (1000 * (after[type] - before[type])) / pictures;
    result['ms/picture'] += result[`${type} ms`];
  }
  return result;
}

function median(values) {
  const sorted = values.filter(Number.isFinite).sort((a, b) => a - b);
  return (sorted[(sorted.length - 1) >> 1] + sorted[sorted.length >> 1]) / 2;
}

const results = files.map(() => []);
for (let round = 0; round < rounds; ++round) {
  for (const [index, file] of files.entries()) results[index].push(await play(file));
}
for (const [index, file] of files.entries()) {
  const numbers = Object.keys(results[index][0]).map((key) =>
    `${key} ${median(results[index].map((result) => result[key])).toFixed(1)}`);
  console.log(`${path.basename(file)}: ${numbers.join(', ')}`);
}
