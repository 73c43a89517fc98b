// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Blocks of kind "lines": series over the recording's frames, linked to the clock, or over any x.
import uPlot from 'uplot';

import { h, onSeen, whenNear } from '../dom.js';
import { number, unitText } from '../format.js';
import { colour, onTheme } from '../theme.js';

const kHeight = 210;
const kTall = 320;

function seriesColour(series, index) {
  const named = { before: '--before', after: '--after' }[series.role];
  return colour(named ?? `--series-${((series.colour ?? index) % 6) + 1}`);
}

// Hatches held-out frames behind the curves.
function hatch(clock) {
  return (plot) => {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.beginPath();
    for (const [first, last] of clock.held_out) {
      const left = plot.valToPos((first - 0.5) / clock.rate, 'x', true);
      const right = plot.valToPos((last + 0.5) / clock.rate, 'x', true);
      ctx.rect(left, bbox.top, right - left, bbox.height);
    }
    ctx.clip();
    ctx.strokeStyle = colour('--hatch');
    ctx.lineWidth = devicePixelRatio;
    ctx.beginPath();
    const step = 7 * devicePixelRatio;
    for (let x = bbox.left - bbox.height; x < bbox.left + bbox.width; x += step) {
      ctx.moveTo(x, bbox.top + bbox.height);
      ctx.lineTo(x + bbox.height, bbox.top);
    }
    ctx.stroke();
    ctx.restore();
  };
}

// Of a logarithmic axis: powers of ten, and of a short one some multiples of them too.
function logTicks(_, __, low, high) {
  const decades = Math.log10(high / low);
  const digits = decades > 3 ? [1] : decades > 1.2 ? [1, 2, 5] : [1, 1.5, 2, 3, 5, 7];
  const ticks = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power) {
    for (const digit of digits) ticks.push(Number(`${digit}e${power}`));
  }
  return ticks.filter((tick) => tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9));
}

function axis(title, unit, isSide, isLog) {
  return {
    label: unit ? `${title}, ${unitText(unit)}` : title,
    labelSize: 22,
    labelFont: '12px system-ui, sans-serif',
    font: '11px system-ui, sans-serif',
    stroke: () => colour('--ink-soft'),
    grid: { stroke: () => colour('--grid-soft'), width: 1 },
    ticks: { stroke: () => colour('--grid-soft'), width: 1 },
    size: isSide ? (isLog ? 66 : 52) : 34,
    values: (_, values) => values.map((value) => (value === null ? '' : number(value, 4))),
    ...(isLog ? { splits: logTicks, filter: (_, ticks) => ticks } : {}),
  };
}

// uPlot's own range of a logarithm is whole decades, which may leave most of the chart empty.
function rangeOf(y) {
  if (y.from_zero) return (_, __, high) => [0, (high || 1) * 1.08];
  if (y.log) return (_, low, high) => [(low || 1) / 1.12, (high || 1) * 1.12];
  return undefined;
}

const heightOf = (block) => (block.tall ? kTall : kHeight);

function optionsOf(block, clock, width) {
  const isLinked = Boolean(block.frames);
  const x = isLinked ? { title: 'time', unit: 's' } : block.x;
  return {
    width,
    height: heightOf(block),
    cursor: { points: { size: 7 }, drag: { x: false, y: false } },
    legend: { live: true },
    scales: {
      x: { time: false, distr: block.x?.log ? 3 : 1 },
      y: {
        distr: block.y.log ? 3 : 1,
        range: rangeOf(block.y),
      },
    },
    axes: [axis(x.title, x.unit, false, x.log),
      axis(unitText(block.y.unit) || block.y.title, '', true, block.y.log)],
    series: [
      {
        label: x.title,
        value: (_, value) => (value === null ? '–' : `${number(value, 4)} ${unitText(x.unit)}`),
      },
      ...block.series.map((series, index) => ({
        label: series.name,
        stroke: () => seriesColour(series, index),
        width: 2,
        spanGaps: Boolean(series.steps || series.joined),
        paths: series.steps ? uPlot.paths.stepped({ align: 1 }) : undefined,
        dash: series.role === 'before' ? [6, 4] : undefined,
        points: { show: Boolean(series.points), size: 6, fill: () => seriesColour(series, index) },
        value: (_, value) => (value === null ? '–' : `${number(value, 3)} ${unitText(block.y.unit)}`),
      })),
    ],
    hooks: isLinked ? { drawClear: [hatch(clock)] } : {},
  };
}

// A line at the clock's frame, and the values there unless the pointer asks for others.
function link(plot, player, clock) {
  const now = h('div', { class: 'now-line' });
  plot.over.append(now);
  const mark = (frame) => {
    now.style.transform = `translateX(${plot.valToPos(frame / clock.rate, 'x')}px)`;
  };
  const tell = (frame) => {
    if (plot.cursor.left < 0) plot.setLegend({ idx: frame }, false);
  };
  const show = (frame) => {
    mark(frame);
    tell(frame);
  };
  let isSeen = false;
  onSeen(plot.root, (seen) => {
    isSeen = seen;
    if (seen) show(player.frame);
  });
  player.onFrame((frame) => { if (isSeen) mark(frame); });
  player.onFrameSlowly((frame) => { if (isSeen) tell(frame); });
  plot.over.addEventListener('pointerdown', (event) => {
    const { left } = plot.over.getBoundingClientRect();
    const seek = (at) => player.seek(plot.posToVal(at.clientX - left, 'x') * clock.rate);
    player.pause();
    seek(event);
    plot.over.setPointerCapture(event.pointerId);
    plot.over.onpointermove = seek;
    plot.over.onpointerup = () => { plot.over.onpointermove = null; };
  });
  plot.hooks.setCursor = [() => { if (plot.cursor.left < 0) show(player.frame); }];
  return { show };
}

export function linesBlock(block, { player, clock }) {
  const body = h('div', { class: 'plot', style: `min-height: ${heightOf(block) + 30}px` });
  const element = h('figure', { class: 'chart' }, h('figcaption', {}, block.title), body);
  const x = block.frames
    ? Array.from({ length: clock.frames }, (_, frame) => frame / clock.rate) : block.x.values;
  const data = [x, ...block.series.map((series) => series.values)];
  whenNear(element, () => {
    const plot = new uPlot(optionsOf(block, clock, Math.max(240, body.clientWidth)), data, body);
    const linked = block.frames ? link(plot, player, clock) : null;
    new ResizeObserver(() => {
      if (Math.abs(body.clientWidth - plot.width) < 2 || body.clientWidth === 0) return;
      plot.setSize({ width: body.clientWidth, height: heightOf(block) });
      linked?.show(player.frame);
    }).observe(body);
    const redraw = () => plot.redraw(false);
    onTheme(redraw);
    requestAnimationFrame(() => linked?.show(player.frame));
  });
  return element;
}
