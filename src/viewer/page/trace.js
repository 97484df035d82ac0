'use strict';
// "Play the method": shows single lines one after another, the surfaces that they meet, and the power that they carry.

// Colours, opacities and widths [pixels of the page] of segments with and without power, of the current line and of the
// lines before it. They are seen on dark walls and on a light background.
const line_ink = [1, 0.62, 0.1, 1], empty_ink = [0.55, 0.6, 0.7, 0.9];
const past_ink = [0.2, 0.58, 0.9, 0.4], past_empty_ink = [0.5, 0.54, 0.6, 0.3];
const line_widths = [3.5, 1.5], past_widths = [2, 1];
const seconds_per_line = 0.7;

const mean = c => (c[0] + c[1] + c[2]) / 3;
const median = numbers => numbers.sort((a, b) => a - b)[numbers.length >> 1];

// The traced lines that meet something, each with the note of its chapter, its `number` there and the number of lines just
// before it that met nothing; and the number of those shown so far.
class Trace {
  constructor(chapters, room) {
    this.lines = chapters.flatMap(({ note, lines }) => {
      const meeting = lines.map((line, k) => ({ ...line, note, number: k + 1 })).filter(line => line.crossings.length > 0);
      return meeting.map((line, k) => ({ ...line, missed: line.number - 1 - (k > 0 ? meeting[k - 1].number : 0) }));
    });
    this.patch_count = room.patch_count;
    this.active = false;
    this.line = 0; // number of lines shown; 0: none yet
    this.scale = this.glow_scale();
  }

  get current() { return this.line > 0 ? this.lines[this.line - 1] : null; }

  go_to(line) { this.line = clamped(line, 0, this.lines.length); }

  // The factor that makes the median gain well visible.
  glow_scale() {
    const gains = this.lines.flatMap(line => line.transfers.map(({ gain }) => mean(gain))).filter(gain => gain > 0);
    return gains.length > 0 ? 0.5 / median(gains) : 1;
  }

  // [W/m^2] Radiosity that the lines shown so far have brought to every patch: three numbers each.
  arrived() {
    const radiosity = new Float32Array(3 * this.patch_count);
    for (const line of this.lines.slice(0, this.line))
      for (const { to, gain } of line.transfers)
        if (to !== null)
          gain.forEach((x, k) => { radiosity[3 * to + k] += x; });
    return radiosity;
  }

  // The lines as marks to draw: the current one in colour with its hits, those before it faintly.
  marks() {
    const marks = [];
    this.lines.slice(0, this.line).forEach((line, n) => {
      const now = n + 1 === this.line;
      const point = k => line.points.slice(3 * k, 3 * k + 3);
      for (let k = 0; k + 1 < line.points.length / 3; ++k) {
        const bold = line.joins[k] === 1;
        const colour = now ? (bold ? line_ink : empty_ink) : (bold ? past_ink : past_empty_ink);
        marks.push({ from: point(k), to: point(k + 1), width: (now ? line_widths : past_widths)[bold ? 0 : 1], colour });
      }
      for (let k = 0; now && k < line.crossings.length; k += 3) {
        const place = line.crossings.slice(k, k + 3);
        marks.push({ from: place, to: place, width: 9, colour: [1, 1, 1, 1] });
        marks.push({ from: place, to: place, width: 6, colour: [0.85, 0.33, 0.02, 1] });
      }
    });
    return marks;
  }
}

// The controls of the trace, which is shown while its part of the panel is open.
class TracePanel {
  constructor(viewer) {
    this.viewer = viewer;
    this.timer = null;
    this.listen();
  }

  // Begins with the lines of a result.
  begin() {
    element('trace').hidden = this.viewer.trace.lines.length === 0;
    this.open(element('trace').open);
  }

  listen() {
    element('trace').addEventListener('toggle', () => this.open(element('trace').open));
    element('next-line').addEventListener('click', () => this.step(1));
    element('previous-line').addEventListener('click', () => this.step(-1));
    element('play').addEventListener('click', () => this.play(this.timer === null));
    element('line').addEventListener('input', event => this.go_to(Number(event.target.value)));
  }

  open(open) {
    const { trace } = this.viewer;
    element('trace').open = open;
    trace.active = open && trace.lines.length > 0;
    if (!open)
      this.play(false);
    if (open && trace.line === 0)
      trace.go_to(1);
    this.show();
  }

  // The user chooses a line, which ends playing.
  go_to(line) {
    this.play(false);
    this.viewer.trace.go_to(line);
    this.show();
  }
  step(lines) { this.go_to(this.viewer.trace.line + lines); }

  play(on) {
    const { trace } = this.viewer;
    window.clearInterval(this.timer);
    this.timer = null;
    if (on) {
      if (trace.line === trace.lines.length)
        trace.go_to(0);
      this.timer = window.setInterval(() => this.advance(), 1000 * seconds_per_line);
      this.advance();
    }
    element('play').textContent = on ? 'Pause' : 'Play';
    element('play').setAttribute('aria-pressed', String(on));
  }

  advance() {
    const { trace } = this.viewer;
    trace.go_to(trace.line + 1);
    if (trace.line === trace.lines.length)
      this.play(false);
    this.show();
  }

  show() {
    const { viewer } = this, { trace } = viewer;
    if (trace.lines.length > 0) {
      write_text(element('trace-note'), (trace.current || trace.lines[0]).note);
      element('line').max = trace.lines.length;
      element('line').value = trace.line;
      element('line-text').textContent = `${trace.line} of ${trace.lines.length}`;
      element('line').setAttribute('aria-valuetext', `line ${element('line-text').textContent}`);
      this.show_transfers(trace.current);
    }
    viewer.show_trace();
  }

  show_transfers(line) {
    const transfers = line ? line.transfers : [];
    element('transfers').hidden = transfers.length === 0;
    const empty = line && transfers.length === 0 ? ' It carries no power.' : '';
    const missed = !line?.missed ? '' : line.missed === 1 ? ' The line before it met nothing.' : ` ${line.missed} lines before it met nothing.`;
    element('trace-line').textContent = line ? `Number ${line.number} of its kind.${missed}${empty}` : '';
    element('power-unit').textContent = this.viewer.room.power_unit;
    element('transfer-rows').replaceChildren();
    for (const { from, to, forecast, held } of transfers) {
      const row = append_element(element('transfer-rows'), 'tr', '');
      this.add_patch(row, from);
      this.add_patch(row, to);
      for (const power of [forecast, held, plus(forecast, held)])
        append_element(row, 'td', colour_text(power, 3));
    }
  }

  // Appends a cell with a button that selects the patch, or the word 'lost'.
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
