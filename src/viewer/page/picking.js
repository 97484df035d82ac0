'use strict';
// What a ray meets first. Backs of one-sided surfaces are looked through, as in the program's pictures.

function nearest_hit(room, origin, direction) {
  const g = room.geometry;
  let nearest = null;
  for (let s = 0, k = 0; s < room.surface_count; ++s, k += 9) {
    const a = [g[k + 3], g[k + 4], g[k + 5]], b = [g[k + 6], g[k + 7], g[k + 8]];
    const across = cross(direction, b);
    const determinant = dot(a, across); // = -direction . (a x b): above zero where the ray meets the front
    if (determinant === 0 || (determinant < 0 && !room.two_sided))
      continue;
    const from = [origin[0] - g[k], origin[1] - g[k + 1], origin[2] - g[k + 2]];
    const u = dot(from, across) / determinant;
    if (!(u >= 0 && u <= 1))
      continue;
    const upright = cross(from, a);
    const v = dot(direction, upright) / determinant;
    if (!(v >= 0 && (room.triangles[s] ? u + v : v) <= 1))
      continue;
    const t = dot(b, upright) / determinant;
    if (!(t > 0 && (nearest === null || t < nearest.t)))
      continue;
    const patch = room.patch_at(s, u, v, determinant > 0);
    if (!room.covered.has(patch))
      nearest = { t, surface: s, u, v, front: determinant > 0, patch };
  }
  return nearest;
}
