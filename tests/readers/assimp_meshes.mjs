// What assimp reads in the meshes of one solution, as it exports it: areas, names and colours.
// usage: node assimp_meshes.mjs       in a folder with flat.csv, flat.glb and {ply,glb,obj}.json by `assimp export -fassjson`
import { readFileSync } from 'node:fs';
import assert from 'node:assert/strict';
import { area, integral, materials, near } from './patch_sums.mjs';

// Over all triangles of a scene: area, and the integral of the colour.
function integrals(scene) {
  const result = { area: 0, sums: [0, 0, 0] };
  for (const { vertices, colors, faces } of scene.meshes)
    for (const [a, b, c] of faces.flatMap(face => face.slice(2).map((last, n) => [face[0], face[n + 1], last]))) {
      const edge = n => [0, 1, 2].map(k => vertices[3 * n + k] - vertices[3 * a + k]);
      const [u, v] = [edge(b), edge(c)];
      const piece = Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
      const components = colors[0].length / (vertices.length / 3);
      result.area += piece;
      for (let k = 0; k < 3; ++k)
        result.sums[k] += piece * [a, b, c].reduce((sum, n) => sum + colors[0][components * n + k], 0) / 3;
    }
  return result;
}

const read = kind => integrals(JSON.parse(readFileSync(kind + '.json', 'utf8')));
const [ply, glb, obj] = ['ply', 'glb', 'obj'].map(read);
near(ply.area, area, 1e-5, 'PLY area'); // six digits in assimp's JSON
near(glb.area, area, 1e-5, 'GLB area');
near(obj.area, area, 1e-5, 'OBJ area');

const file = readFileSync('flat.glb');
const { asset } = JSON.parse(file.subarray(20, 20 + file.readUInt32LE(12)).toString('utf8'));
const linear = integral(radiosity => Math.min(1, asset.extras.color_scale * radiosity));
linear.forEach((x, k) => near(glb.sums[k], x, 1e-4, 'GLB colours'));
ply.sums.forEach((x, k) => near(obj.sums[k], x, 2e-3, 'OBJ colours')); // those of PLY are bytes

const glb_scene = JSON.parse(readFileSync('glb.json', 'utf8'));
const names = new Set(glb_scene.meshes.map(mesh => mesh.name)); // there is one per material
assert.deepEqual([...names].sort(), materials);
console.log('assimp reads the same');
