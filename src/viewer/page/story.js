'use strict';
// Single lines of the method, one after the other: what they meet, and the power that goes along them.

// Colours and opacities of stretches that carry power and of those that do not, now and before.
const line_ink = [1, 0.62, 0.1, 1], empty_ink = [0.62, 0.68, 0.78, 0.9];
const past_ink = [0.7, 0.75, 0.85, 0.22], past_empty_ink = [0.7, 0.75, 0.85, 0.07];

// Three channels of what is written as one number where they agree.
const channels = power => power.length === 3 ? power : [power[0], power[0], power[0]];

// The unit in which the power that usually goes along a line is a number above one.
function usual_unit(chapter) {
  const means = [];
  for (const { transfers } of chapter.lines)
    for (const { counted } of transfers)
      means.push(dot(channels(counted), [1 / 3, 1 / 3, 1 / 3]));
  means.sort((a, b) => a - b);
  const usual = means[means.length >> 1] || 1;
  const units = [['W', 1], ['mW', 1e-3], ['µW', 1e-6], ['nW', 1e-9]].map(([name, watts]) => ({ name, watts }));
  return units.find(({ watts }) => usual >= watts) || units[3];
}

class Story {
  constructor(chapters, room) {
    this.chapters = chapters;
    this.room = room;
    this.active = false;
    this.chapter = chapters.length > 0 ? chapters.length - 1 : 0;
    this.line = 0; // lines that have been told; 0: none yet
    this.scales = chapters.map(chapter => this.glow_scale(chapter));
    this.units = chapters.map(usual_unit);
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
    const rho = this.room.material_of(transfer.to).reflectance, area = this.room.area(transfer.to);
    return channels(transfer.counted).map((power, k) => rho[k] * power / area);
  }

  // What a usual gain is multiplied with to be seen well.
  glow_scale(chapter) {
    const gains = [];
    for (const line of chapter.lines)
      for (const transfer of line.transfers)
        if (transfer.to !== null) {
          const gain = this.gain(transfer), mean = (gain[0] + gain[1] + gain[2]) / 3;
          if (mean > 0)
            gains.push(mean);
        }
    gains.sort((a, b) => a - b);
    return gains.length > 0 ? 0.5 / gains[gains.length >> 1] : 1;
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
