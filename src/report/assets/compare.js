// SPDX-License-Identifier: MIT
// Two answers in one place, under a slider or flipped, and their error beside them; one zoom and one probe for both panes.
const kKeysHelp = [['Space', 'flip A and B'], ['Arrows', 'move the probe'], ['+ − 0', 'zoom'], ['E', 'next map']];

class Comparison {
  constructor(section, host) {
    this.section = section;
    this.records = [...section.querySelectorAll('tr[data-record]')].map(row => Number(row.dataset.record));
    this.kinds = ['visibility', 'picture'].filter(kind => this.records.some(i => pictureOf(kRecords[i], kind)));
    if (!this.kinds.length) return;
    this.kind = this.kinds[0];
    this.hasTruth = this.kinds.some(kind => this.records.some(i => pictureOf(kRecords[i], truthKind(kind))));
    this.a = this.firstChoice();
    this.b = this.hasTruth ? 'truth' : this.records.find(i => i !== this.a) ?? this.a;
    this.mode = 'slider';
    this.shown = 0;
    this.share = 0.5;
    this.probe = null;
    this.view = { changed() {} };
    this.view = new View(() => this.draw());
    this.build(host);
    section.addEventListener('pick', event => this.pick(event.detail));
    whenSized(host, () => this.draw());
  }

  // The nearest to the truth of those that leave an error to look at.
  firstChoice() {
    const rmse = i => kRecords[i].metrics.rmse ?? Infinity;
    const order = [...this.records].filter(i => this.picture(i)).sort((a, b) => rmse(a) - rmse(b));
    return order.find(i => rmse(i) > 1e-3) ?? order[0] ?? this.records[0];
  }

  picture(which, kind = this.kind) {
    return which === 'truth' ? pictureOf(kRecords[this.a], truthKind(kind)) : pictureOf(kRecords[which], kind);
  }

  // As it is shown: visibility without what is not measured.
  shownPicture(which) {
    const picture = this.picture(which);
    return this.kind === 'visibility' && picture ? masked(picture, this.picture(this.a, 'error')) : picture;
  }

  name(which) {
    return which === 'truth' ? 'truth' : kRecords[which].pipeline;
  }

  // What the second pane can show: key, text, picture.
  maps() {
    const list = [];
    const add = (key, text, picture) => picture && list.push([key, text, picture]);
    add('errorA', 'Error map of A', this.picture(this.a, 'error'));
    add('classesA', 'Error classes of A', this.picture(this.a, 'classes'));
    if (this.b !== 'truth') {
      add('errorB', 'Error map of B', this.picture(this.b, 'error'));
      add('classesB', 'Error classes of B', this.picture(this.b, 'classes'));
    }
    if (this.picture(this.a, 'visibility') && this.picture(this.b, 'visibility')) list.push(['difference', 'Difference A − B', null]);
    add('b', 'B beside A', this.shownPicture(this.b));
    return list;
  }

  build(host) {
    const select = (key, options) => choice(options, this[key], value => {
      this[key] = /^\d+$/.test(value) ? Number(value) : value;
      this.shown = key === 'b' ? 1 : 0;
      this.update();
      if (key === 'a') this.markRow();
    });
    const runs = this.records.map(i => [i, this.name(i)]);
    this.selectA = select('a', runs);
    this.selectB = select('b', this.hasTruth ? [['truth', 'truth'], ...runs] : runs);
    this.selectMap = choice([], '', value => {
      this.map = value;
      this.draw();
    });
    const modes = [['slider', 'Slider'], ['flip', 'Flip']].map(([mode, text]) => button(text, () => {
      if (mode === 'flip' && this.mode === 'flip') this.shown = 1 - this.shown;
      this.mode = mode;
      this.draw();
    }, { 'data-mode': mode }));
    this.modes = modes;
    this.slider = el('input', { type: 'range', class: 'split', min: 0, max: 100, step: 1, value: 50, 'aria-label': 'Share of the width that shows A',
      oninput: () => {
        this.share = this.slider.value / 100;
        this.mode = 'slider';
        this.draw();
      } });
    const listeners = { onkeydown: event => this.onKey(event), onpointermove: event => this.onMove(event), onpointerdown: event => this.onDown(event),
      onpointerup: event => { this.paneOf(event).dragging = null; }, onpointercancel: event => { this.paneOf(event).dragging = null; } };
    this.main = new Pane(this.view, 'A and B. Space flips them, arrows move the probe, plus and minus zoom.', listeners);
    this.second = new Pane(this.view, 'Map of the errors, linked with A and B', listeners);
    for (const pane of [this.main, this.second])
      pane.canvas.addEventListener('wheel', event => this.onWheel(event, pane), { passive: false });
    this.output = el('output', { class: 'probe', 'aria-live': 'polite' });
    const show = this.kinds.length > 1 ? labelled('Show', choice(this.kinds.map(k => [k, k]), this.kind, kind => {
      this.kind = kind;
      this.update();
    })) : null;
    const zoom = [button('−', () => this.view.zoomBy(0.5), { 'aria-label': 'Zoom out' }), button('+', () => this.view.zoomBy(2), { 'aria-label': 'Zoom in' }),
      button('Fit', () => this.view.reset())];
    host.append(el('div', { class: 'controls' }, labelled('A', this.selectA), labelled('B', this.selectB), show),
      el('div', { class: 'controls' }, ...modes, ...zoom, labelled('Beside', this.selectMap)),
      el('div', { class: 'panes' }, el('div', {}, this.main.element, this.slider), this.second.element), this.output,
      el('p', { class: 'hint' }, ...kKeysHelp.flatMap(([key, text], i) => [i ? ' · ' : '', el('kbd', {}, key), ' ' + text]), ' (on a picture; the wheel zooms once it has the focus)'));
    this.update();
  }

  // After another choice: the maps that there are now, decoded pictures, the marks elsewhere.
  update() {
    const maps = this.maps();
    if (!maps.some(([key]) => key === this.map)) this.map = maps[0]?.[0];
    this.selectMap.replaceChildren(...maps.map(([key, text]) => new Option(text, key, false, key === this.map)));
    this.selectA.value = this.a;
    this.selectB.value = this.b;
    this.draw();
    const wanted = [this.picture(this.a), this.picture(this.b), ...maps.map(([, , picture]) => picture)].filter(p => p?.decode && !p.complete);
    for (const picture of wanted) picture.decode().then(() => this.draw(), () => {});
  }

  markRow() {
    pickRun(this.section, this.a);
  }

  pick({ record, place }) {
    if (!this.records.includes(record)) return;
    const row = this.section.querySelector('tr[data-record="' + record + '"]');
    markPicked(row.closest('table'), row);
    if (record !== this.a) {
      this.a = record;
      this.shown = 0;
      this.update();
    }
    if (place) this.view.show(...place);
  }

  mapPicture() {
    const found = this.maps().find(([key]) => key === this.map);
    if (this.map !== 'difference') return found?.[2];
    const key = this.a + '/' + this.b;
    if (this.differenceKey !== key) {
      this.difference = differenceOf(this.picture(this.a, 'visibility'), this.picture(this.b, 'visibility'), this.picture(this.a, 'error'));
      this.differenceKey = this.difference ? key : null;
    }
    return this.difference;
  }

  draw() {
    if (!this.main) return;
    const a = this.picture(this.a), b = this.picture(this.b), shape = a ?? b;
    const size = shape?.naturalWidth ? { width: shape.naturalWidth, height: shape.naturalHeight } : null;
    const context = this.main.prepare(size), shownA = this.shownPicture(this.a), shownB = this.shownPicture(this.b);
    if (context) {
      if (this.mode === 'slider') {
        this.main.paint(context, shownA, 0, this.share);
        this.main.paint(context, shownB, this.share, 1);
        this.main.split(context, this.share);
      } else {
        this.main.paint(context, this.shown ? shownB : shownA);
      }
      this.main.cross(context, this.probe);
    }
    const flipping = this.mode === 'flip';
    this.main.left.textContent = 'A ' + this.name(this.a) + (flipping && !this.shown ? ' (shown)' : '');
    this.main.right.textContent = 'B ' + this.name(this.b) + (flipping && this.shown ? ' (shown)' : '');
    this.main.left.classList.toggle('hidden', flipping && this.shown === 1);
    this.main.right.classList.toggle('hidden', flipping && this.shown === 0);
    for (const press of this.modes) press.setAttribute('aria-pressed', press.dataset.mode === this.mode);
    this.slider.value = Math.round(100 * this.share);
    this.second.element.hidden = !this.map;
    const beside = this.second.prepare(size);
    if (beside) {
      this.second.paint(beside, this.mapPicture());
      this.second.cross(beside, this.probe);
    }
    this.second.left.textContent = this.selectMap.selectedOptions[0]?.textContent ?? '';
    this.read();
  }

  // The numbers under the probe.
  read() {
    if (!this.probe) {
      this.output.textContent = 'Point at a picture to read its pixels.';
      return;
    }
    const [u, v] = this.probe, [width, height] = kRecords[this.a].size, a = this.picture(this.a);
    const block = a?.naturalWidth ? Math.round(width / a.naturalWidth) : 1;
    const parts = ['Pixel ' + Math.floor(u * width) + ', ' + Math.floor(v * height) + (block > 1 ? ' (mean of about ' + block + ' × ' + block + ')' : '')];
    const values = [this.a, this.b].map(which => colorAt(this.picture(which), u, v));
    const text = color => !color ? '–' : this.kind === 'visibility' ? (color[0] / 255).toFixed(3) : 'rgb ' + color.join(' ');
    values.forEach((color, i) => parts.push('AB'[i] + ' ' + this.name(i ? this.b : this.a) + ': ' + text(color)));
    if (this.kind === 'visibility' && values[0] && values[1])
      parts.push('A − B: ' + ((values[0][0] - values[1][0]) / 255).toFixed(3).replace('-', '−'));
    const classes = pictureOf(kRecords[this.a], 'classes');
    if (classes) parts.push('class of A: ' + classAt(classes, u, v));
    else if (this.picture(this.a, 'error') && !isMeasured(colorAt(this.picture(this.a, 'error'), u, v) ?? [0], 0)) parts.push('not measured');
    this.output.textContent = parts.join(' · ');
  }

  flip() {
    this.mode = 'flip';
    this.shown = 1 - this.shown;
    this.draw();
  }

  moveProbe(dx, dy) {
    const picture = this.picture(this.a) ?? this.picture(this.b);
    if (!picture?.naturalWidth) return;
    const step = [1 / picture.naturalWidth, 1 / picture.naturalHeight], start = this.probe ?? [this.view.x, this.view.y];
    // In the middle of a pixel, so that rounding never decides which one is read.
    this.probe = [dx, dy].map((d, i) => {
      const count = 1 / step[i], index = Math.floor(start[i] * count) + d;
      return (Math.min(count - 1, Math.max(0, index)) + 0.5) * step[i];
    });
    const [s, t] = this.view.toPane(...this.probe);
    if (s < 0 || s > 1 || t < 0 || t > 1) this.view.show(...this.probe);
    else this.draw();
  }

  nextMap() {
    const keys = this.maps().map(([key]) => key);
    this.map = keys[(keys.indexOf(this.map) + 1) % keys.length];
    this.selectMap.value = this.map;
    this.draw();
  }

  onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const far = event.shiftKey ? 10 : 1;
    const actions = { ' ': () => this.flip(), f: () => this.flip(), e: () => this.nextMap(), '+': () => this.view.zoomBy(2), '=': () => this.view.zoomBy(2),
      '-': () => this.view.zoomBy(0.5), 0: () => this.view.reset(), ArrowLeft: () => this.moveProbe(-far, 0), ArrowRight: () => this.moveProbe(far, 0),
      ArrowUp: () => this.moveProbe(0, -far), ArrowDown: () => this.moveProbe(0, far) };
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  paneOf(event) {
    return event.currentTarget === this.main.canvas ? this.main : this.second;
  }

  onDown(event) {
    const pane = this.paneOf(event), [s] = pane.place(event);
    const near = pane === this.main && this.mode === 'slider' && Math.abs(s - this.share) * pane.canvas.clientWidth < 20;
    pane.dragging = near ? 'split' : 'view';
    pane.canvas.setPointerCapture(event.pointerId);
  }

  onMove(event) {
    const pane = this.paneOf(event), [s, t] = pane.place(event);
    if (pane.dragging === 'split') this.share = Math.min(1, Math.max(0, s));
    if (pane.dragging === 'view' && this.view.zoom > 1) {
      this.view.moveBy(-event.movementX / pane.canvas.clientWidth / this.view.zoom, -event.movementY / pane.canvas.clientHeight / this.view.zoom);
      return;
    }
    const [u, v] = this.view.toPicture(s, t);
    if (u >= 0 && u < 1 && v >= 0 && v < 1) this.probe = [u, v];
    this.draw();
  }

  // The page scrolls under the wheel until a picture has been chosen.
  onWheel(event, pane) {
    if (!event.ctrlKey && document.activeElement !== pane.canvas) return;
    event.preventDefault();
    this.view.zoomBy(event.deltaY < 0 ? 1.25 : 0.8, ...this.view.toPicture(...pane.place(event)));
  }
}
