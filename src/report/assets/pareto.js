// SPDX-License-Identifier: MIT
// Error against cost of the rows of a table. A point leads to its row; what no other beats in both is on the front.
function tableColumns(table, role) {
  return [...table.tHead.rows[0].cells].map((head, index) => ({ head, index }))
    .filter(({ head }) => head.dataset.role === role)
    .map(({ head, index }) => ({ index, text: head.textContent.trim() }));
}

function frontOf(points) {
  const order = [...points].sort((a, b) => a.cost - b.cost || a.error - b.error);
  let least = Infinity;
  return order.filter(point => {
    const on = point.error < least;
    if (on) least = point.error;
    return on;
  });
}

const isWide = values => {
  const positive = values.filter(v => v > 0);
  return positive.length > 1 && Math.max(...positive) > 15 * Math.min(...positive);
};

function startPareto(section) {
  const host = section.querySelector('.plot'), table = section.querySelector('table.sortable');
  const errors = tableColumns(table, 'error'), costs = tableColumns(table, 'cost');
  if (!host || !errors.length || !costs.length || table.tBodies[0].rows.length < 2) return;
  const state = { error: errors[0], cost: costs[0], logX: null, logY: null, at: 0, width: 0 };
  const chart = svg('svg', { class: 'chart', role: 'group', 'aria-label': 'Error against cost, a point for each technique' });
  const readout = el('p', { class: 'readout', 'aria-live': 'polite' });
  let points = [];

  function readPoints() {
    const value = (row, column) => Number(row.cells[column.index].dataset.v || NaN);
    points = [...table.tBodies[0].rows]
      .map(row => ({ row, name: row.cells[0].dataset.v, cost: value(row, state.cost), error: value(row, state.error) }))
      .filter(point => Number.isFinite(point.cost) && Number.isFinite(point.error))
      .sort((a, b) => a.cost - b.cost);
    const front = new Set(frontOf(points));
    for (const row of table.tBodies[0].rows) row.querySelector('.mark').replaceChildren();
    for (const point of points) {
      point.on = front.has(point);
      if (point.on) point.row.querySelector('.mark').append(el('span', { title: 'On the front of error and cost', role: 'img', 'aria-label': 'on the front' }, '✔'));
    }
  }

  const describe = point => point.name + ': ' + state.error.text + ' ' + shortNumber(point.error) + ', ' + state.cost.text + ' ' +
    shortNumber(point.cost) + (point.on ? ', on the front' : '');

  function toRow(point) {
    if (point.row.dataset.record) pickRun(section, Number(point.row.dataset.record));
    else markPicked(table, point.row);
    point.row.tabIndex = -1;
    point.row.focus({ preventScroll: true });
    point.row.scrollIntoView({ block: 'center' });
    draw();
  }

  function moveTo(index) {
    state.at = (index + points.length) % points.length;
    const nodes = chart.querySelectorAll('.point');
    nodes.forEach((node, i) => node.setAttribute('tabindex', i === state.at ? 0 : -1));
    nodes[state.at].focus();
  }

  function onKey(event, point, index) {
    const step = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (event.key === 'Enter' || event.key === ' ') toRow(point);
    else if (step) moveTo(index + step);
    else if (event.key === 'Home') moveTo(0);
    else if (event.key === 'End') moveTo(points.length - 1);
    else return;
    event.preventDefault();
  }

  // Names stand beside their points where there is room; those of the front come first.
  function placeNames(places, box) {
    const taken = places.map(p => [p.x - 7, p.y - 7, p.x + 7, p.y + 7]), names = [];
    const hits = (a, b) => a[0] < b[2] && a[2] > b[0] && a[1] < b[3] && a[3] > b[1];
    for (const place of [...places].sort((a, b) => b.point.on - a.point.on)) {
      const text = clipped(shortName(place.point.name), 30), width = text.length * 6.6;
      // The front runs to the right of its points and above them.
      const options = [...(place.point.on ? [[9, -8]] : []), [10, 4], [-10 - width, 4], [-width / 2, -11], [-width / 2, 20], [10, -10], [10, 17]];
      for (const [dx, dy] of options) {
        const rectangle = [place.x + dx, place.y + dy - 11, place.x + dx + width, place.y + dy + 3];
        const inside = rectangle[0] > box.left && rectangle[2] < box.right + 8 && rectangle[1] > box.top - 8 && rectangle[3] < box.bottom;
        if (!inside || taken.some(other => hits(other, rectangle))) continue;
        taken.push(rectangle);
        names.push(svg('text', { class: 'name', x: place.x + dx, y: place.y + dy }, text));
        break;
      }
    }
    return names;
  }

  function draw() {
    if (!state.width) return;
    const width = state.width, height = Math.max(260, Math.min(400, Math.round(width * 0.68)));
    const box = { left: 56, right: width - 12, top: 26, bottom: height - 42 };
    const xs = points.map(p => p.cost), ys = points.map(p => p.error);
    const x = makeScale(xs, state.logX ?? isWide(xs), box.left, box.right), y = makeScale(ys, state.logY ?? isWide(ys), box.bottom, box.top);
    chart.setAttribute('viewBox', '0 0 ' + width + ' ' + height);
    chart.style.height = height + 'px';
    const places = points.map(point => ({ point, x: x.place(point.cost), y: y.place(point.error) }));
    const front = places.filter(place => place.point.on);
    const steps = front.map((place, i) => (i ? 'H' + place.x + 'V' + place.y : 'M' + place.x + ',' + box.top + 'V' + place.y)).join('');
    const parts = [...drawAxes(x, y, box, state.cost.text, state.error.text)];
    if (front.length) parts.push(svg('path', { class: 'front', d: steps + 'H' + box.right }));
    // Discs are on the front, open diamonds are beaten: told apart by shape as well as by colour.
    places.forEach(({ point, x: px, y: py }, i) => {
      const shape = point.on ? 'M-6,0a6,6 0 1 0 12,0a6,6 0 1 0 -12,0' : 'M0,-6L6,0L0,6L-6,0Z';
      const picked = point.row.classList.contains('picked');
      parts.push(svg('g', { class: 'point' + (point.on ? ' on' : '') + (picked ? ' picked' : ''), role: 'button', transform: 'translate(' + px + ',' + py + ')',
        tabindex: i === state.at ? 0 : -1, 'aria-label': describe(point), onclick: () => toRow(point),
        onkeydown: event => onKey(event, point, i), onpointerenter: () => { readout.textContent = describe(point); },
        onfocus: () => { state.at = i; readout.textContent = describe(point); } },
        svg('circle', { class: 'halo', r: 12 }), svg('path', { d: shape })));
    });
    chart.replaceChildren(...parts, ...placeNames(places, box));
  }

  function again() {
    readPoints();
    state.at = Math.min(state.at, Math.max(0, points.length - 1));
    readout.textContent = 'Discs and the line are the front: nothing else is better in both. Press a point to go to its row.';
    draw();
  }
  const toggle = (axis, text) => el('label', {}, el('input', { type: 'checkbox', class: axis, onchange: event => {
    state[axis] = event.target.checked;
    draw();
  } }), text);
  const logX = toggle('logX', 'log'), logY = toggle('logY', 'log');
  const reset = () => {
    state.logX = state.logY = null;
    again();
    logX.firstChild.checked = isWide(points.map(p => p.cost));
    logY.firstChild.checked = isWide(points.map(p => p.error));
  };
  const select = (columns, key) => choice(columns.map(c => [c.index, c.text]), state[key].index, index => {
    state[key] = columns.find(c => c.index === Number(index));
    reset();
  });
  host.append(el('div', { class: 'controls' }, labelled('Error', select(errors, 'error')), logY, labelled('Cost', select(costs, 'cost')), logX), chart, readout);
  reset();
  whenSized(host, width => {
    state.width = width;
    draw();
  });
  section.addEventListener('pick', () => requestAnimationFrame(draw));
}

function markPicked(table, row) {
  for (const other of table.tBodies[0].rows) other.classList.toggle('picked', other === row);
}
