// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A headless Chromium that opens the pages OUT/KIND.html from disk.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

export async function launch(modules, executablePath, out) {
  const { chromium } = createRequire(path.join(path.resolve(modules), 'x.js'))('playwright-core');
  const browser = await chromium.launch({
    executablePath,
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
      '--ignore-gpu-blocklist'],
  });

  // A page that fails the test where it complains, or asks for anything but itself.
  async function open(kind, viewport, colorScheme, more = {}) {
    const url = pathToFileURL(path.resolve(out, `${kind}.html`)).href;
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
  return { browser, open };
}
