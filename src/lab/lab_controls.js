'use strict';
// The controls of the laboratory: they show its state and change it.

class LabControls {
  constructor(lab) {
    this.lab = lab;
    for (const file of lab.bundled.keys())
      if (file.endsWith('.obj'))
        append_element(element('scene'), 'option', file.replace('.obj', '')).value = file.replace('.obj', '');
    append_element(element('lesson-choice'), 'option', 'none: play freely').value = '';
    lab.lessons.forEach(({ key, title }) => append_element(element('lesson-choice'), 'option', title).value = key);
    this.statements = { ...formulas };
    this.rows = new Map(settings.map(setting => [setting.key, this.add_setting(setting)]));
    this.listen();
  }

  add_setting({ key, title, values, more }) {
    const row = append_element(element(more ? 'more-settings' : 'settings'), 'div', '');
    row.className = 'row';
    if (more)
      append_tip(row, title, () => element(`note-${key}`).textContent.replace(/ \([34]\)/, label => `: ${formulas[label.trim()]}`));
    else
      append_element(row, 'span', title);
    const select = append_element(row, 'select', '');
    select.id = `setting-${key}`;
    select.setAttribute('aria-label', title);
    for (const [value, text] of values)
      append_element(select, 'option', text).value = value;
    select.addEventListener('change', () => this.lab.restart({ [key]: select.value }));
    return row;
  }

  listen() {
    const lab = this.lab, on = (id, event, act) => element(id).addEventListener(event, act);
    on('scene', 'change', event => lab.restart({ scene: event.target.value }));
    on('size', 'input', event => {
      lab.leave_lesson();
      lab.change({ size: Number(event.target.value) });
    });
    on('size', 'change', () => lab.can_go_on && lab.resume());
    on('start', 'click', () => lab.job ? lab.stop() : lab.resume());
    on('keep', 'click', () => lab.keep());
    on('clear', 'click', () => lab.clear());
    on('wipe', 'input', () => lab.show_comparison());
    on('open', 'click', () => element('files').click());
    on('files', 'change', event => lab.open(event.target.files));
    on('lesson-choice', 'change', event => lab.choose_lesson(event.target.value));
    on('copy-command', 'click', event => copy_text(event.target, lab.command()));
    this.who = append_element(element('patch'), 'button', 'Who lights it?');
    Object.assign(this.who, { type: 'button', disabled: true });
    this.who.addEventListener('click', () => lab.show_lights());
    this.lights = append_element(element('patch'), 'table', '');
    on('view', 'rays', () => {
      this.lights.replaceChildren();
      this.who.disabled = lab.viewer?.state.selected == null;
    });
    for (const button of document.querySelectorAll('[data-save]'))
      button.addEventListener('click', () => lab.save(button.dataset.save));
    on('stage', 'dragover', event => event.preventDefault());
    on('stage', 'drop', event => {
      event.preventDefault();
      lab.open(event.dataTransfer.files);
    });
    window.addEventListener('hashchange', () => lab.follow(location.hash.slice(1)));
  }

  refresh(state) {
    element('scene').value = state.scene;
    element('lesson-choice').value = state.lesson;
    for (const setting of settings) {
      const row = this.rows.get(setting.key);
      row.hidden = !applies(setting, state.method);
      row.querySelector('select').value = state[setting.key];
    }
    this.show_running(Boolean(this.lab.job));
    element('size').value = state.size;
    element('size-text').textContent = grouped(2 ** state.size);
    element('command').replaceChildren();
    this.lab.command().split(/ (?=-)/).forEach(part => append_element(element('command'), 'span', `${part} `));
    write_text(element('method-text'), element(`note-${state.method}`).textContent);
  }

  // The present values of the formulas, where they are known.
  show_values() {
    const { run, state, viewer, shown_key, key } = this.lab, last = run?.points[run.points.length - 1], { area, power, reflectance } = viewer?.room.all || {};
    element('clear').disabled = !this.lab.kept;
    const values = { '(1)': last && number_text(last.error, 2), '(3)': this.lab.ratios[[key, state.method]]?.toFixed(2),
                     '(4)': shown_key === key && area && `${number_text(reflectance * power / (area * (1 - reflectance)))} W/m²` };
    for (const [label, value] of Object.entries(values))
      formulas[label] = this.statements[label] + (value ? `; here ${value}` : '');
    for (const [setting, label] of [['ratio', '(3)'], ['threshold', '(4)']])
      element(`setting-${setting}`).options[0].textContent = `by ${label}${values[label] ? `: ${values[label]}` : ''}`;
  }

  show_running(on) {
    element('start').textContent = on ? 'Stop' : this.lab.can_go_on ? 'Go on' : 'Double N';
    element('start').disabled = !on && this.lab.next > 2 ** element('size').max;
    document.body.classList.toggle('running', on);
  }
  show_progress(lines, share) {
    const { state, predicted, queue } = this.lab, lesson_runs = predicted === undefined ? 0 : this.lab.lesson().runs.length;
    const run = lesson_runs > 1 ? `run ${lesson_runs - queue.length} of ${lesson_runs}: ` : '';
    const text = share < 1 ? `${run}${grouped(lines)} of ${grouped(2 ** state.size)} lines` : `${grouped(lines)} lines`;
    element('progress').textContent = text;
    if (lesson_runs > 0)
      element('lesson-status').textContent = share < 1 || queue.length > 0 ? text : 'Waiting for the reference.';
  }
  show_message(text) { element('lab-message').textContent = text.trim().split('\n').pop(); }

  // A lesson: its text, its question with answers to choose from, and what the run then shows.
  show_lesson(lesson) {
    document.body.classList.toggle('in-lesson', Boolean(lesson));
    for (const id of ['lesson-text', 'lesson-answers', 'lesson-finding', 'tried'])
      element(id).replaceChildren();
    element('more-settings').append(...settings.filter(({ more }) => more).map(({ key }) => this.rows.get(key)));
    element('lesson-status').textContent = !lesson ? '' : `Choose an answer: then ${lesson.runs.length > 1 ? 'both runs start' : 'the run starts'}.`;
    if (!lesson)
      return;
    for (const paragraph of [...lesson.text, lesson.question])
      write_text(append_element(element('lesson-text'), 'p', ''), paragraph);
    element('lesson-text').lastChild.className = 'question';
    for (const [number, answer] of lesson.answers.entries()) {
      const button = append_element(element('lesson-answers'), 'button', answer);
      button.type = 'button';
      button.addEventListener('click', () => this.lab.predict(number));
    }
  }
  show_answer(number) {
    [...element('lesson-answers').children].forEach((button, k) => {
      button.setAttribute('aria-pressed', String(k === number));
      button.disabled = true;
    });
  }
  // The surfaces that light the selected patch, with their shares.
  show_lights(surfaces) {
    if (element('stage').classList.contains('compared'))
      append_row(this.lights, ['By the light of B', '']);
    for (const { name, share } of surfaces)
      append_row(this.lights, [name, `${(100 * share).toFixed(1)} %`]);
  }
  // Of the halves of the picture, which are there if `shown`, while there are two curves.
  show_comparison(compared, shown) {
    element('wipe-row').hidden = !compared;
    element('wipe').disabled = !shown;
    element('wipe-text').textContent = shown || !this.lab.run.quantities ? 'Left A, right B' : 'The picture is of B: A has other patches';
    element('stage').classList.toggle('compared', shown);
    element('stage').style.setProperty('--wipe', element('wipe').value);
  }
  // The values of the lesson's setting that were tried, in ascending order, with their errors.
  show_tried(key, errors) {
    const number = value => value === 'auto' ? this.lab.ratios[[this.lab.key, this.lab.state.method]] : Number(value);
    const least = Math.min(...errors.map(([, error]) => error)), select = element(`setting-${key}`);
    element('tried').replaceChildren();
    append_row(element('tried'), [select.getAttribute('aria-label'), 'error']);
    for (const [value, error] of errors.sort(([a], [b]) => number(a) - number(b)))
      append_row(element('tried'), [[...select.options].find(option => option.value === value).text,
        number_text(error, 3) + (error === least ? ', the least' : '')]);
  }
  show_finding(paragraphs) {
    element('lesson-finding').replaceChildren();
    for (const text of paragraphs)
      write_text(append_element(element('lesson-finding'), 'p', ''), text);
    element('lesson-status').textContent = '';
    if (this.lab.lesson().setting)
      element('lesson-try').append(this.rows.get(this.lab.lesson().setting));
    element('plot').scrollIntoView({ block: 'nearest' });
    element('lesson-finding').scrollIntoView({ block: 'nearest' });
  }
}
