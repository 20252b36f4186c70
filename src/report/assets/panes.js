// SPDX-License-Identifier: MIT
// A canvas that shows the same part of its pictures as its neighbour, with the probe's cross.
class Pane {
  constructor(view, label, listeners) {
    this.view = view;
    this.canvas = el('canvas', { tabindex: 0, role: 'application', 'aria-label': label, ...listeners });
    this.left = el('span', {});
    this.right = el('span', {});
    this.element = el('figure', { class: 'pane' }, this.canvas, el('figcaption', {}, this.left, this.right));
    this.dragging = null;
  }

  // Place of a pointer in the pane, [0,1] each way.
  place(event) {
    const box = this.canvas.getBoundingClientRect();
    return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
  }

  // Fits the canvas to its width on the screen and the picture's shape; nothing while it is not shown.
  prepare(shape) {
    const width = this.canvas.clientWidth, ratio = window.devicePixelRatio || 1;
    if (!width || !shape) return null;
    const height = Math.round(width * shape.height / shape.width);
    this.canvas.style.height = height + 'px';
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    return this.canvas.getContext('2d');
  }

  // One picture between two shares of the pane's width.
  paint(context, picture, from = 0, to = 1) {
    if (!picture) return;
    const width = picture.naturalWidth ?? picture.width, height = picture.naturalHeight ?? picture.height;
    const [u, v, du, dv] = this.view.part(), canvas = this.canvas;
    context.save();
    context.beginPath();
    context.rect(from * canvas.width, 0, (to - from) * canvas.width, canvas.height);
    context.clip();
    // From here on a pixel is to be seen as one.
    context.imageSmoothingEnabled = canvas.width / (du * width) < 2;
    context.drawImage(picture, u * width, v * height, du * width, dv * height, 0, 0, canvas.width, canvas.height);
    context.restore();
  }

  // Black beside white is seen on every ground.
  stroke(context, lines) {
    for (const [color, size] of [['#000', 4], ['#fff', 1.5]]) {
      context.strokeStyle = color;
      context.lineWidth = size;
      context.beginPath();
      for (const [x1, y1, x2, y2] of lines) {
        context.moveTo(x1, y1);
        context.lineTo(x2, y2);
      }
      context.stroke();
    }
  }

  cross(context, probe) {
    if (!probe) return;
    const [s, t] = this.view.toPane(...probe), x = s * this.canvas.width, y = t * this.canvas.height, r = this.canvas.width * 0.02;
    this.stroke(context, [[x - 2 * r, y, x - r, y], [x + r, y, x + 2 * r, y], [x, y - 2 * r, x, y - r], [x, y + r, x, y + 2 * r]]);
  }

  split(context, share) {
    const x = share * this.canvas.width, y = this.canvas.height / 2, r = this.canvas.width * 0.012;
    this.stroke(context, [[x, 0, x, this.canvas.height], [x - r, y - r, x - 2 * r, y], [x - 2 * r, y, x - r, y + r],
      [x + r, y - r, x + 2 * r, y], [x + 2 * r, y, x + r, y + r]]);
  }
}
