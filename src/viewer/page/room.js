'use strict';
// Surfaces of the room and their patches. Before them, vectors: points and directions are lists of three numbers.

const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (s, a) => [s * a[0], s * a[1], s * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = a => Math.hypot(a[0], a[1], a[2]);
const normalized = a => times(1 / length(a), a);
const clamped = (x, low, high) => Math.min(high, Math.max(low, x));

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
const three_at = (list, n) => Array.from(list.subarray(3 * n, 3 * n + 3));

// The corners (u, v) of a parallelogram and of a triangle, counter-clockwise.
const unit_corners = [[[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 0], [1, 0], [0, 1]]];

// The room: its surfaces, and the patches that they are cut into.
class Room {
  constructor(data) {
    this.file = data.scene.replace(/^.*\//, '');
    this.materials = data.materials;
    this.groups = data.groups;
    this.two_sided = data.two_sided;
    this.patch_count = data.patches;
    this.power_unit = data.power_unit;
    this.triangles = bytes_of(data.surfaces.triangles);
    this.geometry = numbers_of(data.surfaces.geometry);
    this.zero = data.surfaces.origin; // the point of the scene that all positions are relative to
    this.size = data.surfaces.size; // diagonal
    this.grids = counts_of(data.surfaces.grids); // per surface: the steps of its grid along u and v, its first patch
    // Per patch of the fronts, on the grid of its surface: the corner (i, j) at its origin, and its size, negative upside
    // down in a triangle. Backs are numbered after all fronts.
    this.cells = new Int32Array(bytes_of(data.surfaces.cells).buffer);
    this.material = counts_of(data.surfaces.materials);
    this.group = counts_of(data.surfaces.groups);
    this.line = counts_of(data.surfaces.lines);
    this.frames = numbers_of(data.surfaces.texture_frames);
    this.reflectances = data.reflectances ? numbers_of(data.reflectances) : null;
    this.covered = new Set(counts_of(data.surfaces.covered));
    this.surface_count = this.triangles.length;
    this.cell_count = this.cells.length / 3;
    this.surface = new Uint32Array(this.cell_count); // of each patch
    for (let s = 0; s < this.surface_count; ++s)
      this.surface.fill(s, this.first_patch(s), this.first_patch(s + 1));
    this.number_points();
    const corners = Array.from({ length: this.surface_count }, (_, s) => this.outline(s)).flat();
    this.box = [Math.min, Math.max].map(end => corners.reduce((a, b) => a.map((x, k) => end(x, b[k]))));
    this.areas = Float64Array.from({ length: this.patch_count }, (_, patch) => this.area(patch));
    this.all = this.totals();
  }

  // For each corner of each patch the number of its point on the grid of its side, in the order in which patches meet them.
  number_points() {
    this.point_numbers = new Uint32Array(4 * this.patch_count);
    let known, count = 0;
    for (let patch = 0; patch < this.patch_count; ++patch) {
      const cell = patch % this.cell_count, s = this.surface[cell];
      if (cell === this.first_patch(s))
        known = new Map();
      const [i, j, size] = [this.cells[3 * cell], this.cells[3 * cell + 1], this.cells[3 * cell + 2]];
      for (const [k, [x, y]] of unit_corners[this.triangles[s]].entries()) {
        const point = i + x * size + (j + y * size) * 2 ** 26;
        if (!known.has(point))
          known.set(point, count++);
        this.point_numbers[4 * patch + k] = known.get(point);
      }
    }
  }

  first_patch(s) { return s < this.surface_count ? this.grids[3 * s + 2] : this.cell_count; }
  grid(s) { return this.grids.subarray(3 * s, 3 * s + 2); }
  origin(s) { return three_at(this.geometry, 3 * s); }
  edge_u(s) { return three_at(this.geometry, 3 * s + 1); }
  edge_v(s) { return three_at(this.geometry, 3 * s + 2); }
  point(s, u, v) { return plus(this.origin(s), plus(times(u, this.edge_u(s)), times(v, this.edge_v(s)))); }

  shows_texture(s) { return this.frames.length > 0 && Number.isFinite(this.frames[6 * s]); }

  corners(s) { return unit_corners[this.triangles[s]]; }
  outline(s) { return this.corners(s).map(([u, v]) => this.point(s, u, v)); }

  // The patch at a position of a surface; null on the back of a one-sided surface.
  patch_at(s, u, v, front) {
    const [n, m] = this.grid(s), end = front || this.two_sided ? this.first_patch(s + 1) : 0;
    for (let cell = this.first_patch(s); cell < end; ++cell) {
      const size = this.cells[3 * cell + 2];
      const x = (u * n - this.cells[3 * cell]) / size, y = (v * m - this.cells[3 * cell + 1]) / size;
      if (x >= 0 && y >= 0 && (this.triangles[s] ? x + y : Math.max(x, y)) <= 1 + 1e-9)
        return cell + (front ? 0 : this.cell_count);
    }
    return null;
  }

  // True unless other surfaces in the same plane cover the patch of a front, and its back if that can be seen.
  is_seen(patch) {
    return !this.covered.has(patch) || (this.two_sided && !this.covered.has(patch + this.cell_count));
  }

  is_back(patch) { return patch >= this.cell_count; }

  normal(s) { return normalized(cross(this.edge_u(s), this.edge_v(s))); } // of the front
  faces(patch, point) { return dot(this.normal(this.surface_of(patch)), minus(point, this.patch_outline(patch)[0])) > 0 !== this.is_back(patch); }

  surface_of(patch) { return this.surface[patch % this.cell_count]; }
  material_of(patch) { return this.materials[this.material[this.surface_of(patch)]]; }
  reflectance(patch) { return this.reflectances ? three_at(this.reflectances, patch) : this.material_of(patch).reflectance; }
  emittance(patch) { return this.is_back(patch) ? [0, 0, 0] : this.material_of(patch).emittance; }

  // The corner and the size of a patch as shares of the edges of its surface: { u, v, along_u, along_v }.
  cell_of(patch) {
    const k = 3 * (patch % this.cell_count), [n, m] = this.grid(this.surface_of(patch)), [i, j, size] = this.cells.subarray(k, k + 3);
    return { u: i / n, v: j / m, along_u: size / n, along_v: size / m };
  }

  // Of all patches: area [m^2], power of the lamps, mean reflectance [1].
  totals() {
    const sum = value => this.areas.reduce((all, area, patch) => all + area * value(patch), 0), area = sum(() => 1);
    return { area, power: sum(patch => mean(this.emittance(patch))), reflectance: sum(patch => mean(this.reflectance(patch))) / area };
  }

  area(patch) {
    const s = this.surface_of(patch), { along_u, along_v } = this.cell_of(patch);
    return length(cross(this.edge_u(s), this.edge_v(s))) * (this.triangles[s] ? 0.5 : 1) * along_u * along_v;
  }

  // The corners of a patch in space.
  patch_outline(patch) {
    const s = this.surface_of(patch), { u, v, along_u, along_v } = this.cell_of(patch);
    return this.corners(s).map(([x, y]) => this.point(s, u + x * along_u, v + y * along_v));
  }

  // The surface, and its line in the file: "table_top, room.obj:12".
  surface_name(s) {
    return `${this.groups[this.group[s]] || this.materials[this.material[s]].name}, ${this.file}:${this.line[s]}`;
  }

  // The first hit of a ray; null if there is none. Without `backs` rays pass through them, as in the program's pictures of
  // one-sided surfaces.
  nearest_hit(origin, direction, backs = this.two_sided) {
    const g = this.geometry;
    let nearest = null;
    for (let s = 0, k = 0; s < this.surface_count; ++s, k += 9) {
      const a = [g[k + 3], g[k + 4], g[k + 5]], b = [g[k + 6], g[k + 7], g[k + 8]];
      const across = cross(direction, b);
      const determinant = dot(a, across); // = -direction . (a x b): above zero where the ray meets the front
      if (determinant === 0 || (determinant < 0 && !backs))
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
