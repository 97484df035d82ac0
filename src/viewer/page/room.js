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

// The room: its surfaces, and how they are cut into patches. The page holds surfaces only; patches are looked up from a
// place (u, v) on them, with the numbers that the program gives them (src/scene/tessellation.h).

// The bytes of a base64 text.
function bytes_of(text) {
  if (Uint8Array.fromBase64)
    return Uint8Array.fromBase64(text); // browsers since 2025, several times as fast
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let k = 0; k < bytes.length; ++k)
    bytes[k] = characters.charCodeAt(k);
  return bytes;
}
const counts_of = text => new Uint32Array(bytes_of(text).buffer);
const numbers_of = text => new Float32Array(bytes_of(text).buffer);

class Room {
  constructor(data) {
    this.materials = data.materials;
    this.groups = data.groups;
    this.two_sided = data.two_sided;
    this.patch_count = data.patches;
    this.triangles = bytes_of(data.surfaces.triangles);
    this.geometry = numbers_of(data.surfaces.geometry);
    this.cells = counts_of(data.surfaces.cells);
    this.material = counts_of(data.surfaces.materials);
    this.group = counts_of(data.surfaces.groups);
    this.line = counts_of(data.surfaces.lines);
    this.covered = new Set(counts_of(data.surfaces.covered));
    this.surface_count = this.triangles.length;
    this.number_patches();
    this.find_size();
  }

  // Patches are numbered surface by surface, and so are the points of the grids that cut them; backs come after all
  // fronts.
  number_patches() {
    this.first_patch = new Uint32Array(this.surface_count + 1);
    this.first_point = new Uint32Array(this.surface_count + 1);
    for (let s = 0; s < this.surface_count; ++s) {
      const [n, m] = this.cells_of(s);
      this.first_patch[s + 1] = this.first_patch[s] + n * m;
      this.first_point[s + 1] = this.first_point[s] + (this.triangles[s] ? (n + 1) * (n + 2) / 2 : (n + 1) * (m + 1));
    }
    this.cell_count = this.first_patch[this.surface_count];
    this.point_count = this.first_point[this.surface_count];
  }

  find_size() {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let s = 0; s < this.surface_count; ++s)
      for (const point of this.outline(s))
        for (let k = 0; k < 3; ++k) {
          low[k] = Math.min(low[k], point[k]);
          high[k] = Math.max(high[k], point[k]);
        }
    this.size = length(minus(high, low));
  }

  cells_of(s) { return [this.cells[2 * s], this.cells[2 * s + 1]]; }
  vector(s, k) { return Array.from(this.geometry.subarray(9 * s + 3 * k, 9 * s + 3 * k + 3)); }
  origin(s) { return this.vector(s, 0); }
  edge_u(s) { return this.vector(s, 1); }
  edge_v(s) { return this.vector(s, 2); }
  point(s, u, v) { return plus(this.origin(s), plus(times(u, this.edge_u(s)), times(v, this.edge_v(s)))); }

  // The corners (u, v) of a surface, counter-clockwise.
  corners(s) { return this.triangles[s] ? [[0, 0], [1, 0], [0, 1]] : [[0, 0], [1, 0], [1, 1], [0, 1]]; }
  outline(s) { return this.corners(s).map(([u, v]) => this.point(s, u, v)); }

  // The patch at a place of a surface; null on the back of a one-sided one.
  patch_at(s, u, v, front) {
    if (!front && !this.two_sided)
      return null;
    const [n, m] = this.cells_of(s);
    const index = (x, cells) => clamped(Math.floor(x * cells), 0, cells - 1);
    const i = index(u, n);
    let cell;
    if (this.triangles[s]) {
      // Column i holds 2 (n - i) - 1 triangles: upright and upside-down ones in turn.
      const last = n - 1 - i, j = Math.min(index(v, n), last);
      const upper = j < last && u * n - i + (v * n - j) > 1;
      cell = i * (2 * n - i) + 2 * j + (upper ? 1 : 0);
    } else {
      cell = i * m + index(v, m);
    }
    return (front ? 0 : this.cell_count) + this.first_patch[s] + cell;
  }

  // What of a surface is to be drawn, as lists of corners (u, v): all of it; or cells one by one, without those that
  // lie under others of the same plane.
  pieces(s) {
    const [n, m] = this.cells_of(s), seen = [];
    const covered = patch => this.covered.has(patch) && (!this.two_sided || this.covered.has(patch + this.cell_count));
    for (let cell = 0; this.covered.size && cell < n * m; ++cell)
      if (!covered(this.first_patch[s] + cell))
        seen.push(cell);
    if (!this.covered.size || seen.length === n * m)
      return [this.corners(s)];
    return seen.map(cell => this.cell_corners(s, cell).map(([i, j]) => [i / n, j / m]));
  }

  is_back(patch) { return patch >= this.cell_count; }

  surface_of(patch) {
    const cell = patch % this.cell_count;
    let low = 0, high = this.surface_count;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.first_patch[middle] <= cell) low = middle; else high = middle;
    }
    return low;
  }

  material_of(patch) { return this.materials[this.material[this.surface_of(patch)]]; }
  is_source(s) { return this.materials[this.material[s]].emittance.some(x => x > 0); }
  emittance(patch) { return this.is_back(patch) ? [0, 0, 0] : this.material_of(patch).emittance; }

  area(patch) {
    const s = this.surface_of(patch), [n, m] = this.cells_of(s);
    return length(cross(this.edge_u(s), this.edge_v(s))) * (this.triangles[s] ? 0.5 : 1) / (n * m);
  }

  // The corners of a cell on the grid of its surface, in the order of the program: counter-clockwise.
  cell_corners(s, cell) {
    const [n, m] = this.cells_of(s);
    if (!this.triangles[s]) {
      const i = Math.floor(cell / m), j = cell % m;
      return [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
    }
    let i = Math.max(0, Math.floor(n - Math.sqrt(n * n - cell)) - 1); // the column or one before it
    while ((i + 1) * (2 * n - i - 1) <= cell)
      ++i;
    const place = cell - i * (2 * n - i), j = place >> 1;
    return place % 2 ? [[i + 1, j + 1], [i, j + 1], [i + 1, j]] : [[i, j], [i + 1, j], [i, j + 1]];
  }

  // The corners of a patch in space.
  patch_outline(patch) {
    const s = this.surface_of(patch), [n, m] = this.cells_of(s);
    const cell = patch % this.cell_count - this.first_patch[s];
    return this.cell_corners(s, cell).map(([i, j]) => this.point(s, i / n, j / m));
  }

  // Four places per patch for what its corners have, given what they share at the points of the grids. A triangle
  // leaves one place empty.
  patch_corners(shared) {
    const result = new Uint32Array(4 * this.patch_count);
    for (let back = 0; back < (this.two_sided ? 2 : 1); ++back)
      for (let s = 0; s < this.surface_count; ++s) {
        const first_point = back * this.point_count + this.first_point[s];
        const first_place = 4 * (back * this.cell_count + this.first_patch[s]);
        if (this.triangles[s])
          this.copy_triangle_corners(s, shared.subarray(first_point), result.subarray(first_place));
        else
          this.copy_grid_corners(s, shared.subarray(first_point), result.subarray(first_place));
      }
    return result;
  }

  // Without a list for each of what may be many cells.
  copy_grid_corners(s, shared, result) {
    const [n, m] = this.cells_of(s);
    let place = 0;
    for (let i = 0; i < n; ++i)
      for (let j = 0; j < m; ++j) {
        const point = j * (n + 1) + i, above = point + n + 1;
        result[place++] = shared[point];
        result[place++] = shared[point + 1];
        result[place++] = shared[above + 1];
        result[place++] = shared[above];
      }
  }

  // The rows of a triangle get shorter.
  copy_triangle_corners(s, shared, result) {
    const n = this.cells_of(s)[0];
    for (let cell = 0; cell < n * n; ++cell)
      this.cell_corners(s, cell).forEach(([i, j], k) => {
        result[4 * cell + k] = shared[j * (n + 1) - j * (j - 1) / 2 + i];
      });
  }

  // "table_top (line 12)", as the program names surfaces.
  surface_name(s) {
    return `${this.groups[this.group[s]] || this.materials[this.material[s]].name} (line ${this.line[s]})`;
  }

  // What a ray meets first. Backs of one-sided surfaces are looked through, as in the program's pictures.
  nearest_hit(origin, direction) {
    const g = this.geometry;
    let nearest = null;
    for (let s = 0, k = 0; s < this.surface_count; ++s, k += 9) {
      const a = [g[k + 3], g[k + 4], g[k + 5]], b = [g[k + 6], g[k + 7], g[k + 8]];
      const across = cross(direction, b);
      const determinant = dot(a, across); // = -direction . (a x b): above zero where the ray meets the front
      if (determinant === 0 || (determinant < 0 && !this.two_sided))
        continue;
      const from = [origin[0] - g[k], origin[1] - g[k + 1], origin[2] - g[k + 2]];
      const u = dot(from, across) / determinant;
      if (!(u >= 0 && u <= 1))
        continue;
      const upright = cross(from, a);
      const v = dot(direction, upright) / determinant;
      if (!(v >= 0 && (this.triangles[s] ? u + v : v) <= 1))
        continue;
      const t = dot(b, upright) / determinant;
      if (!(t > 0 && (nearest === null || t < nearest.t)))
        continue;
      const patch = this.patch_at(s, u, v, determinant > 0);
      if (!this.covered.has(patch))
        nearest = { t, surface: s, u, v, front: determinant > 0, patch };
    }
    return nearest;
  }
}
