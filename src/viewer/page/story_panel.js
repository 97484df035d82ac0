'use strict';
// The controls of "play the method". The story is on as long as its part of the panel is open.

const seconds_per_line = 0.7;

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
        append_element(row, 'td', colour_text(times(1 / unit.watts, power), 3));
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
