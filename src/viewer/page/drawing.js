'use strict';
// Draws the room, patches whose pixels look up their values in textures, and marks on top of it.

// The shaders (GLSL ES 3.00).

// Where texel n of a texture with rows of 2048 texels is. Without divisions, which take a fourth of the time in software
// renderers.
const texel_of = `
ivec2 place_of(int n) { return ivec2(n & 2047, n >> 11); }
vec3 texel(sampler2D values, int n) { return texelFetch(values, place_of(n), 0).rgb; }`;

// A patch is two triangles, which the shader places from its cell on the grid of its surface.
const room_vertex_shader = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp isampler2D;
uniform mat4 to_clip;
uniform isampler2D cells;     // of each patch of the fronts: the corner at its origin, its size, its surface
uniform sampler2D surfaces;   // six texels each: origin and the two edges; then the texture coordinates of these and, in
                              // blue, the steps of the grid along the edges, and 1 for a triangle
out vec2 place;               // on the patch, from 0 to 1 along its edges
out vec2 texture_place;
flat out ivec2 surface;       // patch, 1 in a triangle
${texel_of}
void main() {
  int patch_number = gl_VertexID / 6, k = gl_VertexID - 6 * patch_number;
  ivec4 cell = texelFetch(cells, place_of(patch_number), 0);
  int first = 6 * cell.w;
  vec3 across = texel(surfaces, first + 3), along = texel(surfaces, first + 4), last = texel(surfaces, first + 5);
  bool triangle = last.z > 0.0;
  k = k < 3 ? k : triangle ? 0 : k == 3 ? 2 : k == 4 ? 1 : 3; // the second triangle of a triangle is empty
  vec2 corner = vec2(k & 1, k >> 1);
  const float overlap = 1e-3;   // of patches, so that no gaps are seen beside smaller ones
  place = corner * (1.0 + (triangle ? 3.0 : 2.0) * overlap) - overlap;
  vec2 p = (vec2(cell.xy) + float(cell.z) * place) / vec2(across.z, along.z);
  texture_place = across.xy + p.x * along.xy + p.y * last.xy;
  surface = ivec2(patch_number, triangle);
  vec3 position = texel(surfaces, first) + p.x * texel(surfaces, first + 1) + p.y * texel(surfaces, first + 2);
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
uniform int backs_patch;          // the first patch of the backs
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
flat in ivec2 surface;
out vec4 colour;
${texel_of}

// Interpolates the values at the corners of a patch: bilinear, or barycentric on a triangle. The four texels of a patch
// hold its corners counter-clockwise.
vec3 between_corners(int number, vec2 f, bool triangle) {
  vec3 first = texel(corner_values, 4 * number), second = texel(corner_values, 4 * number + 1);
  vec3 third = texel(corner_values, 4 * number + 2);
  if (triangle)
    return (1.0 - f.x - f.y) * first + f.x * second + f.y * third;
  return mix(mix(first, second, f.x), mix(texel(corner_values, 4 * number + 3), third, f.x), f.y);
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
  bool triangle = surface.y == 1;
  int number = surface.x + (gl_FrontFacing ? 0 : backs_patch);

  vec3 shown;
  if (false_colours) {
    float value = texel(patch_values, number).r;
    shown = value < 0.0 ? nothing : texture(colour_map, vec2(clamp(value * patch_scale, 0.0, 1.0), 0.5)).rgb;
  } else {
    vec3 light = smooth_shading ? corner_scale * between_corners(number, clamp(place, 0.0, 1.0), triangle)
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
    shown = mix(shown, ink, 0.4 * border(place, triangle));
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
    this.textures = new Map(); // by their lists of numbers
    this.images = []; // decoded textures of the room, by their index
    this.arrived = this.texture('colours', new Float32Array(3));
    this.blank = this.texture('colours', new Float32Array(3));
  }

  // Draws this room from now on.
  set_room(room) {
    const gl = this.gl;
    gl.deleteTexture(this.cells || null);
    gl.deleteTexture(this.surfaces || null);
    this.images.forEach(texture => gl.deleteTexture(texture));
    this.images = [];
    this.forget([]);
    this.room = room;
    this.cells = this.texture('cells', this.cell_numbers());
    this.surfaces = this.texture('colours', this.surface_numbers());
    this.make_groups();
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
    return { program, uniforms };
  }

  // Decodes the textures of the room. The colours of the files are sRGB; the graphics processor converts them to linear
  // light.
  async load_images(list) {
    const gl = this.gl, most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
    const sharp = gl.getExtension('EXT_texture_filter_anisotropic');
    const options = { premultiplyAlpha: 'none', colorSpaceConversion: 'none' };
    for (const [number, { type, data, repeats }] of list.entries()) {
      const bitmap = await createImageBitmap(new Blob([bytes_of(data)], { type }), options).catch(() => null);
      if (!bitmap || Math.max(bitmap.width, bitmap.height) > most)
        continue; // its surfaces show their mean colour
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

  // The numbers of all surfaces for the shader. Texture coordinates are counted from the top row, as images are stored.
  surface_numbers() {
    const room = this.room, numbers = new Float32Array(18 * room.surface_count);
    for (let s = 0; s < room.surface_count; ++s) {
      const [a, b, c, d, e, f] = room.shows_texture(s) ? room.frames.subarray(6 * s, 6 * s + 6) : [0, 0, 0, 0, 0, 0], [n, m] = room.grid(s);
      numbers.set([...room.origin(s), ...room.edge_u(s), ...room.edge_v(s), a, 1 - b, n, c, -d, m, e, -f, room.triangles[s]], 18 * s);
    }
    return numbers;
  }

  // The numbers of all patches for the shader. A size of 0 hides a patch.
  cell_numbers() {
    const room = this.room, numbers = new Int32Array(4 * room.cell_count);
    for (let k = 0; k < room.cell_count; ++k) {
      numbers[4 * k] = room.cells[3 * k];
      numbers[4 * k + 1] = room.cells[3 * k + 1];
      numbers[4 * k + 2] = room.is_seen(k) ? room.cells[3 * k + 2] : 0;
      numbers[4 * k + 3] = room.surface[k];
    }
    return numbers;
  }

  // Makes the groups of successive patches that are drawn together: { material, first, end }, with the textured material
  // that they show, or -1.
  make_groups() {
    const { room } = this;
    this.groups = [];
    for (let s = 0; s < room.surface_count; ++s) {
      const material = room.shows_texture(s) ? room.material[s] : -1, last = this.groups[this.groups.length - 1];
      if (!last || last.material !== material)
        this.groups.push({ material, first: room.first_patch(s), end: room.first_patch(s + 1) });
      else
        last.end = room.first_patch(s + 1);
    }
  }

  // A texture of values in rows; the last row is padded.
  texture(kind, list) {
    const gl = this.gl, result = gl.createTexture();
    const [channels, internal, format, type] = {
      colours: [3, gl.RGB32F, gl.RGB, gl.FLOAT],
      cells: [4, gl.RGBA32I, gl.RGBA_INTEGER, gl.INT],
      corners: [3, gl.RGB16F, gl.RGB, gl.HALF_FLOAT],
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

  texture_of(kind, list) {
    if (!this.textures.has(list))
      this.textures.set(list, this.texture(kind, list));
    return this.textures.get(list);
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
      const attribute = gl.getAttribLocation(this.mark_program.program, name);
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

  // look: { values, scale, tone, smooth, borders, backs, arrived_scale, background }, and for a comparison `other`, values
  // to be shown on the left of the share `wipe` of the picture's width.
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
    if (look.backs) gl.disable(gl.CULL_FACE); else gl.enable(gl.CULL_FACE);
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
    const gl = this.gl, { program, uniforms } = this.room_program, { values } = look, smooth = look.smooth && values.light;
    gl.useProgram(program);
    const textures = {
      patch_values: this.texture_of(values.light ? 'colours' : 'means', values.values),
      corner_values: smooth ? this.texture_of('corners', values.corners) : this.blank,
      arrived: this.arrived, colour_map: this.colour_map, cells: this.cells, surfaces: this.surfaces };
    Object.entries(textures).forEach(([name, texture], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(uniforms[name], unit);
    });
    gl.uniform1i(uniforms.image, 6);
    gl.uniformMatrix4fv(uniforms.to_clip, false, to_clip);
    gl.uniform1i(uniforms.backs_patch, this.room.cell_count);
    gl.uniform1f(uniforms.patch_scale, look.scale);
    gl.uniform1f(uniforms.corner_scale, look.scale * (values.corners_unit || 1));
    gl.uniform1f(uniforms.arrived_scale, look.arrived_scale);
    gl.uniform1i(uniforms.tone, look.tone);
    gl.uniform1i(uniforms.smooth_shading, smooth ? 1 : 0);
    gl.uniform1i(uniforms.false_colours, values.light ? 0 : 1);
    gl.uniform1i(uniforms.borders, look.borders ? 1 : 0);
    gl.uniform3f(uniforms.nothing, 0.13, 0.13, 0.14);
    for (const group of this.groups)
      this.draw_group(group, look);
    gl.activeTexture(gl.TEXTURE0 + 7); // new textures are filled in a unit that is not drawn from
  }

  // Draws the patches of one textured material, or all that show no texture.
  draw_group({ material, first, end }, look) {
    const gl = this.gl, { uniforms } = this.room_program;
    const { texture, white, reflectance, emittance } = material < 0 ? {} : this.room.materials[material];
    const image = this.images[texture];
    gl.activeTexture(gl.TEXTURE0 + 6);
    gl.bindTexture(gl.TEXTURE_2D, image || this.blank);
    gl.uniform1i(uniforms.textured, image ? 1 : 0);
    gl.uniform3fv(uniforms.emitted, image ? times(look.scale, emittance) : [0, 0, 0]);
    gl.uniform3fv(uniforms.contrast, image ? white.map((w, k) => reflectance[k] > 0 ? w / reflectance[k] : 0) : [1, 1, 1]);
    gl.drawArrays(gl.TRIANGLES, 6 * first, 6 * (end - first));
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

  // Reads back the picture that was just drawn: bytes of red, green, blue and opacity, from the bottom row up.
  pixels() {
    const { width, height } = this.canvas, bytes = new Uint8Array(4 * width * height);
    this.gl.readPixels(0, 0, width, height, this.gl.RGBA, this.gl.UNSIGNED_BYTE, bytes);
    return { width, height, bytes };
  }
}
