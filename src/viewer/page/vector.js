'use strict';
// Points and directions: lists of three numbers.

const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (s, a) => [s * a[0], s * a[1], s * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = a => Math.hypot(a[0], a[1], a[2]);
const normalized = a => times(1 / length(a), a);
const clamped = (x, low, high) => Math.min(high, Math.max(low, x));

// Turns a about a unit axis, counter-clockwise seen from its tip (Rodrigues).
function turned(a, axis, angle) {
  const along = times(dot(axis, a) * (1 - Math.cos(angle)), axis);
  return plus(plus(times(Math.cos(angle), a), times(Math.sin(angle), cross(axis, a))), along);
}

// A matrix of 4 x 4 numbers, column by column, times another one.
function matrix_product(a, b) {
  const result = new Float32Array(16);
  for (let column = 0; column < 4; ++column)
    for (let row = 0; row < 4; ++row)
      for (let k = 0; k < 4; ++k)
        result[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return result;
}
