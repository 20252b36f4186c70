// SPDX-License-Identifier: MIT
// Frame times in order, as a line with the median.
function sparkline(samples, width = 72, height = 20) {
  const low = Math.min(...samples), high = Math.max(...samples), span = high - low || 1;
  const x = i => 2 + (width - 4) * (samples.length > 1 ? i / (samples.length - 1) : 0.5);
  const y = v => height - 3 - (height - 6) * (v - low) / span;
  const middle = y(median(samples));
  return svg('svg', { class: 'chart', role: 'img', style: 'width:' + width + 'px', width, height, viewBox: '0 0 ' + width + ' ' + height,
    'aria-label': samples.length + ' frames from ' + shortNumber(low) + ' to ' + shortNumber(high) + ' ms' },
    svg('line', { class: 'grid', x1: 0, x2: width, y1: middle, y2: middle }),
    svg('polyline', { class: 'line', points: samples.map((v, i) => x(i) + ',' + y(v)).join(' ') }),
    ...(samples.length <= 8 ? samples.map((v, i) => svg('circle', { class: 'dot', cx: x(i), cy: y(v), r: 2 })) : []));
}

// One strip of dots per run on a shared axis: how times scatter, and which runs overlap.
function strips(parent, runs) {
  const chart = svg('svg', { class: 'chart', role: 'img',
    'aria-label': 'Frame times: ' + runs.map(run => run.name + ' median ' + shortNumber(median(run.samples)) + ' ms').join(', ') });
  parent.append(chart);
  whenSized(parent, width => {
    const nameWidth = Math.min(220, width * 0.38), row = 24, height = runs.length * row + 36;
    const all = runs.flatMap(run => run.samples);
    const log = Math.max(...all) > 20 * Math.min(...all) && Math.min(...all) > 0;
    const scale = makeScale(all, log, nameWidth, width - 12);
    chart.setAttribute('viewBox', '0 0 ' + width + ' ' + height);
    chart.style.height = height + 'px';
    const parts = [];
    for (const tick of scale.ticks) {
      const x = scale.place(tick);
      parts.push(svg('line', { class: 'grid', x1: x, x2: x, y1: 0, y2: runs.length * row }),
        svg('text', { x, y: runs.length * row + 14, 'text-anchor': 'middle' }, shortNumber(tick)));
    }
    parts.push(svg('text', { x: width - 12, y: height - 4, 'text-anchor': 'end' }, log ? 'ms, logarithmic' : 'ms'));
    runs.forEach((run, i) => {
      const y = i * row + row / 2, x = scale.place(median(run.samples));
      parts.push(svg('text', { class: 'name', x: 0, y: y + 4 }, clipped(run.name, Math.floor(nameWidth / 7))));
      // Neighbours in time are moved apart by turns, so that equal times do not hide each other.
      run.samples.forEach((v, k) => parts.push(svg('circle', { class: 'dot', cx: scale.place(v), cy: y + (k % 5 - 2) * 2.5, r: 2.5 })));
      parts.push(svg('line', { class: 'median', x1: x, x2: x, y1: y - 9, y2: y + 9 }));
    });
    chart.replaceChildren(...parts);
  });
}

function startTimes(section) {
  for (const row of section.querySelectorAll('tr[data-record]')) {
    const samples = kRecords[row.dataset.record].gpu_ms.samples;
    if (samples?.length) row.querySelector('.spark').append(sparkline(samples));
  }
  const runs = [...section.querySelectorAll('tr[data-record]')]
    .map(row => kRecords[row.dataset.record])
    .map(record => ({ name: record.pipeline, samples: record.gpu_ms.samples ?? [] })).filter(run => run.samples.length);
  if (!runs.length) return;
  const body = el('div', {});
  section.querySelector('.times').append(el('details', { open: runs[0].samples.length >= 8 },
    el('summary', {}, 'Frame times'),
    el('p', {}, 'GPU time of every frame after the warm-up; the bar is the median.'), body));
  strips(body, runs);
}

const kDeciding = {
  process_ms: 'Differences are of the processor time of the whole process, round by round.',
  gpu_ms: 'Differences are of the GPU time, round by round.',
};
const percent = share => (share > 0 ? '+' : '') + (100 * share).toFixed(1) + ' %';

// What "ombrage bench -o" left in the same folder.
function startBenches() {
  const section = document.getElementById('bench');
  if (!section) return;
  for (const group of kBenches) {
    const swept = group.axis ? ', ' + group.axis + ' ' + group.value : '';
    const rows = group.runs.map(run => {
      const change = run.to_first;
      return el('tr', {}, el('th', { scope: 'row', class: 'text' }, el('code', {}, run.label)),
        ...[run.gpu_ms.median, run.gpu_ms.p95, run.gpu_ms.mad, run.process_ms?.median, run.cpu_ms.median].map(v => el('td', { 'data-v': v }, shortNumber(v))),
        el('td', { class: 'spark' }, run.gpu_ms.samples.length ? sparkline(run.gpu_ms.samples, 120) : null),
        el('td', { class: 'text' }, change ? change.verdict + ': ' + percent(change.change) + ', 99 % interval ' + percent(change.low) + ' to ' +
          percent(change.high) : 'the first'));
    });
    const head = ['run', 'GPU [ms]', 'p95 [ms]', 'MAD [ms]', 'process [ms]', 'CPU [ms]'].map((name, i) =>
      el('th', { scope: 'col', 'data-kind': i ? 'number' : 'text' }, button(name)));
    const table = el('table', { class: 'sortable' },
      el('thead', {}, el('tr', {}, ...head, el('th', { scope: 'col', class: 'text' }, 'frames'),
        el('th', { scope: 'col', class: 'text' }, 'against the first'))), el('tbody', {}, ...rows));
    const scatter = el('div', {});
    section.append(el('h3', {}, group.scene + ', camera ' + group.camera + (group.light ? ', light ' + group.light : '') + ', ' + group.size.join('x') + swept),
      ...kDeciding[group.decided_by] ? [el('p', {}, kDeciding[group.decided_by])] : [],
      el('div', { class: 'wide', tabindex: 0, role: 'region', 'aria-label': 'Benchmark' }, table), scatter);
    const runs = group.runs.filter(run => run.gpu_ms.samples.length).map(run => ({ name: run.label, samples: run.gpu_ms.samples }));
    if (runs.length) strips(scatter, runs);
  }
}
