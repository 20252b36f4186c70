// SPDX-License-Identifier: MIT
// A scale from values to pixels. On a logarithmic one what is not above 0 sits on a place of its own, before the axis.
const kGutter = 28;

function makeScale(values, log, from, to) {
  const direction = Math.sign(to - from);
  if (!log) {
    const high = Math.max(...values, 0), low = Math.min(...values, 0), span = high - low || 1;
    const place = v => from + (to - from) * (v - low) / (span * 1.06);
    return { place, ticks: linearTicks(low, high), zero: null };
  }
  const positive = values.filter(v => v > 0);
  let low = Math.log10(Math.min(...positive)), high = Math.log10(Math.max(...positive));
  if (!positive.length) [low, high] = [0, 1];
  const margin = Math.max(0.08 * (high - low), 0.08);
  low -= margin;
  high += margin;
  const hasZero = values.some(v => !(v > 0)), start = hasZero ? from + direction * kGutter : from;
  const place = v => v > 0 ? start + (to - start) * (Math.log10(v) - low) / (high - low) : from + direction * kGutter / 3;
  return { place, ticks: logTicks(low, high), zero: hasZero ? place(0) : null };
}

function linearTicks(low, high) {
  const raw = (high - low || 1) / 5, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].find(f => f * power >= raw) * power;
  const ticks = [];
  for (let i = Math.ceil(low / step); i * step <= high + step * 1e-9; ++i) ticks.push(Number((i * step).toPrecision(12)));
  return ticks;
}

// 1, 2 and 5 while they are few, then powers of ten, then every so many of these.
function logTicks(low, high) {
  const pick = (factors, every) => {
    const ticks = [];
    for (let power = Math.floor(low); power <= Math.ceil(high); power += 1)
      for (const factor of factors)
        if (power % every === 0 && Math.log10(factor * 10 ** power) >= low && Math.log10(factor * 10 ** power) <= high)
          ticks.push(Number((factor * 10 ** power).toPrecision(3)));
    return ticks;
  };
  for (const [factors, every] of [[[1, 2, 5], 1], [[1], 1], [[1], 2], [[1], 4]]) {
    const ticks = pick(factors, every);
    if (ticks.length <= 7) return ticks;
  }
  return pick([1], 8);
}

// Both axes with their grid and titles; a scale's zero is marked apart.
function drawAxes(x, y, box, xTitle, yTitle) {
  const parts = [];
  const line = (kind, x1, y1, x2, y2) => parts.push(svg('line', { class: kind, x1, y1, x2, y2 }));
  const text = (string, at) => parts.push(svg('text', at, string));
  const columns = x.ticks.map(v => [x.place(v), shortNumber(v)]), rows = y.ticks.map(v => [y.place(v), shortNumber(v)]);
  if (x.zero !== null) columns.push([x.zero, '0']);
  if (y.zero !== null) rows.push([y.zero, '0']);
  for (const [at, label] of columns) {
    line('grid', at, box.top, at, box.bottom);
    text(label, { x: at, y: box.bottom + 16, 'text-anchor': 'middle' });
  }
  for (const [at, label] of rows) {
    line('grid', box.left, at, box.right, at);
    text(label, { x: box.left - 6, y: at + 4, 'text-anchor': 'end' });
  }
  line('axis', box.left, box.bottom, box.right, box.bottom);
  line('axis', box.left, box.top, box.left, box.bottom);
  text(xTitle, { x: box.right, y: box.bottom + 34, 'text-anchor': 'end' });
  text(yTitle, { x: box.left - 40, y: box.top - 10 });
  return parts;
}
