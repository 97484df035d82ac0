// What three.js reads in the meshes of one solution, flat and smooth: every number that the table has too must be the same.
// usage: node three_loaders.mjs       in a folder with flat.csv, flat.{ply,glb,obj}, {smooth,map,map_lightmap}.glb and node_modules
import { readFileSync } from 'node:fs';
import assert from 'node:assert/strict';
import * as THREE from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
import { area, integral, materials, near } from './patch_sums.mjs';

globalThis.self = globalThis; // the loaders expect a browser

const bytes = name => { const file = readFileSync(name); return file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength); };
const power = integral(radiosity => radiosity);

// Over all triangles: area, and the integral of an attribute of three channels that is linear on each.
function integrals(geometry, name) {
  const position = geometry.getAttribute('position'), value = geometry.getAttribute(name);
  const corner = n => geometry.index ? geometry.index.getX(n) : n;
  const point = n => new THREE.Vector3().fromBufferAttribute(position, n);
  const result = { area: 0, sums: [0, 0, 0] };
  for (let n = 0; n < (geometry.index || position).count; n += 3) {
    const [a, b, c] = [corner(n), corner(n + 1), corner(n + 2)];
    const piece = new THREE.Triangle(point(a), point(b), point(c)).getArea();
    assert(piece > 0);
    result.area += piece;
    ['getX', 'getY', 'getZ'].forEach((get, k) => result.sums[k] += piece * (value[get](a) + value[get](b) + value[get](c)) / 3);
  }
  return result;
}
const srgb_decoded = x => x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;

function check_ply() {
  const loader = new PLYLoader();
  loader.setCustomPropertyNameMapping({ radiosity: ['radiosity_r', 'radiosity_g', 'radiosity_b'] });
  const geometry = loader.parse(bytes('flat.ply'));
  const { area: total, sums } = integrals(geometry, 'radiosity');
  near(total, area, 1e-6, 'PLY area'); // floats
  power.forEach((p, k) => near(sums[k], p, 1e-6, 'PLY power'));
  assert(geometry.getAttribute('normal') && geometry.getAttribute('color'));
  return geometry.getAttribute('color');
}

async function check_glb(name, tolerance) {
  const gltf = await new GLTFLoader().parseAsync(bytes(name), '');
  const names = new Set(), sums = [0, 0, 0];
  let total = 0;
  gltf.scene.traverse(node => {
    if (!node.isMesh) return;
    assert(node.material.isMeshBasicMaterial && node.material.vertexColors, 'unlit, with colours of vertices');
    assert.equal(node.material.side, THREE.FrontSide);
    names.add(node.material.name);
    const part = integrals(node.geometry, '_radiosity');
    total += part.area;
    part.sums.forEach((x, k) => sums[k] += x);
    const colour = node.geometry.getAttribute('color'), radiosity = node.geometry.getAttribute('_radiosity');
    for (let n = 0; n < colour.count; ++n)
      near(colour.getX(n), Math.min(1, gltf.asset.extras.color_scale * radiosity.getX(n)), 1e-6, 'COLOR_0');
  });
  near(total, area, 1e-6, 'GLB area');
  power.forEach((p, k) => near(sums[k], p, tolerance, 'GLB power'));
  assert.deepEqual([...names].sort(), materials);
  assert(gltf.asset.extras.record.some(fact => fact.startsWith('command: multipath solve ')));
}

function check_obj(ply_colours) {
  const group = new OBJLoader().parse(readFileSync('flat.obj', 'utf8'));
  let total = 0; const colours = [];
  group.traverse(node => {
    if (!node.isMesh) return;
    total += integrals(node.geometry, 'color').area;
    const colour = node.geometry.getAttribute('color');
    for (let n = 0; n < colour.count; ++n) colours.push(colour.getX(n));
  });
  near(total, area, 1e-5, 'OBJ area'); // seven digits
  assert.equal(colours.length % 3, 0);
  // The loaders decode both to linear light: the same colours, from bytes and from four decimals.
  const range = values => [Math.min(...values), Math.max(...values)];
  const from_bytes = Array.from({ length: ply_colours.count }, (_, n) => ply_colours.getX(n));
  range(colours).forEach((x, k) => assert(Math.abs(x - range(from_bytes)[k]) < 0.01, `OBJ colours ${range(colours)}, PLY ${range(from_bytes)}`));
  assert(range(colours)[1] >= srgb_decoded(0.99), 'the lamp is white');
}

// Its z axis, which points upwards, has become y; x and the moves are as in the scene.
async function check_place(name) {
  const box = async file => {
    const { scene, cameras } = await new GLTFLoader().parseAsync(bytes(file), '');
    scene.updateMatrixWorld(true);
    return { ...new THREE.Box3().setFromObject(scene, true), eyes: cameras.map(camera => camera.getWorldPosition(new THREE.Vector3())) };
  };
  const here = await box('flat.glb'), there = await box(name), move = new THREE.Vector3(500000, 120, -4649776);
  for (const end of ['min', 'max'])
    assert(there[end].distanceTo(here[end].clone().add(move)) < 1e-5, `${name}: ${end} at ${there[end].toArray()}`);
  there.eyes.forEach(eye => assert(eye.distanceTo(new THREE.Vector3(1.8, 1.7, 1.3).add(move)) < 1e-5, `${name}: ${eye.toArray()}`));
  assert.equal(there.eyes.length, 2);
}

check_obj(check_ply());
await check_place('map.glb');
await check_place('map_lightmap.glb');
await check_glb('flat.glb', 1e-6);
await check_glb('smooth.glb', 0.01); // smoothing keeps the light of a wall but at its borders
console.log('three.js', THREE.REVISION, 'reads the same');
