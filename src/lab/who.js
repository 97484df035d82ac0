'use strict';
// Who lights a patch: rays from it into the hemisphere, as the light comes (their density contains the cosine), counted by the
// surface that they meet.

const rays_of_patch = 2000;

// A direction around a unit normal with a density proportional to the cosine.
function cosine_direction(normal) {
  const aside = normalized(cross(normal, Math.abs(normal[0]) > 0.5 ? [0, 1, 0] : [1, 0, 0]));
  const radius = Math.sqrt(Math.random()), angle = 2 * Math.PI * Math.random();
  const flat = plus(times(radius * Math.cos(angle), aside), times(radius * Math.sin(angle), cross(normal, aside)));
  return plus(flat, times(Math.sqrt(1 - radius * radius), normal));
}

// The surfaces that light a patch, the brightest first, { surface, share } of its irradiance, and the first rays,
// { from, to, light }.
function lights_of(patch, room, radiosity) {
  const s = room.surface_of(patch), outline = room.patch_outline(patch), back = room.is_back(patch);
  const normal = times(back ? -1 : 1, room.normal(s));
  const light = new Map(), rays = [];
  let all = 0;
  for (let ray = 0; ray < rays_of_patch; ++ray) {
    const [a, b] = [outline[0], outline[outline.length - 1]], [u, v] = [Math.random(), Math.random()];
    const along = minus(outline[1], a), up = minus(b, a), turn = outline.length === 3 && u + v > 1;
    const start = plus(a, plus(times(turn ? 1 - u : u, along), times(turn ? 1 - v : v, up)));
    const hit = room.nearest_hit(plus(start, times(1e-6 * room.size, normal)), cosine_direction(normal));
    if (!hit || hit.patch === null)
      continue;
    const power = mean(three_at(radiosity, hit.patch)), surface = room.surface_of(hit.patch);
    if (rays.length < 100)
      rays.push({ from: start, to: room.point(surface, hit.u, hit.v), light: power });
    light.set(surface, (light.get(surface) || 0) + power);
    all += power;
  }
  const brightest = [...light].sort(([, a], [, b]) => b - a).slice(0, 6);
  return { surfaces: brightest.map(([surface, power]) => ({ surface, share: power / all })), rays };
}
