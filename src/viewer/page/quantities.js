'use strict';
// Quantities that can be shown: values of patches, as light or in false colours; numbers as text.

// A quantity: { key, title, unit, legend, light, values, corners, corners_unit }, with three numbers per patch and, at the
// corners of the patches, three of 16 bits, each in corners_unit, if it is shown as light; else with one per patch.
const quantity_of = ({ values, corners, ...data }) => ({ ...data, light: !data.legend, values: numbers_of(values),
  corners: corners && new Uint16Array(bytes_of(corners).buffer) });
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
