'use strict';
// Quantities that can be shown: values of patches, as light or in false colours; numbers as text.

// A quantity: { key, title, unit, legend, light, values, corners, corners_unit }, with three numbers per patch and, at the
// corners of the patches, three of 16 bits, each in corners_unit, if it is shown as light; else with one per patch.
const quantity_of = (data, room) => ({ ...data, light: !data.legend, values: numbers_of(data.values),
  corners: data.corners && corners_of(data, room) });

// The light at the four corners of each patch, from that at the points of the grids and the own values of some corners.
function corners_of(data, room) {
  const light = new Uint16Array(bytes_of(data.corners).buffer), places = counts_of(data.own_places);
  const numbers = room.point_numbers.slice(), result = new Uint16Array(3 * numbers.length);
  places.forEach((place, k) => { numbers[place] = light.length / 3 - places.length + k; });
  for (let n = 0; n < result.length; ++n)
    result[n] = light[3 * numbers[Math.floor(n / 3)] + n % 3];
  return result;
}
const value_at = ({ light, values }, patch) => light ? three_at(values, patch) : [values[patch]];

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
