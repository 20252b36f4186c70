// SPDX-License-Identifier: MIT
const readJson = id => JSON.parse(document.getElementById(id).textContent);
const kRecords = readJson('records').records;
const kBenches = readJson('benches');
const kColors = readJson('colors');

// Four significant digits; what was not measured is a dash.
function shortNumber(value) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e7) return value.toExponential(2).replace('e', ' e');
  return String(Number(value.toPrecision(4)));
}

// "shadow/map" is "map" where everything is of one family.
const shortName = pipeline => pipeline.replace(/^[a-z]+\//, '');
const clipped = (text, length) => text.length > length ? text.slice(0, length - 1) + '…' : text;

function median(values) {
  const sorted = [...values].sort((a, b) => a - b), middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

// The run that everything in a section speaks of; the plot, the table, the crops and the comparison follow it.
function pickRun(section, record, place = null) {
  section.dispatchEvent(new CustomEvent('pick', { detail: { record, place } }));
}
