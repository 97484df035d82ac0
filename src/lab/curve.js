'use strict';
// The error against the number of lines, in a log-log plot with fitted slopes.

const curve_colours = ['var(--first)', 'var(--second)'];

// The relative mean square error of radiosities, three numbers per patch, as the program's `compare` has it: (1) over the
// square of the right mean radiosity, in the mean of the channels.
function relative_error(found, right, areas) {
  let wrong = 0, light = 0, all = 0;
  for (let i = 0; i < areas.length; ++i) {
    all += areas[i];
    for (let k = 3 * i; k < 3 * i + 3; ++k) {
      wrong += areas[i] * (found[k] - right[k]) ** 2 / 3;
      light += areas[i] * right[k] / 3;
    }
  }
  return wrong * all / light ** 2;
}

// Slope and constant of log10(error) by log10(lines), by least squares over all points but the first of more than four. Null
// with fewer than three points. Results share their first lines, so the scatter of the points tells no error of the slope.
function fitted(points) {
  const used = points.slice(points.length > 4 ? points.length >> 2 : 0).filter(({ error }) => error > 0);
  if (used.length < 3)
    return null;
  const x = used.map(({ lines }) => Math.log10(lines)), y = used.map(({ error }) => Math.log10(error)), n = used.length;
  const mean_of = list => list.reduce((a, b) => a + b) / n, mx = mean_of(x), my = mean_of(y);
  const sxx = x.reduce((sum, a) => sum + (a - mx) ** 2, 0), sxy = x.reduce((sum, a, k) => sum + (a - mx) * (y[k] - my), 0);
  return { slope: sxy / sxx, constant: my - sxy / sxx * mx };
}

class Curve {
  // `series`: the runs in the order in which they were made, each { letter, name, points: [{ lines, error }] }; at most two.
  constructor(svg, text) {
    Object.assign(this, { svg, text });
  }

  show(series) {
    const points = series.flatMap(one => one.points).filter(({ error }) => error > 0);
    this.svg.replaceChildren();
    if (points.length === 0) {
      write_text(this.text, 'The error (1) appears here as soon as the reference is solved.');
      return;
    }
    this.range(points);
    this.axes();
    this.text.replaceChildren();
    series.forEach((one, n) => this.draw(one, n));
  }

  range(points) {
    const x = points.map(({ lines }) => Math.log10(lines)), y = points.map(({ error }) => Math.log10(error));
    this.low = [Math.floor(Math.min(...x)), Math.floor(Math.min(...y))];
    this.high = [Math.max(this.low[0] + 3, Math.ceil(Math.max(...x))), Math.max(this.low[1] + 2, Math.ceil(Math.max(...y)))];
  }
  place(lines, error) {
    const share = (value, k) => (Math.log10(value) - this.low[k]) / (this.high[k] - this.low[k]);
    return [48 + 340 * share(lines, 0), 226 - 212 * share(error, 1)];
  }

  add(name, attributes, text = '', parent = this.svg) {
    const child = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes))
      child.setAttribute(key, value);
    child.textContent = text;
    parent.append(child);
    return child;
  }

  axes() {
    const label = (x, y, power, anchor) => {
      const text = this.add('text', { x, y, 'text-anchor': anchor }, '10');
      this.add('tspan', { dy: -5, 'font-size': 9 }, String(power).replace('-', '−'), text);
    };
    for (let power = this.low[0]; power <= this.high[0]; ++power) {
      const [x] = this.place(10 ** power, 1);
      this.add('line', { x1: x, x2: x, y1: 14, y2: 226, class: 'grid' });
      label(x, 244, power, 'middle');
    }
    const step = Math.ceil((this.high[1] - this.low[1]) / 7);
    for (let power = this.low[1]; power <= this.high[1]; power += step) {
      const [, y] = this.place(1, 10 ** power);
      this.add('line', { x1: 48, x2: 388, y1: y, y2: y, class: 'grid' });
      label(42, y + 4, power, 'end');
    }
    this.add('text', { x: 218, y: 263, 'text-anchor': 'middle' }, 'lines N');
    this.add('text', { x: -120, y: 9, 'text-anchor': 'middle', transform: 'rotate(-90)' }, 'relative MSE');
  }

  // Draws a curve with its fit, and tells its numbers beside its mark: a disc for the first, a square for the second.
  draw(one, n) {
    const { points } = one, colour = curve_colours[n];
    if (points.length === 0)
      return;
    const right = points.filter(({ error }) => error > 0), places = right.map(({ lines, error }) => this.place(lines, error));
    const fit = fitted(right);
    if (fit) {
      const top = fit.slope < 0 ? 10 ** ((this.high[1] - fit.constant) / fit.slope) : 0; // it ends at the border
      const ends = [Math.max(right[0].lines, top), right[right.length - 1].lines];
      const [a, b] = ends.map(n => this.place(n, 10 ** (fit.constant + fit.slope * Math.log10(n))));
      this.add('line', { x1: a[0], y1: a[1], x2: b[0], y2: b[1], stroke: colour, 'stroke-dasharray': '5 4' });
    }
    this.add('polyline', { points: places.map(p => p.join()).join(' '), fill: 'none', stroke: colour, 'stroke-width': 2 });
    for (const [x, y] of places)
      this.add('rect', { x: x - 3.6, y: y - 3.6, width: 7.2, height: 7.2, rx: n === 0 ? 3.6 : 0, fill: colour });
    const mark = append_element(this.text, 'span', '');
    Object.assign(mark.style, { background: colour, borderRadius: n === 0 ? '50%' : 0 });
    const text = append_element(this.text, 'p', '');
    append_element(text, 'b', one.letter).style.color = colour;
    write_text(append_element(text, 'span', ''), ` ${this.sentence(one)}`);
  }

  sentence({ name, points }) {
    const fit = fitted(points), last = points[points.length - 1];
    const slope = fit ? `, slope about ${number_text(Number(fit.slope.toFixed(2)))}` : '';
    return `${name}: error (1) ${number_text(last.error, 2)} with ${grouped(last.lines)} lines${slope}.`;
  }
}
