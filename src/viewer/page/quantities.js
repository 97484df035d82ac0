'use strict';
// Quantities that can be shown: values of patches, as light or in false colours.

// Values for a texture, unpacked when they are first needed.
class Values {
  constructor(kind, unit, unpack) {
    this.kind = kind; // 'colours': three numbers each; 'means': one number each; 'corners': one packed word each
    this.unit = unit;
    this.unpack = unpack;
  }

  get list() { return this.unpacked ||= this.unpack(); }

  // Value n as a list of one or three numbers.
  at(n) {
    const size = this.kind === 'colours' ? 3 : 1;
    return Array.from(this.list.subarray(size * n, size * (n + 1)));
  }
}

const colours_of = text => new Values('colours', 1, () => numbers_of(text));

// Light of the patches, and of their corners for smooth shading; or one number for each patch.
const values_of = data => data.means ? { light: false, patches: new Values('means', 1, () => numbers_of(data.means)) }
  : { light: true, patches: colours_of(data.values), corners: new Values('corners', data.corners_unit, () => counts_of(data.corners)) };

class Quantities {
  constructor(data) {
    this.list = data.quantities.map(quantity => ({
      key: quantity.key, title: quantity.title, unit: quantity.unit, legend: quantity.legend,
      ...values_of(quantity),
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
