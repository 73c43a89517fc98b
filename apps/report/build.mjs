// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// node build.mjs MODULES: bundles src/ with the libraries in MODULES into dist/, with their
// licences, and writes down what it was made of. `make report-assets` calls it.
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, writeFileSync, mkdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const modules = path.resolve(process.argv[2] ?? 'node_modules');
const esbuild = createRequire(path.join(modules, 'x.js'))('esbuild');
const kLibraries = ['three', 'uplot', 'fflate'];
const kMade = ['dist/LICENCES.txt', 'dist/report.css', 'dist/report.js'];

function licences() {
  const texts = kLibraries.map((name) => {
    const folder = path.join(modules, name);
    const { version, license } = JSON.parse(readFileSync(path.join(folder, 'package.json')));
    const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
    return `${name} ${version} (${license})\n\n${readFileSync(path.join(folder, file), 'utf8').trim()}`;
  });
  return `The page of clothfit report holds these libraries.\n\n${texts.join('\n\n---\n\n')}\n`;
}

function sources() {
  const files = readdirSync(path.join(here, 'src'), { recursive: true })
    .map((file) => `src/${file}`)
    .filter((file) => /\.(js|css)$/.test(file));
  return [...files, 'build.mjs', 'package.json', 'package-lock.json'].sort();
}

function checksum(file) {
  return createHash('sha256').update(readFileSync(path.join(here, file))).digest('hex');
}

mkdirSync(path.join(here, 'dist'), { recursive: true });
await esbuild.build({
  absWorkingDir: here,
  entryPoints: [{ in: 'src/main.js', out: 'report' }, { in: 'src/style.css', out: 'report' }],
  outdir: 'dist',
  bundle: true,
  minify: true,
  format: 'iife',
  target: ['chrome100', 'firefox100', 'safari15'],
  charset: 'ascii',
  legalComments: 'none',
  nodePaths: [modules],
  banner: { js: `/*!\n${licences().replaceAll('*/', '* /')}*/` },
});
writeFileSync(path.join(here, 'dist/LICENCES.txt'), licences());
// In the layout of sha256sum, so that a test needs no Node.js.
const lines = [...sources(), ...kMade].map((file) => `${checksum(file)}  ${file}\n`);
writeFileSync(path.join(here, 'dist/made_of.sha256'), lines.join(''));
