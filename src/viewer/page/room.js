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

// The room: its surfaces, and their subdivision into patches. The page holds surfaces only. The patch at a position
// (u, v) on a surface is computed by the same rule as in the program (src/scene/tessellation.h), so it has the same
// number.

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
    this.zero = data.surfaces.origin; // the point of the scene that all positions are relative to
    this.cells = counts_of(data.surfaces.cells);
    this.material = counts_of(data.surfaces.materials);
    this.group = counts_of(data.surfaces.groups);
    this.line = counts_of(data.surfaces.lines);
    this.power_unit = data.power_unit;
    this.frames = numbers_of(data.surfaces.texture_frames);
    this.reflectances = data.reflectances.light ? light_values(data.reflectances) : null;
    this.covered = new Set(counts_of(data.surfaces.covered));
    this.surface_count = this.triangles.length;
    this.trees = this.trees_of(bytes_of(data.surfaces.levels));
    this.number_patches();
    this.find_size();
  }

  // The quadtrees of surfaces whose cells are cut further; null for other surfaces. A tree has its leaves, { i, j,
  // upper, level } on a grid 2^level times as fine as that of the cells, and a node for every cell: the index of a
  // leaf, or the list of the nodes of its four parts.
  trees_of(levels) {
    const trees = new Array(this.surface_count).fill(null);
    let used = 0;
    for (let s = 0; levels.length && s < this.surface_count; ++s) {
      const [n, m] = this.cells_of(s), leaves = [], nodes = [], triangle = this.triangles[s];
      const add = (i, j, upper, level) => {
        if (levels[used] === level) {
          ++used;
          return leaves.push({ i, j, upper, level }) - 1;
        }
        const a = 2 * i, b = 2 * j, parts = !triangle ? [[a, b], [a, b + 1], [a + 1, b], [a + 1, b + 1]]
          : upper ? [[a + 1, b + 1, true], [a + 1, b + 1], [a + 1, b, true], [a, b + 1, true]]
            : [[a, b], [a, b, true], [a, b + 1], [a + 1, b]];
        return parts.map(([c, d, turned]) => add(c, d, Boolean(turned), level + 1));
      };
      for (let cell = 0; cell < n * m; ++cell) {
        const [[i, j], [next]] = this.grid_corners(s, cell), upper = next < i;
        nodes.push(upper ? add(i - 1, j - 1, true, 0) : add(i, j, false, 0));
      }
      if (leaves.length > n * m)
        trees[s] = { leaves, nodes, depth: Math.max(...nodes.map(node => this.depth_of(node))) };
    }
    return trees;
  }
  depth_of(node) { return Array.isArray(node) ? 1 + Math.max(...node.map(part => this.depth_of(part))) : 0; }

  // Number of patches on a side of a surface, and number of values at their corners.
  patches_on(s) {
    const [n, m] = this.cells_of(s);
    return this.trees[s] ? this.trees[s].leaves.length : n * m;
  }
  points_on(s) {
    const [n, m] = this.cells_of(s);
    return this.trees[s] ? 4 * this.trees[s].leaves.length : this.triangles[s] ? (n + 1) * (n + 2) / 2 : (n + 1) * (m + 1);
  }

  // Patches are numbered surface by surface, like the points of their grids; backs come after all fronts.
  number_patches() {
    this.first_patch = new Uint32Array(this.surface_count + 1);
    this.first_point = new Uint32Array(this.surface_count + 1);
    for (let s = 0; s < this.surface_count; ++s) {
      this.first_patch[s + 1] = this.first_patch[s] + this.patches_on(s);
      this.first_point[s + 1] = this.first_point[s] + this.points_on(s);
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

  // True if the surface shows a texture; and the texture coordinates of a point, counted from the top row, as images
  // are stored.
  shows_texture(s) { return this.frames.length > 0 && Number.isFinite(this.frames[6 * s]); }
  texture_place(s, u, v) {
    const [a, b, c, d, e, f] = this.frames.subarray(6 * s, 6 * s + 6);
    return [a + u * c + v * e, 1 - (b + u * d + v * f)];
  }

  // The corners (u, v) of a surface, counter-clockwise.
  corners(s) { return this.triangles[s] ? [[0, 0], [1, 0], [0, 1]] : [[0, 0], [1, 0], [1, 1], [0, 1]]; }
  outline(s) { return this.corners(s).map(([u, v]) => this.point(s, u, v)); }

  // The patch at a position of a surface; null on the back of a one-sided surface.
  patch_at(s, u, v, front) {
    if (!front && !this.two_sided)
      return null;
    const [n, m] = this.cells_of(s);
    const index = (x, cells) => clamped(Math.floor(x * cells), 0, cells - 1);
    const i = index(u, n);
    let cell, x, y;
    if (this.triangles[s]) {
      // Column i holds 2 (n - i) - 1 triangles: upright and upside-down ones in turn.
      const last = n - 1 - i, j = Math.min(index(v, n), last);
      const upper = j < last && u * n - i + (v * n - j) > 1;
      cell = i * (2 * n - i) + 2 * j + (upper ? 1 : 0);
      [x, y] = upper ? [1 - (u * n - i), 1 - (v * n - j)] : [u * n - i, v * n - j];
    } else {
      const j = index(v, m);
      cell = i * m + j;
      [x, y] = [u * n - i, v * m - j];
    }
    if (this.trees[s])
      cell = this.leaf_at(s, this.trees[s].nodes[cell], x, y);
    return (front ? 0 : this.cell_count) + this.first_patch[s] + cell;
  }

  // The leaf at the coordinates (x, y) of a cell, each from 0 to 1.
  leaf_at(s, node, x, y) {
    while (Array.isArray(node)) {
      x *= 2;
      y *= 2;
      const right = x >= 1, up = y >= 1;
      if (this.triangles[s] && !right && !up && x + y > 1) {
        node = node[1]; // the middle, upside down
        [x, y] = [1 - x, 1 - y];
        continue;
      }
      node = node[this.triangles[s] ? (right ? 3 : up ? 2 : 0) : (right ? 2 : 0) + (up ? 1 : 0)];
      x -= right ? 1 : 0;
      y -= up ? 1 : 0;
    }
    return node;
  }

  // The polygons to draw for a surface, each { corners, places, cells, patch }. The corners are (u, v) on the surface;
  // the places are the same points as (u, v) on a grid of cells, whose first cell is the patch. A polygon with more
  // than four corners is a fan around its first one. There is one polygon for the whole surface, or, if it is cut by
  // quadtrees or partly covered by others in the same plane, one for each visible patch.
  pieces(s) {
    const [n, m] = this.cells_of(s), first = this.first_patch[s], count = this.patches_on(s), seen = [];
    const covered = patch => this.covered.has(patch) && (!this.two_sided || this.covered.has(patch + this.cell_count));
    for (let cell = 0; (this.covered.size || this.trees[s]) && cell < count; ++cell)
      if (!covered(first + cell))
        seen.push(cell);
    if (!this.trees[s]) {
      const whole = !this.covered.size || seen.length === count;
      const outlines = whole ? [this.corners(s)] : seen.map(cell => this.cell_corners(s, cell));
      return outlines.map(corners => ({ corners, places: corners, cells: [n, m], patch: first }));
    }
    const points = this.points_of_tree(s);
    return seen.map(cell => {
      const corners = this.outline_with(s, cell, points);
      const [origin, next, last] = (c => [c[0], c[1], c[c.length - 1]])(this.cell_corners(s, cell));
      const size_u = next[0] - origin[0], size_v = last[1] - origin[1];
      const places = corners.map(([u, v]) => [(u - origin[0]) / size_u, (v - origin[1]) / size_v]);
      return { corners, places, cells: [1, 1], patch: first + cell };
    });
  }

  // The corners of all leaves, as i + j * 2^26 on the grid of the smallest leaves.
  points_of_tree(s) {
    const points = new Set();
    this.trees[s].leaves.forEach((leaf, cell) =>
      this.tree_corners(s, cell).forEach(([i, j]) => points.add(i + j * 2 ** 26)));
    return points;
  }

  // The corners of a leaf on the grid of the smallest leaves of its surface.
  tree_corners(s, cell) {
    const { leaves, depth } = this.trees[s], { i, j, upper, level } = leaves[cell], size = 2 ** (depth - level);
    const corners = !this.triangles[s] ? [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]]
      : upper ? [[i + 1, j + 1], [i, j + 1], [i + 1, j]] : [[i, j], [i + 1, j], [i, j + 1]];
    return corners.map(([a, b]) => [a * size, b * size]);
  }

  // The outline of a leaf. If corners of smaller leaves lie on its edges (T-junctions), they are included, so that no
  // gaps are seen there: a fan of the middle, then the corners all around, with the first one repeated at the end.
  // Otherwise its own corners.
  outline_with(s, cell, points) {
    const [n, m] = this.cells_of(s), { depth, leaves } = this.trees[s], corners = this.tree_corners(s, cell), rim = [];
    const place = ([i, j]) => [i / (n * 2 ** depth), j / (m * 2 ** depth)];
    const steps = 2 ** (depth - leaves[cell].level);
    corners.forEach((a, k) => {
      const b = corners[(k + 1) % corners.length], along = [(b[0] - a[0]) / steps, (b[1] - a[1]) / steps];
      for (let step = 0; step < steps; ++step) {
        const point = [a[0] + step * along[0], a[1] + step * along[1]];
        if (step === 0 || points.has(point[0] + point[1] * 2 ** 26))
          rim.push(place(point));
      }
    });
    if (rim.length === corners.length)
      return rim;
    const middle = corners.map(place).reduce((sum, [u, v]) => [sum[0] + u / corners.length, sum[1] + v / corners.length], [0, 0]);
    return [middle, ...rim, rim[0]];
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
  reflectance(patch) { return this.reflectances ? this.reflectances.at(patch) : this.material_of(patch).reflectance; }
  emittance(patch) { return this.is_back(patch) ? [0, 0, 0] : this.material_of(patch).emittance; }

  area(patch) {
    const s = this.surface_of(patch), [n, m] = this.cells_of(s), cell = patch % this.cell_count - this.first_patch[s];
    const parts = n * m * 4 ** (this.trees[s] ? this.trees[s].leaves[cell].level : 0);
    return length(cross(this.edge_u(s), this.edge_v(s))) * (this.triangles[s] ? 0.5 : 1) / parts;
  }

  // The corners (u, v) of a cell on its surface, in the order of the program: counter-clockwise.
  cell_corners(s, cell) {
    const [n, m] = this.cells_of(s), size = this.trees[s] ? 2 ** this.trees[s].depth : 1;
    const corners = this.trees[s] ? this.tree_corners(s, cell) : this.grid_corners(s, cell);
    return corners.map(([i, j]) => [i / (n * size), j / (m * size)]);
  }

  // The corners of a whole cell on the grid of its surface.
  grid_corners(s, cell) {
    const [n, m] = this.cells_of(s);
    if (!this.triangles[s]) {
      const i = Math.floor(cell / m), j = cell % m;
      return [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
    }
    let i = Math.max(0, Math.floor(n - Math.sqrt(n * n - cell)) - 1); // the column, or a smaller one by rounding
    while ((i + 1) * (2 * n - i - 1) <= cell)
      ++i;
    const place = cell - i * (2 * n - i), j = place >> 1;
    return place % 2 ? [[i + 1, j + 1], [i, j + 1], [i + 1, j]] : [[i, j], [i + 1, j], [i, j + 1]];
  }

  // The corners of a patch in space.
  patch_outline(patch) {
    const s = this.surface_of(patch);
    const cell = patch % this.cell_count - this.first_patch[s];
    return this.cell_corners(s, cell).map(([u, v]) => this.point(s, u, v));
  }

  // The values at the corners of all patches, four each, copied from the shared values at the points of the grids. A
  // triangle leaves the fourth empty.
  patch_corners(shared) {
    const result = new Uint32Array(4 * this.patch_count);
    for (let back = 0; back < (this.two_sided ? 2 : 1); ++back)
      for (let s = 0; s < this.surface_count; ++s) {
        const first_point = back * this.point_count + this.first_point[s];
        const first_place = 4 * (back * this.cell_count + this.first_patch[s]);
        if (this.trees[s])
          result.set(shared.subarray(first_point, first_point + this.points_on(s)), first_place);
        else if (this.triangles[s])
          this.copy_triangle_corners(s, shared.subarray(first_point), result.subarray(first_place));
        else
          this.copy_grid_corners(s, shared.subarray(first_point), result.subarray(first_place));
      }
    return result;
  }

  // Makes no list for each cell, since there may be many.
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
      this.grid_corners(s, cell).forEach(([i, j], k) => {
        result[4 * cell + k] = shared[j * (n + 1) - j * (j - 1) / 2 + i];
      });
  }

  // The surface as the program names it: "table_top (line 12)".
  surface_name(s) {
    return `${this.groups[this.group[s]] || this.materials[this.material[s]].name} (line ${this.line[s]})`;
  }

  // The first hit of a ray; null if there is none. Rays pass through the backs of one-sided surfaces, as in the
  // program's pictures.
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
