'use strict';
// A movable pinhole camera. It orbits around its target or looks around from a fixed position; `up` never changes. It
// keeps its room in sight.

// Rotates a about a unit axis, counter-clockwise seen from its tip (Rodrigues' formula).
function turned(a, axis, angle) {
  const along = times(dot(axis, a) * (1 - Math.cos(angle)), axis);
  return plus(plus(times(Math.cos(angle), a), times(Math.sin(angle), cross(axis, a))), along);
}

// The product of two 4 x 4 matrices, stored column by column.
function matrix_product(a, b) {
  const result = new Float32Array(16);
  for (let column = 0; column < 4; ++column)
    for (let row = 0; row < 4; ++row)
      for (let k = 0; k < 4; ++k)
        result[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return result;
}

const steepest = 0.996; // largest cosine between view and up, so that the view never turns over

class Camera {
  constructor(first, { box: [low, high], size, zero }) {
    this.first = { ...first, eye: minus(first.eye, zero), target: minus(first.target, zero) };
    this.zero = zero; // the point of the scene that positions in the room are relative to
    this.size = size; // diagonal of the room, the unit of steps
    this.centre = times(0.5, plus(low, high));
    // Half the size of the box where the eye may be without looking at it: a little less than the room, so that an eye
    // in front of a wall sees the wall.
    this.half = minus(high, low).map(x => Math.max(0.5 * x - 0.01 * size, 0.01 * size));
    this.reset();
  }

  reset() {
    this.eye = this.first.eye.slice();
    this.target = this.first.target.slice();
    this.up = normalized(this.first.up);
  }

  // Shows the whole room from outside and above.
  go_outside(aspect) {
    const angle = Math.atan(Math.tan(0.5 * this.angle(aspect)) * Math.min(1, aspect));
    const level = normalized(cross(this.up, this.right()));
    this.target = this.centre;
    this.eye = plus(this.centre, times(-0.5 * this.size / Math.sin(angle), normalized(minus(level, times(0.8, this.up)))));
  }

  away() { return length(minus(this.eye, this.centre)); }
  within() { return this.eye.every((x, k) => Math.abs(x - this.centre[k]) <= this.half[k]); }

  // True if the eye is in the room, or if the middle of the picture shows its box, and it takes a quarter of the height.
  sees_room() {
    let near = 0, far = Infinity; // where the view passes between the planes of the box
    this.forward().forEach((along, k) => {
      const to_middle = (this.centre[k] - this.eye[k]) / (along || 1e-9), half = this.half[k] / Math.abs(along || 1e-9);
      near = Math.max(near, to_middle - half);
      far = Math.min(far, to_middle + half);
    });
    return near <= far && this.away() <= 2 * this.size / Math.tan(0.5 * this.angle(1));
  }

  // Carries out a change of the view. One that loses sight of the room from within ends at its walls, others are undone.
  // A first view that does not see it may be changed freely.
  keep_room(change) {
    const { eye, target } = this, seen = this.sees_room(), within = this.within();
    change(this);
    if (seen && within && !this.sees_room())
      this.move(minus(this.eye.map((x, k) => clamped(x, this.centre[k] - this.half[k], this.centre[k] + this.half[k])), this.eye));
    if (seen && !this.sees_room())
      Object.assign(this, { eye, target });
  }

  forward() { return normalized(minus(this.target, this.eye)); }
  right() { return normalized(cross(this.forward(), this.up)); }
  distance() { return length(minus(this.target, this.eye)); }

  // A direction turned by angles to the left and upwards.
  aimed(direction, left, up) {
    const level = turned(direction, this.up, left);
    const raised = turned(level, normalized(cross(level, this.up)), up);
    return Math.abs(dot(raised, this.up)) < steepest ? raised : level;
  }

  // Moves on a sphere around the target, so that the scene follows the pointer.
  orbit(left, up) {
    const distance = this.distance();
    this.eye = minus(this.target, times(distance, this.aimed(this.forward(), left, up)));
  }

  look(left, up) {
    const distance = this.distance();
    this.target = plus(this.eye, times(distance, this.aimed(this.forward(), left, up)));
  }

  move(step) {
    this.eye = plus(this.eye, step);
    this.target = plus(this.target, step);
  }

  // Steps as fractions of the room's size; `ahead` is horizontal, whatever the direction of the view.
  walk(ahead, aside, upwards) {
    const level = normalized(cross(this.up, this.right()));
    const step = plus(times(ahead, level), plus(times(aside, this.right()), times(upwards, this.up)));
    this.move(times(this.size, step));
  }

  // Shifts as fractions of the picture's height, at the distance of the target.
  shift(x, y) {
    const height = 2 * this.distance() * Math.tan(0.5 * this.angle(1));
    const up = cross(this.right(), this.forward());
    this.move(plus(times(-x * height, this.right()), times(y * height, up)));
  }

  // Multiplies the distance to the target; a factor below 1 moves nearer. A target that is reached moves on, so that
  // one can go through a room.
  approach(factor) {
    const wanted = factor * this.distance(), least = 0.02 * this.size;
    const distance = Math.max(wanted, least);
    this.eye = minus(this.target, times(distance, this.forward()));
    if (wanted < least)
      this.move(times(least - wanted, this.forward()));
  }

  // The vertical field of view [radians]. The given one is for pictures of 4 : 3. Narrower pictures get a larger one,
  // so that they show the same width as far as the distortion allows.
  angle(aspect) {
    const half = Math.tan(this.first.field_of_view * Math.PI / 360);
    const widened = Math.min(half * Math.max(1, 4 / 3 / aspect), Math.max(half, 1));
    return 2 * Math.atan(widened);
  }

  // The view as --camera of the program reads it: in metres, and degrees for a picture with this aspect ratio.
  view(aspect) {
    const rounded = x => Number(x.toPrecision(15)); // so many even where positions are those of a map
    return { eye: plus(this.eye, this.zero).map(rounded), target: plus(this.target, this.zero).map(rounded),
             up: this.up.map(rounded), fov: rounded(this.angle(aspect) * 180 / Math.PI) };
  }

  // The direction of the ray through a point of a picture, in pixels from its top left corner.
  ray(x, y, width, height) {
    const pixel = 2 * Math.tan(0.5 * this.angle(width / height)) / height;
    const forward = this.forward(), right = this.right(), up = cross(right, forward);
    const aside = times((x - 0.5 * width) * pixel, right), upwards = times((0.5 * height - y) * pixel, up);
    return normalized(plus(forward, plus(aside, upwards)));
  }

  // The matrix from positions in the room to clip coordinates.
  matrix(aspect) {
    const f = this.forward(), r = this.right(), u = cross(r, f), e = this.eye;
    const view = [r[0], u[0], -f[0], 0, r[1], u[1], -f[1], 0, r[2], u[2], -f[2], 0,
                  -dot(r, e), -dot(u, e), dot(f, e), 1];
    const scale = 1 / Math.tan(0.5 * this.angle(aspect));
    const near = Math.max(0.002 * this.size, 0.9 * (this.away() - 0.5 * this.size)), far = this.away() + this.size;
    const depth = (far + near) / (near - far), shift = 2 * far * near / (near - far);
    return matrix_product([scale / aspect, 0, 0, 0, 0, scale, 0, 0, 0, 0, depth, -1, 0, 0, shift, 0], view);
  }
}
