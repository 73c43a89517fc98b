// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// node export_test.mjs MODULES FILE.glb: fails where Khronos' glTF validator finds anything.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';

const [modules, file] = process.argv.slice(2);
const validator = createRequire(path.join(path.resolve(modules), 'x.js'))('gltf-validator');
const report = await validator.validateBytes(new Uint8Array(readFileSync(file)));
console.log(JSON.stringify(report.issues, null, 1));
console.log(JSON.stringify(report.info, null, 1));
const { numErrors, numWarnings } = report.issues;
process.exit(numErrors + numWarnings > 0 ? 1 : 0);
