'use strict';
// The panel of controls, which shows the viewer's state and changes it.

const element = id => document.getElementById(id);

// Appends a new element with a text to a parent, and returns it.
function append_element(parent, name, text) {
  const child = document.createElement(name);
  child.textContent = text;
  parent.append(child);
  return child;
}

// Appends a row of a table; its first cell is the heading.
function append_row(table, [heading, ...cells]) {
  const row = append_element(table, 'tr', '');
  append_element(row, 'th', heading).scope = 'row';
  cells.forEach(text => append_element(row, 'td', text));
}

// Appends a label with an explanation, given by the function `text`, that the style sheet shows under the pointer or the focus.
function append_tip(parent, label, text) {
  const tip = append_element(parent, 'span', label), told = append_element(tip, 'span', '');
  Object.assign(tip, { className: 'tip', tabIndex: 0, role: 'button' });
  for (const event of ['focus', 'pointerenter'])
    tip.addEventListener(event, () => write_text(told, text(), {}));
}

// Replaces what an element holds by a text with indices as in N_l. Labels as "(3)" explain their formulas, if the page has them.
const formulas = JSON.parse(element('formulas')?.textContent || '{}');
function write_text(parent, text, explained = formulas) {
  parent.replaceChildren();
  for (const part of text.replace(/m\^2/g, 'm²').split(/(\([A-Z]?\d\)|(?<=(?:^|[^\p{L}])\p{L})_\p{L}+)/u))
    if (part in explained) append_tip(parent, part, () => explained[part]);
    else if (part[0] === '_') append_element(parent, 'sub', part.slice(1));
    else parent.append(part);
}

const grouped = count => String(count).replace(/\B(?=(\d{3})+$)/g, ',');

const save_as = (name, url) => Object.assign(document.createElement('a'), { href: url, download: name }).click();

// Copies a text at the press of a button. Some browsers do not let pages from files use the clipboard.
async function copy_text(button, text) {
  try {
    await navigator.clipboard.writeText(text);
    button.classList.add('done');
    setTimeout(() => button.classList.remove('done'), 1500);
  } catch {
    window.prompt('To be copied', text);
  }
}

// Hides what an aside holds but for its button, or shows it again.
function fold(aside, folded) {
  const button = aside.querySelector('header button');
  aside.classList.toggle('folded', folded);
  aside.querySelector('header + div').hidden = folded;
  button.textContent = folded ? aside.getAttribute('aria-label') : 'Hide';
  button.setAttribute('aria-expanded', String(!folded));
}

class Panel {
  constructor(viewer) {
    this.viewer = viewer;
    this.controls = document.querySelectorAll('[data-state]'); // each shows the part of the state that is its name
    this.listen();
    const asides = [...document.querySelectorAll('aside')], narrow = window.matchMedia(`(max-width: ${asides.length > 1 ? 1100 : 640}px)`);
    for (const aside of asides)
      aside.querySelector('header button').addEventListener('click', () => {
        const folded = aside.classList.contains('folded');
        (narrow.matches ? asides : [aside]).forEach(one => fold(one, !(one === aside && folded))); // there is room for one
      });
    fold(element('panel'), narrow.matches);
    narrow.addEventListener('change', () => fold(element('panel'), narrow.matches));
  }

  // Names the room and what can be shown of it.
  show(data) {
    const { quantities, room: { box: [low, high], all, power_unit, file } } = this.viewer, text = x => number_text(x, 3);
    for (const list of ['record', 'quantity'])
      element(list).replaceChildren();
    element('name').textContent = file.replace(/\.obj$/i, '');
    for (const fact of [data.scene, `${minus(high, low).map(text).join(' × ')} m`, `${grouped(data.patches)} patches of ${text(all.area)} m²`,
                        `mean reflectance ${text(all.reflectance)}`, `lamps of ${text(all.power)} ${power_unit}`, ...data.record])
      append_element(element('record'), 'li', fact);
    quantities.forEach(({ title }, k) => append_element(element('quantity'), 'option', title).value = k);
  }

  listen() {
    const viewer = this.viewer;
    const on = (id, event, act) => element(id).addEventListener(event, act);
    for (const control of this.controls)
      control.addEventListener('input', () => viewer.change({ [control.name]: this.value_of(control) }));
    on('home', 'click', () => viewer.go_home());
    on('outside', 'click', () => viewer.go_outside());
    on('copy-view', 'click', event => copy_text(event.target, viewer.view_options()));
    on('save-view', 'click', () => save_as('view.json',
      'data:application/json,' + encodeURIComponent(JSON.stringify(viewer.view()) + '\n')));
    on('save-picture', 'click', () => save_as('view.png', viewer.png()));
  }

  value_of(control) {
    return control.type === 'checkbox' ? control.checked : control.dataset.state === 'number' ? Number(control.value) : control.value;
  }

  // Shows the state; called after every change.
  refresh(state) {
    for (const control of this.controls)
      if (control.type === 'radio') control.checked = control.value === state[control.name];
      else if (control.type === 'checkbox') control.checked = state[control.name];
      else control.value = state[control.name];
    element('exposure-text').textContent = `${state.exposure > 0 ? '+' : ''}${number_text(state.exposure)} stops`;
    this.show_kind();
    this.show_patch(state.selected);
  }

  // Adapts the controls to light, or to false colours, which have a legend but no exposure.
  show_kind() {
    const drawn = this.viewer.quantities[this.viewer.drawn_quantity];
    document.body.classList.toggle('false-colours', !drawn.light);
    element('direct-note').hidden = drawn.key !== 'direct';
    this.show_legend(drawn);
  }

  show_legend({ title, unit, legend }) {
    element('legend').hidden = !legend;
    if (!legend)
      return;
    element('legend-title').textContent = `${title} [${unit}]`;
    const colours = Array.from({ length: 256 }, (_, k) => `rgb(${this.viewer.colour_map.subarray(3 * k, 3 * k + 3).join()})`);
    element('legend-bar').style.background = `linear-gradient(90deg, ${colours.join()})`;
    element('legend-numbers').replaceChildren();
    for (const number of legend.numbers)
      append_element(element('legend-numbers'), 'span', number);
  }

  show_patch(patch) {
    element('patch-none').hidden = patch !== null;
    element('patch-rows').replaceChildren();
    if (patch === null)
      return;
    const { room, quantities, other } = this.viewer;
    const material = room.material_of(patch);
    const back = room.is_back(patch) ? ', its back' : '';
    const rows = [['Number', String(patch)], ['Surface', room.surface_name(room.surface_of(patch)) + back],
                  ['Material', material.name], ['Reflectance ρ', colour_text(room.reflectance(patch))],
                  [`Emittance E [${quantities[0].unit}]`, colour_text(room.emittance(patch))]];
    quantities.forEach((quantity, k) => {
      const [a, b] = [other || quantities, quantities].map(list => colour_text(value_at(list[k], patch)));
      rows.push([`${quantity.title} [${quantity.unit}]`, a === b ? b : `A: ${a}\nB: ${b}`]);
    });
    for (const [name, value] of rows)
      append_row(element('patch-rows'), [name, value]);
  }
}
