'use strict';
// The laboratory: solves the room with more and more lines, shows each result, and measures its error against a reference.

class Laboratory {
  // `bundled`: the files of the bundled rooms, bytes by name.
  constructor(solver, bundled, lessons) {
    Object.assign(this, { solver, bundled, lessons });
    this.files = bundled; // those of the bundled rooms, or of the user's own
    this.curve = new Curve(element('plot'), element('plot-text'));
    this.run = null; // { state, key, results: [{ lines, values }], points, quantities }
    this.kept = null; // run A of a comparison
    this.queue = []; // runs of a lesson that are to follow
    this.tried = new Map(); // by values of the setting of a lesson: the errors with them
    this.ratios = {}; // those by (3) that were taken, by the key of the run and the method
    this.state = state_of('');
    this.controls = new LabControls(this);
    this.follow(location.hash.slice(1));
  }

  // Takes the state of a link.
  follow(link) {
    if (link === link_of(this.state) && this.run)
      return;
    Object.assign(this.state, state_of(link));
    if (!this.has_scene(this.state.scene))
      this.state.scene = usual_state().scene;
    this.predicted = undefined;
    this.controls.show_lesson(this.lesson());
    this.begin();
  }

  change(part) {
    Object.assign(this.state, part);
    history.replaceState(null, '', '#' + link_of(this.state));
    this.controls.refresh(this.state);
  }

  // A change by the user ends the runs of a lesson, whose question is open again.
  restart(part) {
    this.leave_lesson();
    this.change(part);
    this.begin();
  }
  leave_lesson() {
    if (this.predicted !== undefined)
      this.controls.show_lesson(this.lesson());
    this.predicted = undefined;
  }

  lesson() { return this.lessons.find(({ key }) => key === this.state.lesson); }

  // A lesson begins in the room of its first run, and waits for the prediction.
  choose_lesson(key) {
    this.clear();
    this.tried.clear();
    this.change({ ...state_of(this.lessons.find(lesson => lesson.key === key)?.runs[0] || ''), lesson: key });
    this.controls.show_lesson(this.lesson());
    this.viewer?.go_home();
    this.begin(key ? 9 : undefined);
  }

  // After a prediction the runs of the lesson follow each other.
  predict(number) {
    this.clear();
    this.controls.show_answer(number);
    this.predicted = number;
    this.follow_each_other(this.lesson().runs);
  }
  follow_each_other([link, ...rest]) {
    this.change({ ...state_of(link), lesson: this.state.lesson });
    this.begin();
    this.queue = rest;
  }
  has_scene(name) { return name === this.own_scene || this.bundled.has(`${name}.obj`); }
  room_files() { return this.state.scene === this.own_scene ? this.files : this.bundled; }
  scene_file() { return this.state.scene === this.own_scene ? this.own_scene : `${this.state.scene}.obj`; }
  words(lines) { return command_words({ ...this.state, scene: this.scene_file() }, lines); }

  command() {
    return ['multipath', ...this.words(2 ** this.state.size), '-o', 'room.png'].map(word =>
      /^[\w.,:=^\/-]+$/.test(word) ? word : `'${word}'`).join(' ');
  }

  // Starts from few lines, up to 2^size. The reference stays if only the method has changed.
  begin(size = this.state.size) {
    this.stop();
    this.queue = [];
    this.controls.refresh(this.state);
    const key = [this.state.scene, this.state.patches].join(), other_room = this.kept && this.kept.state.scene !== this.state.scene;
    if (other_room)
      this.kept = null;
    this.controls.show_message(other_room ? 'A was of another room and is dropped.' : '');
    if (key !== this.key) {
      this.key = key;
      this.reference = null;
      this.reference_job?.stop();
      this.reference_job = null;
    }
    this.run = { state: { ...this.state }, key, results: [], points: [], quantities: null };
    this.next = 256;
    this.show_curve();
    this.show_comparison();
    this.go_on(size);
  }

  get can_go_on() { return this.run && this.next <= 2 ** this.state.size; }
  resume() {
    if (this.job)
      return;
    if (!this.can_go_on)
      this.change({ size: Math.log2(this.next) });
    this.go_on(this.state.size);
  }
  stop() {
    this.job?.stop();
    this.job = null;
    this.controls.show_running(false);
  }

  // Solves with the next number of lines, and then with twice as many.
  async go_on(size) {
    const lines = this.next;
    const job = this.solve(this.words(lines), share => this.controls.show_progress(lines, share));
    this.job = job;
    this.controls.show_running(true);
    this.controls.show_progress(lines, 0);
    const { code, message, files } = await job.done, counts = /([\d,]+) local \+ ([\d,]+) global/.exec(message);
    if (this.job !== job) // stopped
      return;
    this.job = null;
    if (code === 0)
      this.next = 2 * lines;
    this.controls.show_running(false);
    if (code !== 0)
      return this.controls.show_message(message);
    if (counts && this.state.ratio === 'auto')
      this.ratios[[this.key, this.state.method]] = Number(counts[1].replaceAll(',', '')) / Number(counts[2].replaceAll(',', ''));
    this.take(lines, room_data(files.get('room.html')));
    this.controls.show_progress(lines, 1);
    if (this.next <= 2 ** size)
      this.go_on(size);
    else
      this.finish();
  }

  solve(words, progress) {
    return this.solver.run({ words: [...words, '--threads', '1', '-o', 'room.html'],
      files: this.room_files(), wanted: ['room.html'], progress });
  }

  // The run is complete: when it is measured, too, the next one of a lesson follows, or its finding.
  finish() {
    this.note_trial();
    if (this.predicted === undefined || !this.run.points.length)
      return;
    if (this.queue.length === 0)
      return this.tell_finding();
    this.kept = this.run;
    this.follow_each_other(this.queue);
  }

  // A run that differs from the last one of a lesson by the lesson's setting alone is listed with its error.
  note_trial() {
    const { setting, runs } = this.lesson() || {}, { state, points } = this.run;
    const plain = of => link_of({ ...of, lesson: '', [setting]: usual_state()[setting] });
    const last = points[points.length - 1];
    if (!setting || last?.lines !== 2 ** state.size || plain(state) !== plain(state_of(runs[runs.length - 1])))
      return;
    this.tried.set(state[setting], last.error);
    this.controls.show_tried(setting, [...this.tried]);
  }

  // It is told once: the numbers are those of the lesson's runs, whatever runs later.
  tell_finding() {
    const lesson = this.lesson(), runs = this.kept ? { A: this.kept, B: this.run } : { A: this.run };
    this.numbers = lesson_numbers(runs);
    this.confirmed = holds(lesson.expects, this.numbers);
    const verdict = this.predicted === lesson.right ? 'Right.' : `The right answer: “${lesson.answers[lesson.right]}”.`;
    const doubt = this.confirmed ? '' : ' (These runs do not show it: with more lines they should.)';
    const named = Object.entries(runs).map(([letter, run]) => `${letter}: ${this.run_name(run)}`).join('; ');
    this.controls.show_finding([`${verdict} ${filled_text(lesson.finding, this.numbers)}${doubt}`,
      `In ${this.state.scene} with ${grouped(2 ** this.state.size)} lines. ${named}.`]);
    this.predicted = undefined;
  }

  // Shows a result, which came with this many lines.
  take(lines, data) {
    if (this.reference)
      data.tone = this.tone; // so that all results are seen as bright as it is
    if (!this.viewer)
      this.viewer = start_viewer(data);
    else if (this.shown_key === this.key)
      this.viewer.show_light(data);
    else
      this.viewer.show(data);
    this.shown_key = this.key;
    this.run.quantities = this.viewer.quantities;
    this.run.results.push({ lines, values: this.run.quantities[0].values });
    this.measure(this.run);
    this.show_comparison();
    if (!this.reference_job) // after the first picture
      this.solve_reference(this.key);
  }

  // Scrambled lines: those of the sequence itself are among the lines of the runs, and would share their errors.
  reference_words() {
    return [...command_words({ ...usual_state(), patches: this.state.patches, scene: this.scene_file(), method: 'reuse',
      sequence: 'sobol-owen' }, 2 ** 22), '--seed', '1000'];
  }

  async solve_reference(key) {
    const job = this.solve(this.reference_words());
    this.reference_job = job;
    const { code, files } = await job.done;
    if (code !== 0 || key !== this.key)
      return;
    const { quantities, tone } = room_data(files.get('room.html'));
    this.reference = numbers_of(quantities[0].values);
    this.viewer.tone = this.tone = tone;
    this.viewer.request_draw();
    [this.kept, this.run].filter(run => run?.key === key).forEach(run => this.measure(run));
    if (!this.job && !this.can_go_on)
      this.finish();
  }

  // The errors of the results of this run so far.
  measure(run) {
    if (this.reference)
      run.points = run.results.map(({ lines, values }) =>
        ({ lines, error: relative_error(values, this.reference, this.viewer.room.areas) }));
    this.show_curve();
  }

  get compared() { return this.kept && this.kept !== this.run; }
  // What tells this run from that beside it.
  run_name(run) { return run_name(run.state, this.compared ? (run === this.run ? this.kept : this.run).state : null); }

  show_curve() {
    this.controls.show_values();
    const runs = this.compared ? [this.kept, this.run] : [this.run];
    this.curve.show(runs.map((run, k) => ({ points: run.points, name: this.run_name(run), letter: this.kept ? 'AB'[k] : '' })));
  }

  // Keeps this run as A. The next one is B.
  keep() {
    this.leave_lesson();
    this.kept = this.run;
    this.controls.show_message('Kept as A. Now change a setting.');
    this.show_comparison();
    this.show_curve();
  }
  clear() {
    this.leave_lesson();
    this.kept = null;
    this.show_comparison();
    this.show_curve();
  }

  show_comparison() {
    const on = this.compared && this.kept.key === this.key && Boolean(this.run.quantities);
    this.controls.show_comparison(this.compared, on);
    this.viewer?.compare(on ? this.kept.quantities : null, Number(element('wipe').value));
  }

  // Shows which surfaces light the selected patch, and some rays to them.
  show_lights() {
    const { viewer } = this, patch = viewer?.state.selected;
    if (patch === null || patch === undefined)
      return;
    const { surfaces, rays } = lights_of(patch, viewer.room, viewer.quantities[0].values), most = Math.max(...rays.map(ray => ray.light));
    viewer.show_rays(rays.map(({ from, to, light }) =>
      ({ from, to, width: 1.5, colour: [...line_ink.slice(0, 3), 0.15 + 0.85 * light / most] })));
    this.controls.show_lights(surfaces.map(({ surface, share }) => ({ name: viewer.room.surface_name(surface), share })));
  }

  // Saves an output of the program, made by the command of the last result.
  async save(name) {
    const job = this.solver.run({ words: [...this.words(this.next / 2), '--threads', '1', '-q', '-o', name],
      files: this.room_files(), wanted: [name] });
    const { code, message, files } = await job.done;
    if (code !== 0)
      return this.controls.show_message(message);
    const url = URL.createObjectURL(new Blob([files.get(name)]));
    save_as(name, url);
    setTimeout(() => URL.revokeObjectURL(url), 1000);
  }

  // A room of the user: an OBJ file and what belongs to it.
  async open(list) {
    const files = new Map(await Promise.all([...list].map(async file => [file.name, new Uint8Array(await file.arrayBuffer())])));
    const scene = [...files.keys()].find(name => /\.obj$/i.test(name));
    if (!scene)
      return this.controls.show_message('Open an OBJ file, with its MTL file and its textures.');
    this.files = files;
    this.own_scene = scene;
    Object.assign(element('own-scene'), { value: scene, textContent: scene, hidden: false });
    this.key = this.kept = null; // the file may be another one of the same name
    this.ratios = {};
    this.restart({ scene });
  }
}

// The data of the room in a page that the program wrote.
function room_data(bytes) {
  const page = new TextDecoder().decode(bytes), begin = '<script type="application/json" id="room">';
  const from = page.lastIndexOf(begin) + begin.length;
  return JSON.parse(page.slice(from, page.indexOf('</' + 'script>', from)));
}

async function start_laboratory() {
  const held = id => JSON.parse(element(id).textContent);
  const script = await unpacked(element('worker').textContent), program = await unpacked(element('program').textContent);
  const files = new Map(Object.entries(held('rooms')).map(([name, text]) => [name, new TextEncoder().encode(text)]));
  window.laboratory = new Laboratory(new Solver(program, script), files, held('lessons'));
}
start_laboratory();
