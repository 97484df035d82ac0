// A closed room, turned a little, whose walls are cut aslant: their patches do not match those of the floor and ceiling.
// usage: node slanted_room.mjs        writes slanted.obj and slanted.mtl
import { writeFileSync } from 'node:fs';

const vertices = [], faces = [];
const turned = ([x, y, z]) => [x * Math.cos(0.3) - z * Math.sin(0.3), y, x * Math.sin(0.3) + z * Math.cos(0.3)];
const vertex = point => vertices.push(turned(point).join(' '));
const face = (material, ...points) => faces.push(`usemtl ${material}\nf ${points.map(vertex).join(' ')}`);
const between = (a, b, share) => a.map((x, k) => x + share * (b[k] - x));
const raised = ([x, , z]) => [x, 2.8, z];

const corners = [[-2.3, 0, -2.3], [-2.3, 0, 2.3], [2.3, 0, 2.3], [2.3, 0, -2.3]]; // counter-clockwise from above
face('white', ...corners);
face('white', ...corners.map(raised).reverse());
corners.forEach((a, n) => {
  const b = corners[(n + 1) % 4];
  const [low, high] = [between(a, b, 0.37), raised(between(a, b, 0.61))];
  face('white', b, low, high, raised(b));
  face('red', low, a, raised(a), high);
});
face('lamp', ...[[-0.5, 2.7, -0.5], [0.5, 2.7, -0.5], [0.5, 2.7, 0.5], [-0.5, 2.7, 0.5]]);
writeFileSync('slanted.obj', `mtllib slanted.mtl\n${vertices.map(v => `v ${v}\n`).join('')}${faces.join('\n')}\n`);
writeFileSync('slanted.mtl', 'newmtl white\nKd 0.7 0.7 0.7\nnewmtl red\nKd 0.7 0.1 0.1\nnewmtl lamp\nKe 20 20 20\n');
