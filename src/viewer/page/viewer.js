'use strict';
// Connects the room, the camera, the drawing and the controls. A page with the data of a room starts at the end of this
// file.

const tone_numbers = { reinhard: 0, aces: 1, linear: 2, percentile: 2 };

class Viewer {
  constructor(canvas) {
    this.canvas = canvas;
    this.drawing = new Drawing(canvas);
    this.state = { quantity: 0, shading: 'smooth', mesh: false, motion: 'orbit', exposure: 0, selected: null };
    this.panel = new Panel(this);
    this.trace_panel = new TracePanel(this);
    this.controls = new Controls(this, canvas, this.trace_panel);
    new ResizeObserver(() => this.request_draw()).observe(canvas);
    window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.request_draw());
  }

  // Shows a room.
  show(data) {
    this.room = new Room(data);
    this.camera = new Camera(data.camera, this.room);
    this.drawing.set_room(this.room);
    Object.assign(this.state, { quantity: data.shown, shading: data.shading, selected: null,
      exposure: clamped(data.tone.exposure, -6, 6) });
    this.show_light(data);
  }

  // Shows other results in the same room, as it is seen now.
  show_light(data) {
    this.drawing.forget((this.other || []).flatMap(({ values, corners }) => [values, corners]));
    this.quantities = data.quantities.map(quantity => quantity_of(quantity, this.room));
    this.colour_map = bytes_of(data.colour_map);
    this.trace = new Trace(data.trace, this.room);
    this.drawing.set_colour_map(this.colour_map);
    this.tone = data.tone;
    this.state.quantity = Math.min(this.state.quantity, this.quantities.length - 1);
    this.panel.show(data);
    this.trace_panel.begin();
    this.show_rays([]);
    this.change({});
  }

  // Decodes the textures while the room is already shown.
  async load_images(list) {
    await this.drawing.load_images(list);
    this.request_draw();
  }

  // Shows these quantities, A, on the left of the share `wipe` of the picture's width; null ends that.
  compare(other, wipe) {
    Object.assign(this, { other, wipe });
    this.panel.show_patch(this.state.selected);
    this.request_draw();
  }

  change(part) {
    const selected = this.state.selected;
    Object.assign(this.state, part);
    this.panel.refresh(this.state);
    if (this.state.selected !== selected) {
      this.show_rays([]);
      element('patch').scrollIntoView({ block: 'nearest' });
    }
    this.request_draw();
  }

  // Changes the view by a function of the camera.
  move(change) {
    this.camera.keep_room(change);
    this.request_draw();
  }

  go_home() {
    this.camera.reset();
    this.request_draw();
  }

  go_outside() {
    this.camera.go_outside(this.canvas.clientWidth / this.canvas.clientHeight);
    this.request_draw();
  }

  view() { return this.camera.view(this.canvas.clientWidth / this.canvas.clientHeight); }

  // The same as options for a command line.
  view_options() {
    const { eye, target, up, fov } = this.view(), usual = up.join() === '0,1,0';
    return `--eye=${eye} --target=${target}${usual ? '' : ` --up=${up}`} --fov=${fov}`;
  }

  // The picture as a URL. It is drawn again, since the canvas keeps a picture only until the next frame.
  png() {
    this.draw();
    return this.canvas.toDataURL('image/png');
  }

  // Requests one drawing before the browser's next frame; repeated requests have no effect.
  request_draw() {
    if (this.requested || !this.room)
      return;
    this.requested = true;
    requestAnimationFrame(() => {
      this.requested = false;
      this.draw();
    });
  }

  draw() {
    this.drawing.set_marks(this.marks());
    this.drawing.draw(this.camera, this.look());
  }

  // In a room of two sides. A trace that is seen from outside shows no backs, which would hide its lines.
  get shows_backs() { return this.room.two_sided && (!this.trace.active || this.camera.within()); }

  // Index of the quantity that is drawn now. A trace is shown in light, with the solved room dimmed.
  get drawn_quantity() { return this.trace.active ? 0 : this.state.quantity; }

  // The current parameters of Drawing.draw().
  look() {
    const { state, trace } = this, values = this.quantities[this.drawn_quantity];
    const background = getComputedStyle(document.documentElement).getPropertyValue('--outside').split(' ').map(Number);
    return {
      values, backs: this.shows_backs, tone: tone_numbers[this.tone.curve], borders: state.mesh, smooth: state.shading === 'smooth',
      scale: values.light ? this.tone.scale * 2 ** state.exposure : 1 / values.legend.top,
      arrived_scale: trace.active ? trace.scale * 2 ** state.exposure : 0, background,
      other: trace.active ? null : this.other?.[state.quantity], wipe: this.wipe };
  }

  show_trace() {
    document.body.classList.toggle('tracing', this.trace.active);
    if (this.trace.active)
      this.drawing.set_arrived(this.trace.arrived());
    this.panel.show_kind();
    this.request_draw();
  }

  // The lines of the trace, rays, and the outline of the selected patch if its surface is drawn.
  marks() {
    const { room, state: { selected } } = this, marks = this.trace.active ? this.trace.marks() : [];
    if (selected !== null && (this.shows_backs || room.faces(selected, this.camera.eye)))
      room.patch_outline(selected).forEach((from, k, corners) =>
        marks.push({ from, to: corners[(k + 1) % corners.length], width: 3, colour: [0.15, 0.75, 1, 1] }));
    return [...marks, ...this.rays];
  }

  // Shows these rays until another patch is selected, or another result is shown; what is told of them ends with them.
  show_rays(rays) {
    this.rays = rays;
    this.canvas.dispatchEvent(new Event('rays'));
    this.request_draw();
  }

  // The hit seen at a position of the page, in pixels; null if nothing is seen there.
  hit_at(x, y) {
    const box = this.canvas.getBoundingClientRect();
    const direction = this.camera.ray(x - box.left, y - box.top, box.width, box.height);
    return this.room.nearest_hit(this.camera.eye, direction, this.shows_backs);
  }
  patch_at(x, y) {
    const hit = this.hit_at(x, y);
    return hit ? hit.patch : null;
  }

  // For scripts and tests.
  values(patch) { return Object.fromEntries(this.quantities.map(quantity => [quantity.key, value_at(quantity, patch)])); }
  arrived() { return this.trace.arrived(); }
  picture() {
    this.draw();
    return this.drawing.pixels();
  }

  pick_middle() {
    const box = this.canvas.getBoundingClientRect();
    this.change({ selected: this.patch_at(box.left + box.width / 2, box.top + box.height / 2) });
  }
}

// Shows the room whose data are given; returns the viewer.
function start_viewer(data) {
  try {
    const viewer = new Viewer(element('view'));
    viewer.show(data);
    window.multipath = viewer; // for scripts and tests; see docs/builders/page.md
    viewer.decoded = viewer.load_images(data.textures);
    viewer.decoded.finally(() =>
      requestAnimationFrame(() => requestAnimationFrame(() => { viewer.ready = performance.now(); })));
    return viewer;
  } catch (error) {
    element('failure').textContent = error.message;
    element('failure').hidden = false;
    element('hint').hidden = true;
    throw error;
  }
}

if (element('room'))
  start_viewer(JSON.parse(element('room').textContent));
