'use strict';
// Draws the room, one buffer of surfaces whose pixels look up their values in textures, and marks on top of it.

// The shaders (GLSL ES 3.00).

// Surfaces are drawn whole: every pixel looks up its patch, or the values at the corners of the patch, from its
// position (u, v) on the surface, as the program itself does. So patches cost no geometry, and there are no seams
// between them.
const room_vertex_shader = `#version 300 es
precision highp float;
uniform mat4 to_clip;
in vec3 position;
in vec2 corner;
in uvec3 numbers;   // cells along u and v (0: a triangle), the first patch
in vec2 on_texture;
out vec2 place;
out vec2 texture_place;
flat out uvec3 surface;
void main() {
  place = corner;
  surface = numbers;
  texture_place = on_texture;
  gl_Position = to_clip * vec4(position, 1.0);
}`;

const room_fragment_shader = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D patch_values;   // one texel per patch, row by row
uniform sampler2D corner_values;  // four per patch
uniform sampler2D arrived;        // radiosity that the traced lines have brought, one texel per patch
uniform sampler2D colour_map;
uniform uint backs_patch;         // the first patch of the backs
uniform float patch_scale;        // from texels to the tone curve, or to the colour map
uniform float corner_scale;
uniform float arrived_scale;      // 0: no trace is shown
uniform int tone;                 // 0 reinhard, 1 film curve, 2 linear
uniform bool smooth_shading;
uniform bool false_colours;
uniform bool borders;
uniform vec3 nothing;             // colour of patches without a value
uniform sampler2D image;          // texture of the current surfaces, in linear light
uniform bool textured;
uniform vec3 emitted;             // emittance of fronts, scaled for the tone curve
uniform vec3 contrast;            // reflectance where the texture is white over the mean reflectance
in vec2 place;
in vec2 texture_place;
flat in uvec3 surface;
out vec4 colour;

// Texel n of a texture with rows of 2048 texels. Without divisions, which take a fourth of the time in software
// renderers.
vec3 texel(sampler2D values, uint n) { return texelFetch(values, ivec2(int(n & 2047u), int(n >> 11)), 0).rgb; }

uint index_of(float x, uint cells) { return uint(clamp(floor(x), 0.0, float(cells - 1u))); }

// Interpolates the values at the corners of a patch: bilinear, or barycentric on a triangle. The four texels of a patch
// hold its corners counter-clockwise.
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

// Dither of less than one step of the screen, so that smooth walls show no bands.
float noise() { return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5; }

// 1 on the border of a patch; fades to 0 where patches are only a few pixels wide.
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
    vec3 light = smooth_shading ? corner_scale * between_corners(number, within, triangle, upper)
                                                   : patch_scale * texel(patch_values, number);
    vec3 emission = gl_FrontFacing ? emitted : vec3(0.0);
    if (textured && smooth_shading)
      light = emission + contrast * texture(image, texture_place).rgb * max(light - emission, 0.0);
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

// Marks: line segments with round ends and a constant width on the screen. A point is a segment of length 0.
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
  // Cuts off the part behind the eye.
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
  // A little nearer than a surface on which the mark may lie.
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

const texels_per_row = 2048; // every WebGL 2 allows this width; the shader relies on it

class Drawing {
  // Throws an Error with a message for the user if there is no WebGL 2.
  constructor(canvas) {
    this.canvas = canvas;
    this.fit(); // before the context exists: to resize it later is slow
    this.gl = canvas.getContext('webgl2', { antialias: true, alpha: false });
    if (!this.gl)
      throw new Error('This browser cannot draw the room: it has no WebGL 2, or it is switched off.');
    this.room_program = this.program(room_vertex_shader, room_fragment_shader);
    this.mark_program = this.program(mark_vertex_shader, mark_fragment_shader);
    this.mark_array = this.gl.createVertexArray();
    this.mark_buffer = this.gl.createBuffer();
    this.mark_count = 0;
    this.textures = new Map(); // by their Values
    this.images = []; // decoded textures of the room, by their index
    this.arrived = this.texture('colours', new Float32Array(3));
    this.blank = this.texture('colours', new Float32Array(3));
  }

  // Draws this room from now on.
  set_room(room) {
    const gl = this.gl;
    for (const buffer of this.surface_buffers || [])
      gl.deleteBuffer(buffer);
    gl.deleteVertexArray(this.surface_array || null);
    this.images.forEach(texture => gl.deleteTexture(texture));
    this.images = [];
    this.forget([]);
    this.room = room;
    this.make_surfaces();
  }

  // Deletes the textures of all values but these.
  forget(kept) {
    for (const [values, texture] of this.textures)
      if (!kept.includes(values)) {
        this.gl.deleteTexture(texture);
        this.textures.delete(values);
      }
  }

  program(vertex, fragment) {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
      throw new Error('This browser cannot draw the room: ' + gl.getProgramInfoLog(program));
    const uniforms = {};
    for (let k = 0; k < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++k) {
      const { name } = gl.getActiveUniform(program, k);
      uniforms[name] = gl.getUniformLocation(program, name);
    }
    return { program, uniforms, attribute: name => gl.getAttribLocation(program, name) };
  }

  // Decodes the textures of the room. The colours of the files are sRGB; the graphics processor converts them to linear
  // light.
  async load_images(list) {
    const gl = this.gl, most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
    const sharp = gl.getExtension('EXT_texture_filter_anisotropic');
    const options = { premultiplyAlpha: 'none', colorSpaceConversion: 'none' };
    for (const [number, { type, data, repeats }] of list.entries()) {
      let bitmap = await createImageBitmap(new Blob([bytes_of(data)], { type }), options).catch(() => null);
      if (!bitmap)
        continue; // its surfaces show their mean colour
      const shrink = most / Math.max(bitmap.width, bitmap.height);
      if (shrink < 1)
        bitmap = await createImageBitmap(bitmap, { ...options, resizeQuality: 'high',
          resizeWidth: Math.max(1, Math.floor(shrink * bitmap.width)), resizeHeight: Math.max(1, Math.floor(shrink * bitmap.height)) });
      const texture = gl.createTexture(), wrap = repeats ? gl.REPEAT : gl.CLAMP_TO_EDGE;
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
      gl.generateMipmap(gl.TEXTURE_2D);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, wrap);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, wrap);
      if (sharp)
        gl.texParameterf(gl.TEXTURE_2D, sharp.TEXTURE_MAX_ANISOTROPY_EXT, 8);
      this.images[number] = texture;
      bitmap.close();
    }
  }

  // Makes the vertex buffer: the corners of the pieces of all surfaces, sorted by textured material, each with its
  // numbers for the shader.
  make_surfaces() {
    const gl = this.gl, room = this.room, words = 10; // 3 + 2 numbers, 3 counts, 2 numbers
    const pieces = [], kind = s => room.shows_texture(s) ? room.material[s] : -1;
    for (let s = 0; s < room.surface_count; ++s)
      for (const piece of room.pieces(s))
        pieces.push([s, piece]);
    pieces.sort(([a], [b]) => kind(a) - kind(b));
    const corner_count = pieces.reduce((sum, [, { corners }]) => sum + corners.length, 0);
    const numbers = new Float32Array(words * corner_count), counts = new Uint32Array(numbers.buffer);
    const indices = new Uint32Array(3 * (corner_count - 2 * pieces.length));
    let n = 0, used = 0;
    this.groups = []; // ranges of indices with the same material: { material, first, count }
    for (const [s, { corners, places, cells, patch }] of pieces) {
      const first = n;
      corners.forEach(([u, v], k) => {
        numbers.set([...room.point(s, u, v), ...places[k]], words * n);
        counts.set([cells[0], room.triangles[s] ? 0 : cells[1], patch], words * n + 5);
        if (kind(s) >= 0)
          numbers.set(room.texture_place(s, u, v), words * n + 8);
        ++n;
      });
      if (this.groups.length === 0 || this.groups[this.groups.length - 1].material !== kind(s))
        this.groups.push({ material: kind(s), first: used, count: 0 });
      for (let k = 2; k < corners.length; ++k) {
        indices.set([first, first + k - 1, first + k], used);
        used += 3;
      }
      this.groups[this.groups.length - 1].count += 3 * (corners.length - 2);
    }
    this.surface_array = gl.createVertexArray();
    gl.bindVertexArray(this.surface_array);
    this.surface_buffers = [gl.createBuffer(), gl.createBuffer()];
    gl.bindBuffer(gl.ARRAY_BUFFER, this.surface_buffers[0]);
    gl.bufferData(gl.ARRAY_BUFFER, numbers.subarray(0, words * n), gl.STATIC_DRAW);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.surface_buffers[1]);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices.subarray(0, used), gl.STATIC_DRAW);
    const [position, corner, numbers_at, on_texture] =
      ['position', 'corner', 'numbers', 'on_texture'].map(this.room_program.attribute);
    gl.enableVertexAttribArray(position);
    gl.vertexAttribPointer(position, 3, gl.FLOAT, false, 4 * words, 0);
    gl.enableVertexAttribArray(corner);
    gl.vertexAttribPointer(corner, 2, gl.FLOAT, false, 4 * words, 12);
    gl.enableVertexAttribArray(numbers_at);
    gl.vertexAttribIPointer(numbers_at, 3, gl.UNSIGNED_INT, 4 * words, 20);
    gl.enableVertexAttribArray(on_texture);
    gl.vertexAttribPointer(on_texture, 2, gl.FLOAT, false, 4 * words, 32);
    gl.bindVertexArray(null);
  }

  // A texture of values in rows; the last row is padded.
  texture(kind, list) {
    const gl = this.gl, result = gl.createTexture();
    const [channels, internal, format, type] = {
      colours: [3, gl.RGB32F, gl.RGB, gl.FLOAT],
      light: [1, gl.RGB9_E5, gl.RGB, gl.UNSIGNED_INT_5_9_9_9_REV],
      means: [1, gl.R32F, gl.RED, gl.FLOAT],
    }[kind];
    const count = list.length / channels, width = Math.min(texels_per_row, count), height = Math.ceil(count / width);
    const filled = new list.constructor(channels * width * height);
    filled.set(list);
    if (kind === 'means')
      for (let k = 0; k < filled.length; ++k)
        if (!Number.isFinite(filled[k]))
          filled[k] = -1; // means "no value" in the shader
    gl.bindTexture(gl.TEXTURE_2D, result);
    gl.texImage2D(gl.TEXTURE_2D, 0, internal, width, height, 0, format, type, filled);
    this.nearest(gl.NEAREST);
    return result;
  }

  nearest(filter) {
    const gl = this.gl;
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  }

  texture_of(values) {
    if (!this.textures.has(values))
      this.textures.set(values, this.texture(values.kind, values.list));
    return this.textures.get(values);
  }

  set_colour_map(bytes) {
    const gl = this.gl;
    this.colour_map = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.colour_map);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB8, 256, 1, 0, gl.RGB, gl.UNSIGNED_BYTE, bytes);
    this.nearest(gl.LINEAR);
  }

  // Sets the radiosity that the traced lines have brought: three numbers per patch.
  set_arrived(list) {
    this.gl.deleteTexture(this.arrived);
    this.arrived = this.texture('colours', list);
  }

  // Sets the marks, each { from, to, width, colour }.
  set_marks(marks) {
    const gl = this.gl, words = 11;
    const numbers = new Float32Array(words * marks.length);
    marks.forEach((mark, n) => numbers.set([...mark.from, ...mark.to, ...mark.colour, mark.width], words * n));
    this.mark_count = marks.length;
    gl.bindVertexArray(this.mark_array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.mark_buffer);
    gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.DYNAMIC_DRAW);
    let offset = 0;
    for (const [name, size] of [['from', 3], ['to', 3], ['ink', 4], ['width', 1]]) {
      const attribute = this.mark_program.attribute(name);
      gl.enableVertexAttribArray(attribute);
      gl.vertexAttribPointer(attribute, size, gl.FLOAT, false, 4 * words, offset);
      gl.vertexAttribDivisor(attribute, 1);
      offset += 4 * size;
    }
    gl.bindVertexArray(null);
  }

  // Adapts the size of the picture to that of the canvas on the page.
  fit() {
    const density = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(this.canvas.clientWidth * density));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * density));
    if (this.canvas.width !== width || this.canvas.height !== height)
      Object.assign(this.canvas, { width, height });
  }

  // look: { values, scale, tone, smooth, borders, arrived_scale, background }, and for a comparison `other`, values to
  // be shown on the left of the share `wipe` of the picture's width.
  draw(camera, look) {
    const gl = this.gl;
    this.fit();
    const { width, height } = this.canvas;
    const to_clip = camera.matrix(width / height);
    gl.viewport(0, 0, width, height);
    gl.clearColor(...look.background, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LESS);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
    if (this.room.two_sided) gl.disable(gl.CULL_FACE); else gl.enable(gl.CULL_FACE);
    const parts = look.other ? [[look.other, 0, look.wipe], [look.values, look.wipe, 1]] : [[look.values, 0, 1]];
    gl.enable(gl.SCISSOR_TEST);
    for (const [values, from, to] of parts) {
      const left = Math.round(from * width);
      gl.scissor(left, 0, Math.round(to * width) - left, height);
      this.draw_room(to_clip, { ...look, values });
    }
    gl.disable(gl.SCISSOR_TEST);
    if (this.mark_count > 0)
      this.draw_marks(to_clip, width, height);
  }

  draw_room(to_clip, look) {
    const gl = this.gl, { program, uniforms } = this.room_program, { values } = look;
    gl.useProgram(program);
    const textures = {
      patch_values: this.texture_of(values.patches),
      corner_values: look.smooth && values.corners ? this.texture_of(values.corners) : this.texture_of(values.patches),
      arrived: this.arrived, colour_map: this.colour_map };
    Object.entries(textures).forEach(([name, texture], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(uniforms[name], unit);
    });
    gl.uniform1i(uniforms.image, 4);
    gl.uniformMatrix4fv(uniforms.to_clip, false, to_clip);
    gl.uniform1ui(uniforms.backs_patch, this.room.cell_count);
    gl.uniform1f(uniforms.patch_scale, look.scale * values.patches.unit);
    gl.uniform1f(uniforms.corner_scale, look.scale * (values.corners ? values.corners.unit : 1));
    gl.uniform1f(uniforms.arrived_scale, look.arrived_scale);
    gl.uniform1i(uniforms.tone, look.tone);
    gl.uniform1i(uniforms.smooth_shading, look.smooth && values.corners ? 1 : 0);
    gl.uniform1i(uniforms.false_colours, values.light ? 0 : 1);
    gl.uniform1i(uniforms.borders, look.borders ? 1 : 0);
    gl.uniform3f(uniforms.nothing, 0.13, 0.13, 0.14);
    gl.bindVertexArray(this.surface_array);
    for (const group of this.groups)
      this.draw_group(group, look);
    gl.bindVertexArray(null);
    gl.activeTexture(gl.TEXTURE0 + 5); // new textures are filled in a unit that is not drawn from
  }

  // Draws the surfaces of one textured material, or all that show no texture.
  draw_group({ material, first, count }, look) {
    const gl = this.gl, { uniforms } = this.room_program;
    const { texture, white, reflectance, emittance } = material < 0 ? {} : this.room.materials[material];
    const image = this.images[texture];
    gl.activeTexture(gl.TEXTURE0 + 4);
    gl.bindTexture(gl.TEXTURE_2D, image || this.blank);
    gl.uniform1i(uniforms.textured, image ? 1 : 0);
    gl.uniform3fv(uniforms.emitted, image ? times(look.scale, emittance) : [0, 0, 0]);
    gl.uniform3fv(uniforms.contrast, image ? white.map((w, k) => reflectance[k] > 0 ? w / reflectance[k] : 0) : [1, 1, 1]);
    gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 4 * first);
  }

  // Draws the marks; parts hidden by the room are seen faintly through it.
  draw_marks(to_clip, width, height) {
    const gl = this.gl, { program, uniforms } = this.mark_program;
    gl.useProgram(program);
    gl.uniformMatrix4fv(uniforms.to_clip, false, to_clip);
    gl.uniform2f(uniforms.pixels, width, height);
    gl.uniform1f(uniforms.density, window.devicePixelRatio || 1);
    gl.disable(gl.CULL_FACE);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    gl.bindVertexArray(this.mark_array);
    for (const [test, opacity] of [[gl.GREATER, 0.25], [gl.LEQUAL, 1]]) {
      gl.depthFunc(test);
      gl.uniform1f(uniforms.opacity, opacity);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.mark_count);
    }
    gl.bindVertexArray(null);
  }

  // Draws the picture and reads it back: bytes of red, green, blue and opacity, from the bottom row up.
  pixels(camera, look) {
    this.draw(camera, look);
    const { width, height } = this.canvas, bytes = new Uint8Array(4 * width * height);
    this.gl.readPixels(0, 0, width, height, this.gl.RGBA, this.gl.UNSIGNED_BYTE, bytes);
    return { width, height, bytes };
  }
}
