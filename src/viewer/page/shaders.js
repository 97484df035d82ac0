'use strict';
// The programs of the graphics processor (GLSL ES 3.00).

// Surfaces are drawn whole; every pixel looks up its patch, or the corners around it, by its place (u, v), as the
// program itself does. So patches cost no geometry, and there are no seams between them.
const room_vertex_shader = `#version 300 es
precision highp float;
uniform mat4 to_clip;
in vec3 position;
in vec2 corner;
in uvec4 numbers;   // cells along u and v (0: a triangle), the first patch, 1 for sources, which are never smooth
out vec2 place;
flat out uvec4 surface;
void main() {
  place = corner;
  surface = numbers;
  gl_Position = to_clip * vec4(position, 1.0);
}`;

const room_fragment_shader = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D patch_values;   // one texel per patch, row by row
uniform sampler2D corner_values;  // four per patch
uniform sampler2D arrived;        // of the story
uniform sampler2D colour_map;
uniform uint backs_patch;         // by how much numbers of backs are higher
uniform float patch_scale;        // from texels to the tone curve, or to the colour map
uniform float corner_scale;
uniform float arrived_scale;      // 0: no story
uniform int tone;                 // 0 reinhard, 1 film curve, 2 linear
uniform bool smooth_shading;
uniform bool false_colours;
uniform bool borders;
uniform vec3 nothing;             // colour of patches without a value
in vec2 place;
flat in uvec4 surface;
out vec4 colour;

// Of rows of 2048 texels; without divisions, which take a fourth of the time where no graphics processor draws.
vec3 texel(sampler2D values, uint n) { return texelFetch(values, ivec2(int(n & 2047u), int(n >> 11)), 0).rgb; }

uint index_of(float x, uint cells) { return uint(clamp(floor(x), 0.0, float(cells - 1u))); }

// Bilinear, or barycentric on a triangle; the four places of a patch hold its corners counter-clockwise.
vec3 between_corners(uint number, vec2 f, bool triangle, bool upper) {
  vec3 first = texel(corner_values, 4u * number), second = texel(corner_values, 4u * number + 1u);
  vec3 third = texel(corner_values, 4u * number + 2u);
  if (triangle && upper)
    return (f.x + f.y - 1.0) * first + (1.0 - f.x) * second + (1.0 - f.y) * third;
  if (triangle)
    return (1.0 - f.x - f.y) * first + f.x * second + f.y * third;
  return mix(mix(first, second, f.x), mix(texel(corner_values, 4u * number + 3u), third, f.x), f.y);
}

vec3 curve(vec3 x) {
  if (tone == 0)
    return x * (1.0 + x / 4.0) / (1.0 + x);
  if (tone == 1)
    return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
  return x;
}

vec3 encoded(vec3 linear) {
  vec3 x = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, vec3(lessThanEqual(x, vec3(0.0031308))));
}

// Less than a step of the screen, so that smooth walls show no bands.
float noise() { return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5; }

// 1 on the border of a patch; nothing where patches are smaller than some pixels.
float border(vec2 p, bool triangle) {
  vec3 x = vec3(p, triangle ? p.x + p.y : 0.5);
  vec3 pixel = max(fwidth(x), 1e-6);
  vec3 away = abs(fract(x - 0.5) - 0.5) / pixel;
  float nearest = triangle ? min(min(away.x, away.y), away.z) : min(away.x, away.y);
  return (1.0 - smoothstep(0.4, 1.2, nearest)) * (1.0 - smoothstep(0.12, 0.35, max(pixel.x, pixel.y)));
}

void main() {
  bool triangle = surface.y == 0u;
  uint rows = triangle ? surface.x : surface.y;
  vec2 p = place * vec2(float(surface.x), float(rows));
  uint i = index_of(p.x, surface.x);
  uint j = min(index_of(p.y, rows), triangle ? surface.x - 1u - i : rows);
  bool upper = triangle && i + j + 1u < surface.x && p.x - float(i) + p.y - float(j) > 1.0;
  uint cell = triangle ? i * (2u * surface.x - i) + 2u * j + (upper ? 1u : 0u) : i * rows + j;
  uint number = surface.z + cell + (gl_FrontFacing ? 0u : backs_patch);

  vec3 shown;
  if (false_colours) {
    float value = texel(patch_values, number).r;
    shown = value < 0.0 ? nothing : texture(colour_map, vec2(clamp(value * patch_scale, 0.0, 1.0), 0.5)).rgb;
  } else {
    vec2 within = clamp(p - vec2(float(i), float(j)), 0.0, 1.0);
    vec3 light = smooth_shading && surface.w == 0u ? corner_scale * between_corners(number, within, triangle, upper)
                                                   : patch_scale * texel(patch_values, number);
    if (arrived_scale > 0.0)
      light = 0.1 * light + arrived_scale * texel(arrived, number);
    shown = encoded(curve(min(light, vec3(1e4)))) + noise() / 255.0;
  }
  if (borders) {
    vec3 ink = vec3(dot(shown, vec3(0.299, 0.587, 0.114)) > 0.15 ? 0.0 : 1.0);
    shown = mix(shown, ink, 0.4 * border(p, triangle));
  }
  colour = vec4(shown, 1.0);
}`;

// Marks: straight pieces of lines with round ends, as wide on the screen wherever they are. A point has no length.
const mark_vertex_shader = `#version 300 es
precision highp float;
uniform mat4 to_clip;
uniform vec2 pixels;     // size of the picture
uniform float density;   // pixels of the screen per pixel of the page
in vec3 from;
in vec3 to;
in vec4 ink;
in float width;
flat out vec4 colour;
flat out vec3 middle_line;   // begin in x, y; half the width
flat out vec2 end;
void main() {
  vec4 a = to_clip * vec4(from, 1.0), b = to_clip * vec4(to, 1.0);
  float near = 1e-4 * max(abs(a.w), abs(b.w)) + 1e-9;
  if (a.w < near && b.w < near) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  // What is behind the eye has no place on the screen.
  if (a.w < near) a = mix(b, a, (b.w - near) / (b.w - a.w));
  if (b.w < near) b = mix(a, b, (a.w - near) / (a.w - b.w));
  vec2 begin_pixel = (0.5 + 0.5 * a.xy / a.w) * pixels, end_pixel = (0.5 + 0.5 * b.xy / b.w) * pixels;
  vec2 along = end_pixel - begin_pixel;
  along = length(along) > 1e-3 ? normalize(along) : vec2(1.0, 0.0);
  float half_width = 0.5 * width * density + 1.0;
  bool at_end = (gl_VertexID & 1) == 1;
  vec4 place = at_end ? b : a;
  vec2 aside = vec2(-along.y, along.x) * (gl_VertexID < 2 ? 1.0 : -1.0);
  vec2 offset = half_width * (along * (at_end ? 1.0 : -1.0) + aside);
  colour = ink;
  middle_line = vec3(begin_pixel, half_width);
  end = end_pixel;
  // A little nearer than the surface on which a mark may lie.
  gl_Position = vec4(place.xy + 2.0 * offset / pixels * place.w, place.z - 2e-5 * place.w, place.w);
}`;

const mark_fragment_shader = `#version 300 es
precision highp float;
uniform float opacity;
flat in vec4 colour;
flat in vec3 middle_line;
flat in vec2 end;
out vec4 result;
void main() {
  vec2 along = end - middle_line.xy, from = gl_FragCoord.xy - middle_line.xy;
  float share = clamp(dot(from, along) / max(dot(along, along), 1e-6), 0.0, 1.0);
  float inside = middle_line.z - 0.5 - length(from - share * along);
  result = vec4(colour.rgb, colour.a * opacity * clamp(inside, 0.0, 1.0));
}`;
