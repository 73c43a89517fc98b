// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The report's page: reads its data, sets up the clock, the two views and the sections.
import { decode, readReport } from './data.js';
import { h } from './dom.js';
import { PicturePanel } from './pictures/picture_panel.js';
import { PictureContext } from './pictures/camera_view.js';
import { preparePaper } from './paper.js';
import { Player } from './player.js';
import { makeLinks, makeSection } from './sections.js';
import { makeThemeButton } from './theme.js';
import { makeTransport } from './transport.js';
import { loadObservations } from './viewer/observations.js';
import { ViewPanel } from './viewer/view_panel.js';

async function loadCloths(report) {
  const cloths = {};
  for (const motion of report.motions) {
    cloths[motion.name] = {
      positions: await decode(motion.positions),
      particles: report.mesh.particles,
      frames: motion.frames,
    };
  }
  return cloths;
}

// A browser without WebGL still gets the pictures, the charts and the words.
async function makeViewPanel(report, observations, player) {
  try {
    return await ViewPanel.make(report, observations, player);
  } catch (error) {
    const element = h('figure', { class: 'panel' },
      h('p', { class: 'missing' }, `The 3D view needs WebGL: ${error.message}`));
    return { element, setCamera() {} };
  }
}

async function makeStage(report, player, stage) {
  const observations = await loadObservations(report);
  const cloths = await loadCloths(report);
  const viewPanel = await makeViewPanel(report, observations, player);
  stage.append(viewPanel.element);
  stage.classList.toggle('alone', report.cameras.length === 0);
  if (report.cameras.length === 0) return { viewPanel };
  const pictures = new PictureContext(report, observations, await decode(report.mesh.triangles),
    cloths);
  const picturePanel = new PicturePanel(pictures, player, (index) => viewPanel.setCamera(index));
  viewPanel.setCamera(picturePanel.index);
  stage.append(picturePanel.element);
  return { viewPanel, pictures, picturePanel };
}

// On a phone the first sentence stands above the cloth, the others wait for a touch.
function shortenVerdict() {
  const words = document.querySelector('.verdict-words');
  if (words.querySelectorAll('li').length < 2) return;
  const button = h('button', {
    type: 'button', class: 'more', 'aria-expanded': 'false',
    onclick: () => {
      const isOpen = words.classList.toggle('open');
      button.setAttribute('aria-expanded', String(isOpen));
      button.textContent = isOpen ? 'Less' : 'More';
    },
  }, 'More');
  words.append(button);
}

// A comparison or a study has no clock and nothing that moves.
const kStill = { frames: 1, rate: 1, held_out: [], last_fitted: 0 };

async function start() {
  const report = readReport();
  const hasMotion = Boolean(report.motions?.length);
  const clock = report.clock ?? kStill;
  const player = new Player(clock);
  document.getElementById('bar-tools').append(makeLinks(report.sections), makeThemeButton());
  const stage = document.getElementById('stage');
  if (hasMotion) document.body.append(makeTransport(player, clock)); else stage.hidden = true;
  const parts = hasMotion ? await makeStage(report, player, stage) : {};
  if (report.notes.length) {
    stage.after(h('aside', { class: 'notes' }, report.notes.map((note) => h('p', {}, note))));
  }
  const context = { report, player, clock, ...parts };
  const sections = document.getElementById('sections');
  for (const section of report.sections) sections.append(makeSection(section, context));
  preparePaper(player, parts.viewPanel?.viewer);
  if (hasMotion) shortenVerdict();
  document.documentElement.dataset.ready = 'true';
  window.clothfit = { player, ...parts };  // for the console, and for tests
  if (hasMotion && !matchMedia('(prefers-reduced-motion: reduce)').matches) player.play();
}

start();
