// SPDX-License-Identifier: MIT
// The pictures of the page and the numbers in them. Each stands in the gallery once and is decoded when it is first asked for.
const kPictures = new Map([...document.querySelectorAll('img[data-path]')].map(image => [image.dataset.path, image]));
const kPixels = new WeakMap();

// The embedded picture of a run, or undefined.
const pictureOf = (record, kind) => kPictures.get(record?.images?.[kind]);
const truthKind = kind => kind === 'picture' ? 'reference' : 'truth';

function pixelsOf(image) {
  if (!image?.naturalWidth) return null;
  if (!kPixels.has(image)) {
    const canvas = el('canvas', { width: image.naturalWidth, height: image.naturalHeight });
    const context = canvas.getContext('2d', { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    kPixels.set(image, context.getImageData(0, 0, canvas.width, canvas.height));
  }
  return kPixels.get(image);
}

// Error maps paint what is not measured in a grey that their scale does not have.
const kNotMeasured = kColors.classes.at(-1).color;
const isMeasured = (data, i) => kNotMeasured.some((c, k) => Math.abs(data[i + k] - c) > 1);

// A visibility picture in which what is not measured is grey too: whatever stands there counts for nothing.
const kMasked = new WeakMap();
function masked(image, errorMap) {
  const pixels = pixelsOf(image), errors = pixelsOf(errorMap);
  if (!pixels || !errors || pixels.width !== errors.width || pixels.height !== errors.height) return image;
  if (!kMasked.has(image)) {
    const canvas = el('canvas', { width: pixels.width, height: pixels.height });
    const result = new ImageData(new Uint8ClampedArray(pixels.data), pixels.width, pixels.height);
    for (let i = 0; i < result.data.length; i += 4) if (!isMeasured(errors.data, i)) result.data.set(kNotMeasured, i);
    canvas.getContext('2d').putImageData(result, 0, 0);
    kMasked.set(image, canvas);
  }
  return kMasked.get(image);
}

// Red, green and blue at a place of the picture, u and v in [0,1).
function colorAt(image, u, v) {
  const pixels = pixelsOf(image);
  if (!pixels) return null;
  const x = Math.min(pixels.width - 1, Math.floor(u * pixels.width)), y = Math.min(pixels.height - 1, Math.floor(v * pixels.height));
  return [...pixels.data.subarray(4 * (y * pixels.width + x), 4 * (y * pixels.width + x) + 3)];
}

// Of a class picture: the class whose colour is nearest.
function classAt(image, u, v) {
  const color = colorAt(image, u, v);
  if (!color) return null;
  const distance = entry => entry.color.reduce((sum, c, i) => sum + (c - color[i]) ** 2, 0);
  return kColors.classes.reduce((best, entry) => distance(entry) < distance(best) ? entry : best).key;
}

// A - B of two visibility pictures of one size in the colours of the error maps, or null.
function differenceOf(a, b, errorMap) {
  const first = pixelsOf(a), second = pixelsOf(b);
  if (!first || !second || first.width !== second.width || first.height !== second.height) return null;
  const ramp = kColors.ramp.map(text => text.match(/\d+/g).map(Number)), middle = (ramp.length - 1) / 2;
  const canvas = el('canvas', { width: first.width, height: first.height }), context = canvas.getContext('2d');
  const result = context.createImageData(first.width, first.height), errors = pixelsOf(errorMap);
  for (let i = 0; i < result.data.length; i += 4) {
    const error = (first.data[i] - second.data[i]) / 255;
    const color = ramp[Math.round(middle + middle * Math.sign(error) * Math.sqrt(Math.abs(error)))];
    result.data.set([...(!errors || isMeasured(errors.data, i) ? color : kNotMeasured), 255], i);
  }
  context.putImageData(result, 0, 0);
  return canvas;
}
