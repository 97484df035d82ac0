'use strict';
// What viewer.sh looks at in the page of a room, which stands in the frame beside this script. A finding is a line of a
// name and numbers.

const frame = document.getElementById('frame');
const drawn = document.getElementById('drawn');
const result = document.getElementById('result');
const findings = []; // shown at the end of each look: a text that grows would be laid out anew for each of them
const find = (name, ...numbers) => { findings.push(`${name} ${numbers.join(' ')}\n`); };

let view, page, multipath; // of the frame

const pause = () => new Promise(done => setTimeout(done, 100));
const by_id = id => page.getElementById(id);

// Events that a browser would not believe to be a finger's: the canvas cannot hold on to them.
function point(type, x, y, more = {}) {
  const canvas = by_id('view');
  canvas.setPointerCapture = () => {};
  canvas.dispatchEvent(new view.PointerEvent(type, { clientX: x, clientY: y, pointerId: 7, bubbles: true, buttons: 1, ...more }));
}
function drag(from, to, more) {
  point('pointerdown', ...from, more);
  point('pointermove', ...to, more);
  point('pointerup', ...to, more);
}
const press = (key, on = by_id('view')) => on.dispatchEvent(new view.KeyboardEvent('keydown', { key, bubbles: true }));
const lift = key => by_id('view').dispatchEvent(new view.KeyboardEvent('keyup', { key, bubbles: true }));
function choose(id, value) {
  by_id(id).value = value;
  by_id(id).dispatchEvent(new view.Event('input', { bubbles: true }));
}

// Mean of red, green and blue (0 ... 255) of a picture, and the share of pixels that differ from the most frequent colour.
function statistics_of({ width, height, bytes }) {
  const sum = [0, 0, 0], counts = new Map();
  for (let k = 0; k < bytes.length; k += 4) {
    for (let channel = 0; channel < 3; ++channel)
      sum[channel] += bytes[k + channel];
    const kind = (bytes[k] >> 3) << 10 | (bytes[k + 1] >> 3) << 5 | bytes[k + 2] >> 3;
    counts.set(kind, (counts.get(kind) || 0) + 1);
  }
  const pixels = width * height;
  return { mean: sum.map(x => x / pixels), varied: 1 - Math.max(...counts.values()) / pixels };
}

// Mean difference of two pictures' channels, and the share of pixels that differ clearly.
function difference(a, b) {
  let sum = 0, far = 0;
  for (let k = 0; k < a.length; k += 4) {
    const apart = [0, 1, 2].map(c => Math.abs(a[k + c] - b[k + c]));
    sum += apart[0] + apart[1] + apart[2];
    far += Math.max(...apart) > 12 ? 1 : 0;
  }
  return { mean: sum / (0.75 * a.length), far: far / (0.25 * a.length) };
}
const pixels = () => multipath.picture().bytes;

// They are hidden at first in a narrow window.
function show_controls(shown) {
  if ((by_id('fold').getAttribute('aria-expanded') === 'true') !== shown)
    by_id('fold').click();
}

// Looks at pages by functions: { '5cubes': [first_view, ...], ... }. A page is loaded anew for each of its functions.
async function look_at(pages) {
  result.textContent = '';
  for (const [name, acts] of Object.entries(pages))
    for (const act of acts) {
      const loaded = element => new Promise(done => element.addEventListener('load', done, { once: true }));
      const both = Promise.all([loaded(frame), loaded(drawn)]);
      frame.src = `${name}.html`;
      drawn.src = `${name}.png`;
      await both;
      await look_once(name, act);
    }
}

async function look_once(name, act) {
  [view, page] = [frame.contentWindow, frame.contentDocument];
  multipath = view.multipath;
  find('look', name, act.name);
  try {
    show_controls(false);
    await pause();
    await multipath.decoded;
    await act();
    find('resources', view.performance.getEntriesByType('resource').filter(e => !e.name.startsWith('data:')).length);
    find('wide', page.documentElement.scrollWidth > page.documentElement.clientWidth ? 1 : 0);
    find('end', 1);
  } catch (error) {
    find(`failed ${error.stack}`);
  }
  result.textContent = findings.join('');
}

// Radiosities at the middles of pixels.
function patches_found() {
  for (let y = 3; y < 600; y += 12)
    for (let x = 3; x < 800; x += 16) {
      const patch = multipath.patch_at(x + 0.5, y + 0.5);
      if (patch !== null)
        find('at', x, y, ...multipath.values(patch).radiosity);
    }
}

function picture_compared() {
  page.documentElement.style.setProperty('--outside', '0 0 0'); // as in pictures
  const canvas = Object.assign(document.createElement('canvas'), { width: 800, height: 600 });
  const context = canvas.getContext('2d', { willReadFrequently: true });
  // From the bottom row up, as the page gives its picture.
  context.scale(1, -1);
  context.drawImage(drawn, 0, -600);
  const picture = multipath.picture();
  find('width', picture.width);
  const { mean, far } = difference(picture.bytes, context.getImageData(0, 0, 800, 600).data);
  find('mean_difference', mean);
  find('far_off', far);
}

// Is the floor between two coloured walls red on one side, blue on the other?
function first_view() {
  const { bytes, width, height } = multipath.picture(), statistics = statistics_of(multipath.picture());
  find('varied', statistics.varied);
  const share = is => bytes.reduce((n, x, k) => n + (k % 4 === 0 && is(x, bytes[k + 1], bytes[k + 2]) ? 1 : 0), 0) / (width * height);
  find('white', share((r, g, b) => r > 250 && g > 250 && b > 250));
  find('black', share((r, g, b) => r < 8 && g < 8 && b < 8));
  const back_wall = x => 4 * (Math.round(0.72 * height) * width + Math.round(x * width));
  const redness = x => bytes[back_wall(x)] - bytes[back_wall(x) + 2];
  find('red_left', redness(0.32) - redness(0.5));
  find('blue_right', redness(0.5) - redness(0.68));
}

async function click_on_patch() {
  const before = pixels(), place = [420, 330];
  find('expected', multipath.patch_at(...place));
  drag(place, [place[0] + 1, place[1]]);
  await pause();
  find('selected', multipath.state.selected);
  find('shown', page.querySelector('#patch-rows td').textContent);
  find('changed', difference(before, pixels()).far);
  drag([100, 100], [160, 120]);
  find('after_drag', multipath.state.selected);
}

async function lines_traced() {
  const power = () => multipath.arrived().reduce((sum, x) => sum + x, 0), before = statistics_of(multipath.picture()).mean[1];
  const lines = JSON.parse(by_id('room').textContent).trace.flatMap(chapter => chapter.lines), shown = multipath.trace.lines;
  find('unlike', shown.length - lines.filter(line => line.crossings.length > 0).length);
  find('skipped', lines.length - shown.length, lines.length);
  find('misnumbered', shown.filter((line, k) => line.number !== (k > 0 && shown[k - 1].note === line.note ? shown[k - 1].number : 0) + line.missed + 1).length);
  by_id('trace').open = true;
  await pause();
  find('lines', by_id('line').max);
  find('darker', statistics_of(multipath.picture()).mean[1] - before);
  choose('line', 20);
  const [early, picture] = [power(), pixels()];
  find('power_first', early);
  choose('line', 80);
  find('power_later', power());
  find('moved', difference(picture, pixels()).far);
  choose('line', 20);
  find('power_again', power());
  let rows = 0;
  choose('line', 0);
  for (let n = 0; n < 5; ++n) {
    by_id('next-line').click();
    rows += page.querySelectorAll('#transfer-rows tr').length;
  }
  find('line', multipath.trace.line);
  find('rows', rows);
  const note_of = line => { choose('line', line); return by_id('trace-note').textContent; };
  find('notes', new Set([1, 100, 101, 200].map(note_of)).size);
  choose('quantity', 2);
  find('trace_legend', by_id('legend').hidden ? 0 : 1);
  by_id('trace').open = false;
  await pause();
  find('later_legend', by_id('legend').hidden ? 0 : 1);
}

function quantities_shown() {
  const before = pixels(), light = statistics_of(multipath.picture()).mean[1];
  choose('quantity', 1);
  find('direct', statistics_of(multipath.picture()).mean[1] - light);
  choose('quantity', 2);
  find('unlike', difference(before, pixels()).mean);
  find('legend', by_id('legend').hidden ? 0 : 1);
  find('numbers', by_id('legend-numbers').childElementCount);
  choose('quantity', 0);
  find('gone', difference(before, pixels()).mean);
  choose('exposure', 1);
  find('brighter', statistics_of(multipath.picture()).mean[1] - light);
  choose('exposure', 0);
  by_id('mesh').click();
  find('borders', difference(before, pixels()).far);
}

async function keys_pressed() {
  const camera = multipath.camera, apart = (a, b) => Math.hypot(...a.map((x, k) => x - b[k])) / multipath.room.size;
  const distance = () => apart(camera.eye, camera.target), first = { eye: camera.eye.slice(), target: camera.target.slice() };
  const far = distance();
  drag([300, 300], [380, 340]);
  find('orbited', apart(camera.eye, first.eye));
  find('kept', Math.abs(distance() - far) + apart(camera.target, first.target));
  by_id('view').dispatchEvent(new view.WheelEvent('wheel', { deltaY: -120, bubbles: true, cancelable: true }));
  find('nearer', distance() / far);
  const eye = camera.eye.slice();
  press('w');
  lift('w');
  find('walked', apart(camera.eye, eye));
  press('r');
  find('home', apart(camera.eye, first.eye) + apart(camera.target, first.target));
  press('o');
  find('outside', multipath.camera.within() ? 0 : 1);
  find('all', statistics_of(multipath.picture()).varied);
  press('h');
  find('folded', by_id('controls').hidden ? 0 : 1); // it was hidden before
  press('?');
  find('help', by_id('help').open ? 1 : 0);
}

// Whatever the pointer and the keys do, a part of the room is in the picture: the least share of pixels that it takes.
async function room_kept() {
  const { camera } = multipath, turn = y => by_id('view').dispatchEvent(new view.WheelEvent('wheel', { deltaY: y, bubbles: true, cancelable: true }));
  const share = () => statistics_of(multipath.picture()).varied;
  const way = ([x, y], more) => { for (let n = 0; n < 12; ++n) drag([400, 300], [400 + x, 300 + y], more); };
  for (let n = 0; n < 60; ++n)
    turn(200);
  find('far', share());
  for (const away of [[300, 0], [-300, 0], [0, 200], [0, -200]]) {
    press('r');
    const inside = camera.within();
    for (let n = 0; n < 6; ++n)
      turn(200);
    way(away, { shiftKey: true });
    find('shifted', share(), inside ? 1 : 0);
    press('v');
    way(away);
    find('looked', share());
    press('v');
    way(away);
    find('orbited', share());
  }
  // Walks end at the walls, and go through what stands in the room.
  press('r');
  const before = camera.eye.slice();
  for (let n = 0; n < 4000; ++n)
    camera.keep_room(c => c.walk(0.001, 0, 0));
  find('walked', Math.hypot(...camera.eye.map((x, k) => x - before[k])) / camera.size);
  find('within', camera.within() ? 1 : 0);
}

function view_saved() {
  const saved = {}, camera = multipath.camera;
  view.HTMLAnchorElement.prototype.click = function () { saved[this.download] = this.href; };
  drag([300, 300], [380, 340]);
  const in_scene = point => point.map((x, k) => x + camera.zero[k]);
  find('at', ...in_scene(camera.eye), ...in_scene(camera.target));
  by_id('save-view').click();
  by_id('save-picture').click();
  find('json', decodeURIComponent(saved['view.json'].split(',')[1]).trim());
  find('options', multipath.view_options());
  const bytes = atob(saved['view.png'].split(',')[1]);
  find('width', (bytes.charCodeAt(18) << 8 | bytes.charCodeAt(19)) / multipath.picture().width);
  find('bytes', bytes.length); // of a picture of one colour there are few
}

function names_of_controls() {
  show_controls(true);
  const controls = [...page.querySelectorAll('button, input, select, summary, canvas[tabindex]')];
  const name = c => c.getAttribute('aria-label') || c.textContent.trim() || [...(c.labels || [])].map(l => l.textContent.trim()).join('');
  find('controls', controls.length);
  find('nameless', controls.filter(c => !name(c)).length);
  find('hidden_focus', controls.filter(c => c.tabIndex < 0).length);
}

// To the console, since in real time nobody waits for findings.
function time_opening(name) {
  frame.src = `${name}.html`;
  frame.addEventListener('load', () => {
    frame.contentWindow.multipath.picture();
    console.log(`opened in ${Math.round(frame.contentWindow.performance.now())} ms`);
  });
}
