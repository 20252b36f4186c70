// SPDX-License-Identifier: MIT
#include "report/assets.h"

namespace ombrage {

const char* const kReportStyle = R"css(
:root { color-scheme: light dark; --ink: #1b1d21; --soft: #5a606b; --paper: #ffffff; --panel: #f3f4f6; --line: #d5d8dd; --mark: #0b5cad; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e8e9ec; --soft: #a4aab5; --paper: #16181c; --panel: #20242a; --line: #3a3f47; --mark: #7db8f5; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1.5rem; max-width: 90rem; color: var(--ink); background: var(--paper);
  font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.6rem; margin: 0 0 .5rem; }
h2 { font-size: 1.25rem; margin: 2.5rem 0 .5rem; border-bottom: 1px solid var(--line); padding-bottom: .25rem; }
h3 { font-size: 1rem; margin: 1.5rem 0 .5rem; }
.headline { font-size: 1.15rem; max-width: 70ch; }
.notice { border-left: .3rem solid #d55e00; padding: .25rem .75rem; background: var(--panel); }
dl.facts { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1rem; }
dl.facts dt { color: var(--soft); }
dl.facts dd { margin: 0; overflow-wrap: anywhere; }
code { font-family: ui-monospace, monospace; font-size: .9em; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; margin: .5rem 0; }
caption { text-align: left; color: var(--soft); }
td { white-space: nowrap; }
td.text { white-space: normal; min-width: 12rem; }
th, td { padding: .25rem .6rem; border-bottom: 1px solid var(--line); text-align: right; vertical-align: top; }
th:first-child, td:first-child, .text { text-align: left; }
tbody tr:hover { background: var(--panel); }
th button { font: inherit; font-weight: 600; color: inherit; background: none; border: 0; padding: 0; cursor: pointer; }
th[aria-sort] button { color: var(--mark); }
th[aria-sort=ascending] button::after { content: " \25B2"; }
th[aria-sort=descending] button::after { content: " \25BC"; }
:focus-visible { outline: 2px solid var(--mark); outline-offset: 2px; }
.best { font-weight: 700; text-decoration: underline; text-underline-offset: .2em; }
.params { color: var(--soft); font-size: .85em; }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(17rem, 1fr)); gap: .75rem; }
figure { margin: 0; background: var(--panel); border: 1px solid var(--line); border-radius: .3rem; overflow: hidden; }
figure img { display: block; width: 100%; height: auto; image-rendering: auto; }
figcaption { padding: .3rem .5rem; font-size: .85rem; overflow-wrap: anywhere; }
.scale { display: grid; max-width: 40rem; }
.scale .ramp { height: 1.2rem; border: 1px solid var(--line); }
.scale .marks { position: relative; height: 1.5rem; font-size: .85rem; }
.scale .marks span { position: absolute; transform: translateX(-50%); }
.keys { display: flex; flex-wrap: wrap; gap: .25rem 1.25rem; padding: 0; list-style: none; }
.keys i { display: inline-block; width: 1em; height: 1em; margin-right: .4em; vertical-align: -.1em; border: 1px solid var(--line); }
.flip { margin: .75rem 0; max-width: 48rem; }
.flip .bar { display: flex; flex-wrap: wrap; gap: .5rem; align-items: center; margin-bottom: .5rem; }
.flip img { display: block; width: 100%; height: auto; background: var(--panel); }
details { margin: .5rem 0; }
summary { cursor: pointer; }
@media print { .flip, th button::after { display: none; } figure { break-inside: avoid; } }
)css";

const char* const kReportScript = R"js(
'use strict';
// Sortable tables: a heading's button sorts by its column; what was not measured stays last.
for (const table of document.querySelectorAll('table.sortable')) {
  const heads = [...table.tHead.rows[0].cells];
  heads.forEach((head, column) => {
    const button = head.querySelector('button');
    if (!button) return;
    button.addEventListener('click', () => {
      const down = head.getAttribute('aria-sort') === 'ascending';
      heads.forEach(h => h.removeAttribute('aria-sort'));
      head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
      const value = row => row.cells[column].dataset.v ?? row.cells[column].textContent;
      const numeric = head.dataset.kind === 'number';
      const rows = [...table.tBodies[0].rows];
      rows.sort((a, b) => {
        const x = value(a), y = value(b);
        if (numeric && (x === '' || y === '')) return (x === '') - (y === '');
        const order = numeric ? Number(x) - Number(y) : x.localeCompare(y, 'en');
        return down ? -order : order;
      });
      table.tBodies[0].append(...rows);
    });
  });
}
// Two pictures in one place: the button, or the space bar while the picture has the focus, changes between them.
for (const section of document.querySelectorAll('section.measured')) {
  const pictures = [...section.querySelectorAll('figure img')];
  if (pictures.length < 2) continue;
  const pane = document.createElement('div');
  pane.className = 'flip';
  const bar = document.createElement('div');
  bar.className = 'bar';
  const image = document.createElement('img');
  image.tabIndex = 0;
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = 'Flip A / B';
  const selects = ['A', 'B'].map((name, which) => {
    const label = document.createElement('label');
    const select = document.createElement('select');
    pictures.forEach((picture, i) => select.add(new Option(picture.dataset.title, i)));
    // The truth beside the first technique's answer, where there is a truth.
    const answer = pictures.findIndex((p, i) => i > 0 && p.dataset.title.endsWith(': visibility'));
    select.selectedIndex = which === 0 ? 0 : Math.max(answer, 1);
    label.append(name + ' ', select);
    bar.append(label);
    return select;
  });
  let shown = 0;
  const show = () => {
    const picture = pictures[selects[shown].value];
    image.src = picture.src;
    image.alt = 'AB'[shown] + ': ' + picture.alt;
    selects.forEach((select, i) => { select.style.outline = i === shown ? '2px solid var(--mark)' : ''; });
  };
  const flip = () => { shown = 1 - shown; show(); };
  selects.forEach((select, i) => select.addEventListener('change', () => { shown = i; show(); }));
  button.addEventListener('click', flip);
  image.addEventListener('click', flip);
  image.addEventListener('keydown', event => {
    if (event.key === ' ') { event.preventDefault(); flip(); }
  });
  bar.append(button);
  pane.append(bar, image);
  section.querySelector('.cards').before(pane);
  show();
}
document.documentElement.dataset.ready = 'yes';
)js";

}  // namespace ombrage
