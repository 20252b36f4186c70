// SPDX-License-Identifier: MIT
// What part of the pictures is seen, shared by both panes: zoom 1 is the whole width, x and y the middle in [0,1].
const kMostZoom = 32;

class View {
  constructor(changed) {
    this.changed = changed;
    this.reset();
  }

  reset() {
    this.zoom = 1;
    this.x = this.y = 0.5;
    this.changed();
  }

  // Keeps the place (u, v) where it is on the screen.
  zoomBy(factor, u = this.x, v = this.y) {
    const zoom = Math.min(kMostZoom, Math.max(1, this.zoom * factor)), kept = this.zoom / zoom;
    this.x = u + (this.x - u) * kept;
    this.y = v + (this.y - v) * kept;
    this.zoom = zoom;
    this.settle();
  }

  moveBy(du, dv) {
    this.x += du;
    this.y += dv;
    this.settle();
  }

  show(u, v, zoom = this.zoom) {
    this.zoom = Math.min(kMostZoom, Math.max(1, zoom));
    [this.x, this.y] = [u, v];
    this.settle();
  }

  settle() {
    const half = 0.5 / this.zoom, clamp = value => Math.min(1 - half, Math.max(half, value));
    this.x = clamp(this.x);
    this.y = clamp(this.y);
    this.changed();
  }

  // From [0,1] of the pane to [0,1] of the picture, and back.
  toPicture(s, t) {
    return [this.x + (s - 0.5) / this.zoom, this.y + (t - 0.5) / this.zoom];
  }

  toPane(u, v) {
    return [(u - this.x) * this.zoom + 0.5, (v - this.y) * this.zoom + 0.5];
  }

  // The visible part as [u0, v0, width, height].
  part() {
    const size = 1 / this.zoom;
    return [this.x - size / 2, this.y - size / 2, size, size];
  }
}
