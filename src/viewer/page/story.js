'use strict';
// "Play the method": single lines, one after the other, what they meet, and the power that goes along them.

// Colours and opacities of stretches that carry power and of those that do not, now and before.
const line_ink = [1, 0.62, 0.1, 1], empty_ink = [0.62, 0.68, 0.78, 0.9];
const past_ink = [0.7, 0.75, 0.85, 0.22], past_empty_ink = [0.7, 0.75, 0.85, 0.07];
const seconds_per_line = 0.7;

// Three channels of what is written as one number where they agree.
const channels = power => power.length === 3 ? power : [power[0], power[0], power[0]];
const mean = c => (c[0] + c[1] + c[2]) / 3;
const median = numbers => numbers.sort((a, b) => a - b)[numbers.length >> 1];

// The unit in which the power that usually goes along a line is a number above one.
function usual_unit(chapter, base) {
  const usual = median(chapter.lines.flatMap(line => line.transfers.map(({ counted }) => mean(channels(counted))))) || 1;
  const units = [['', 1], ['m', 1e-3], ['µ', 1e-6], ['n', 1e-9]].map(([prefix, size]) => ({ name: prefix + base, size }));
  return units.find(({ size }) => usual >= size) || units[3];
}

class Story {
  constructor(chapters, room) {
    this.chapters = chapters;
    this.room = room;
    this.active = false;
    this.chapter = chapters.length > 0 ? chapters.length - 1 : 0;
    this.line = 0; // lines that have been told; 0: none yet
    this.scales = chapters.map(chapter => this.glow_scale(chapter));
    this.units = chapters.map(chapter => usual_unit(chapter, room.power_unit));
  }

  get lines() { return this.chapters.length > 0 ? this.chapters[this.chapter].lines : []; }
  get current() { return this.line > 0 ? this.lines[this.line - 1] : null; }
  get unit() { return this.units[this.chapter]; }
  get scale() { return this.scales[this.chapter] || 1; }

  choose(chapter) {
    this.chapter = chapter;
    this.line = 0;
  }
  go_to(line) { this.line = clamped(line, 0, this.lines.length); }

  // [W/m^2] by which a transfer raises the radiosity of the patch where it arrives.
  gain(transfer) {
    const rho = this.room.reflectance(transfer.to), area = this.room.area(transfer.to);
    return channels(transfer.counted).map((power, k) => rho[k] * power / area);
  }

  // What a usual gain is multiplied with to be seen well.
  glow_scale(chapter) {
    const arrivals = chapter.lines.flatMap(line => line.transfers).filter(({ to }) => to !== null);
    const gains = arrivals.map(transfer => mean(this.gain(transfer))).filter(gain => gain > 0);
    return gains.length > 0 ? 0.5 / median(gains) : 1;
  }

  // [W/m^2] that the lines told so far have brought to every patch: three numbers each.
  arrived() {
    const radiosity = new Float32Array(3 * this.room.patch_count);
    for (const line of this.lines.slice(0, this.line))
      for (const transfer of line.transfers)
        if (transfer.to !== null)
          this.gain(transfer).forEach((x, k) => { radiosity[3 * transfer.to + k] += x; });
    return radiosity;
  }

  // The lines as marks to draw: the current one in colour with its meetings, those before it faintly.
  marks() {
    const marks = [];
    this.lines.slice(0, this.line).forEach((line, n) => {
      const now = n + 1 === this.line;
      const point = k => line.points.slice(3 * k, 3 * k + 3);
      for (let k = 0; k + 1 < line.points.length / 3; ++k) {
        const bold = line.bold[k] === '1';
        const ink = now ? (bold ? line_ink : empty_ink) : (bold ? past_ink : past_empty_ink);
        marks.push({ from: point(k), to: point(k + 1), width: now ? (bold ? 3.5 : 1.5) : 1, colour: ink });
      }
      for (let k = 0; now && k < line.meetings.length; k += 3) {
        const place = line.meetings.slice(k, k + 3);
        marks.push({ from: place, to: place, width: 9, colour: [1, 1, 1, 1] });
        marks.push({ from: place, to: place, width: 6, colour: [0.85, 0.33, 0.02, 1] });
      }
    });
    return marks;
  }
}

// Its controls. The story is on as long as its part of the panel is open.
class StoryPanel {
  constructor(viewer) {
    this.viewer = viewer;
    this.timer = null;
    const { chapters } = viewer.story;
    element('story').hidden = chapters.length === 0;
    element('chapters').hidden = chapters.length < 2;
    chapters.forEach(({ title }, k) => this.add_choice(title, k));
    this.listen();
  }

  add_choice(title, chapter) {
    const label = append_element(element('chapters'), 'label', '');
    const input = append_element(label, 'input', '');
    const checked = chapter === this.viewer.story.chapter;
    Object.assign(input, { type: 'radio', name: 'chapter', value: chapter, checked });
    append_element(label, 'span', title);
    input.addEventListener('change', () => this.choose(chapter));
  }

  listen() {
    element('story').addEventListener('toggle', () => this.open(element('story').open));
    element('next-line').addEventListener('click', () => this.step(1));
    element('previous-line').addEventListener('click', () => this.step(-1));
    element('play').addEventListener('click', () => this.play(this.timer === null));
    element('line').addEventListener('input', event => this.go_to(Number(event.target.value)));
  }

  open(open) {
    const { story } = this.viewer;
    element('story').open = open;
    story.active = open && story.chapters.length > 0;
    if (!open)
      this.play(false);
    if (open && story.line === 0)
      story.go_to(1);
    this.show();
  }

  choose(chapter) {
    this.viewer.story.choose(chapter);
    this.viewer.story.go_to(1);
    this.show();
  }

  // By hand, which ends playing.
  go_to(line) {
    this.play(false);
    this.viewer.story.go_to(line);
    this.show();
  }
  step(lines) { this.go_to(this.viewer.story.line + lines); }

  play(on) {
    const { story } = this.viewer;
    window.clearInterval(this.timer);
    this.timer = null;
    if (on) {
      if (story.line === story.lines.length)
        story.go_to(0);
      this.timer = window.setInterval(() => this.advance(), 1000 * seconds_per_line);
      this.advance();
    }
    element('play').textContent = on ? 'Pause' : 'Play';
    element('play').setAttribute('aria-pressed', String(on));
  }

  advance() {
    const { story } = this.viewer;
    story.go_to(story.line + 1);
    if (story.line === story.lines.length)
      this.play(false);
    this.show();
  }

  show() {
    const { viewer } = this, { story } = viewer;
    if (story.chapters.length > 0) {
      element('story-note').textContent = story.chapters[story.chapter].note;
      element('line').max = story.lines.length;
      element('line').value = story.line;
      element('line-text').textContent = `${story.line} of ${story.lines.length}`;
      element('line').setAttribute('aria-valuetext', `line ${element('line-text').textContent}`);
      this.show_transfers(story.current);
    }
    viewer.show_story();
  }

  show_transfers(line) {
    const transfers = line ? line.transfers : [];
    element('transfers').hidden = transfers.length === 0;
    const meets = line && line.meetings.length > 0;
    element('transfer-none').textContent = !line || transfers.length > 0 ? ''
      : meets ? 'This line joins no patches: it carries no power.' : 'This line meets nothing.';
    const unit = this.viewer.story.unit;
    element('power-unit').textContent = unit.name;
    element('transfer-rows').replaceChildren();
    for (const transfer of transfers) {
      const row = append_element(element('transfer-rows'), 'tr', '');
      this.add_patch(row, transfer.from);
      this.add_patch(row, transfer.to);
      const forecast = channels(transfer.forecast), held = channels(transfer.held);
      for (const power of [forecast, held, plus(forecast, held)])
        append_element(row, 'td', colour_text(times(1 / unit.size, power), 3));
    }
  }

  // A patch that can be looked at, or where power is lost.
  add_patch(row, patch) {
    const cell = append_element(row, 'td', patch === null ? 'lost' : '');
    if (patch === null)
      return;
    const button = append_element(cell, 'button', String(patch));
    button.type = 'button';
    button.setAttribute('aria-label', `Show patch ${patch}`);
    button.addEventListener('click', () => this.viewer.change({ selected: patch }));
  }
}
