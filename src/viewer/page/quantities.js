'use strict';
// Quantities that can be shown: values of patches, as light or in false colours.

// Red, green and blue of a colour with a shared exponent (RGB9_E5).
function shared_exponent_colour(word) {
  const scale = 2 ** ((word >>> 27) - 24);
  return [(word & 511) * scale, (word >>> 9 & 511) * scale, (word >>> 18 & 511) * scale];
}

// Values for a texture, unpacked when they are first needed.
class Values {
  constructor(kind, unit, unpack) {
    this.kind = kind; // 'colours': three numbers each; 'light': one packed word each; 'means': one number each
    this.unit = unit;
    this.unpack = unpack;
  }

  get list() { return this.unpacked ||= this.unpack(); }

  // Value n as a list of one or three numbers.
  at(n) {
    if (this.kind === 'colours')
      return Array.from(this.list.subarray(3 * n, 3 * n + 3));
    if (this.kind === 'light')
      return times(this.unit, shared_exponent_colour(this.list[n]));
    return [this.list[n]];
  }
}

const light_values = data => new Values('light', data.light_unit, () => counts_of(data.light));

// Packed light at the corners of patches. The list holds the shared values of grid points, then the own values of some
// corners.
function corner_words(data, room) {
  const words = counts_of(data.corners), places = counts_of(data.own_places), shared = words.length - places.length;
  const result = room.patch_corners(words);
  places.forEach((place, k) => { result[place] = words[shared + k]; });
  return result;
}

// Light of the patches, and of their corners for smooth shading.
const light_of = (data, room) => ({
  light: true,
  patches: data.values ? new Values('colours', 1, () => numbers_of(data.values))
                       : light_values(data),
  corners: new Values('light', data.corners_unit, () => corner_words(data, room)),
});
const means_of = data => ({ light: false, patches: new Values('means', 1, () => numbers_of(data.means)) });

class Quantities {
  constructor(data, room) {
    this.list = data.quantities.map(quantity => ({
      key: quantity.key, title: quantity.title, unit: quantity.unit, legend: quantity.legend,
      ...(quantity.means ? means_of(quantity) : light_of(quantity, room)),
    }));
    this.colour_map = bytes_of(data.colour_map);
  }
}

// A number as text with this many digits.
function number_text(x, digits = 4) {
  if (!Number.isFinite(x))
    return 'none';
  const magnitude = Math.abs(x);
  const extreme = magnitude !== 0 && (magnitude < 1e-3 || magnitude >= 1e6);
  const text = extreme ? x.toExponential(2) : String(Number(x.toPrecision(digits)));
  return text.replace('e+', 'e').replace(/-/g, '−');
}

// A colour as text: one number if the channels agree, otherwise three.
function colour_text(c, digits) {
  const numbers = c.map(x => number_text(x, digits));
  return numbers.every(x => x === numbers[0]) ? numbers[0] : numbers.join(', ');
}
