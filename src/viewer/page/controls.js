'use strict';
// Mouse, fingers and keys move the camera, pick patches and act as shortcuts for buttons of the panel.

const radians_per_pixel = 0.005;
const click_distance = 5; // [pixels] a click may move this far
const walking_speed = 0.22; // of the room's size per second

class Controls {
  constructor(viewer, canvas, trace_panel) {
    Object.assign(this, { viewer, canvas, trace_panel });
    this.pointers = new Map(); // position of each pressed pointer, by its id
    this.travelled = 0;
    this.held = new Set(); // walking keys that are down
    canvas.addEventListener('pointerdown', event => this.press(event));
    canvas.addEventListener('pointermove', event => this.drag(event));
    canvas.addEventListener('pointerup', event => this.release(event, true));
    canvas.addEventListener('pointercancel', event => this.release(event, false));
    canvas.addEventListener('contextmenu', event => event.preventDefault());
    canvas.addEventListener('wheel', event => this.wheel(event), { passive: false });
    window.addEventListener('keydown', event => this.key(event));
    window.addEventListener('keyup', event => this.held.delete(event.key.toLowerCase()));
    window.addEventListener('blur', () => this.held.clear());
  }

  press(event) {
    element('hint').hidden = true; // the user knows it now
    this.canvas.setPointerCapture(event.pointerId);
    if (this.pointers.size === 0)
      this.travelled = 0;
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
  }

  drag(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before)
      return;
    const now = [event.clientX, event.clientY], dx = now[0] - before[0], dy = now[1] - before[1];
    this.travelled += Math.hypot(dx, dy);
    if (this.pointers.size === 2)
      this.pinch(event.pointerId, before, now);
    else if (event.buttons & 6 || event.shiftKey)
      this.shift(dx, dy);
    else
      this.turn(dx, dy);
    this.pointers.set(event.pointerId, now);
  }

  release(event, may_pick) {
    const pressed = this.pointers.delete(event.pointerId);
    if (pressed && may_pick && this.pointers.size === 0 && event.button === 0 && this.travelled < click_distance)
      this.viewer.change({ selected: this.viewer.patch_at(event.clientX, event.clientY) });
  }

  // Two fingers: a larger distance moves nearer, a common motion shifts the view.
  pinch(id, before, now) {
    const other = [...this.pointers].find(([pointer]) => pointer !== id)[1];
    const distance = a => Math.max(10, Math.hypot(a[0] - other[0], a[1] - other[1]));
    this.viewer.move(camera => camera.approach(distance(before) / distance(now)));
    this.shift(0.5 * (now[0] - before[0]), 0.5 * (now[1] - before[1]));
  }

  shift(dx, dy) {
    this.viewer.move(camera => camera.shift(dx / this.canvas.clientHeight, dy / this.canvas.clientHeight));
  }

  turn(dx, dy) {
    const left = -dx * radians_per_pixel, up = -dy * radians_per_pixel, orbits = this.viewer.state.motion === 'orbit';
    this.viewer.move(camera => orbits ? camera.orbit(left, up) : camera.look(-left, -up));
  }

  wheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 30 : 1;
    this.viewer.move(camera => camera.approach(Math.exp(clamped(event.deltaY * lines, -200, 200) * 0.0015)));
  }

  key(event) {
    const typed = event.target.closest('input, select');
    const takes_keys = typed && typed.type !== 'checkbox' && typed.type !== 'radio';
    if (event.ctrlKey || event.metaKey || event.altKey || takes_keys)
      return;
    const on_canvas = event.target === this.canvas || event.target === document.body;
    const key = event.key.toLowerCase();
    if ('wasdqe'.includes(key) && key.length === 1)
      this.hold(key);
    else if (on_canvas && key.startsWith('arrow'))
      this.turn(...{ arrowleft: [-20, 0], arrowright: [20, 0], arrowup: [0, -20], arrowdown: [0, 20] }[key]);
    else if (on_canvas && key === 'enter')
      this.viewer.pick_middle();
    else if (!this.shortcut(key))
      return;
    event.preventDefault();
  }

  // Clicks the control that the page names for a key. False if there is none.
  shortcut(key) {
    const control = document.querySelector(`[data-key="${CSS.escape(key)}"]:not([type=radio]:checked)`);
    if (element('trace').contains(control))
      this.trace_panel.open(true);
    control?.click();
    return Boolean(control);
  }

  // Walks while a key is down. The first step comes at once, so that a short press moves too.
  hold(key) {
    const moving = this.held.size > 0;
    this.held.add(key);
    if (!moving) {
      this.moment = performance.now();
      this.step(1 / 60);
      requestAnimationFrame(now => this.stride(now));
    }
  }

  stride(now) {
    if (this.held.size === 0)
      return;
    this.step(clamped((now - this.moment) / 1000, 0.004, 0.1));
    this.moment = now;
    requestAnimationFrame(later => this.stride(later));
  }

  step(seconds) {
    const way = (plus_key, minus_key) => walking_speed * seconds * (this.held.has(plus_key) - this.held.has(minus_key));
    this.viewer.move(camera => camera.walk(way('w', 's'), way('d', 'a'), way('e', 'q')));
  }
}
