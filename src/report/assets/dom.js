// SPDX-License-Identifier: MIT
// Elements are made here alone, and text only ever as text.
const kSvg = 'http://www.w3.org/2000/svg';

function fill(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (value !== null && value !== undefined && value !== false) node.setAttribute(name, value === true ? '' : value);
  }
  node.append(...children.filter(child => child !== null && child !== undefined));
  return node;
}

const el = (name, attributes = {}, ...children) => fill(document.createElement(name), attributes, children);
const svg = (name, attributes = {}, ...children) => fill(document.createElementNS(kSvg, name), attributes, children);

function labelled(text, control) {
  return el('label', {}, text, control);
}

function choice(options, chosen, onchange) {
  const select = el('select', { onchange: () => onchange(select.value) });
  for (const [value, text] of options) select.add(new Option(text, value, false, String(value) === String(chosen)));
  return select;
}

function button(text, onclick, attributes = {}) {
  return el('button', { type: 'button', onclick, ...attributes }, text);
}

// Draws again whenever the width of an element changes; one that is not shown has none.
const kSized = [];
function whenSized(element, draw) {
  let width = 0;
  const look = () => {
    const now = Math.floor(element.clientWidth);
    if (now > 0 && now !== width) draw(width = now);
  };
  kSized.push(look);
  new ResizeObserver(look).observe(element);
}

// A page that is printed does not wait for observers.
function drawNow() {
  for (const look of kSized) look();
}
