// Sums over the patches of a table that solve has written, for comparison with sums over the triangles of a mesh.
import { readFileSync } from 'node:fs';
import assert from 'node:assert/strict';

const lines = readFileSync('flat.csv', 'utf8').split('\n').filter(line => line && !line.startsWith('#'));
const columns = lines.shift().split(',');
export const rows = lines.map(line => Object.fromEntries(line.split(',').map((field, n) => [columns[n], field])));

// Over all patches, the area times what `value` makes of each channel's radiosity.
export const integral = value => ['r', 'g', 'b'].map(
  channel => rows.reduce((sum, row) => sum + row.area * value(+row['radiosity_' + channel]), 0));
export const area = rows.reduce((sum, row) => sum + +row.area, 0);
export const materials = [...new Set(rows.map(row => row.material))].sort();

export const near = (a, b, tolerance, what) =>
  assert(Math.abs(a - b) <= tolerance * Math.abs(b), `${what}: ${a} instead of ${b}`);
