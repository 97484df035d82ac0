'use strict';
// The laboratory in a real browser: prints a line for each thing that holds ("ok ...") or not ("FAILED ...").
// usage: node lab.js chromium|firefox LAB.html NATIVE_FOLDER PICTURES
// NATIVE_FOLDER holds what the program itself wrote: NAME.csv and NAME.png for each NAME.words, the words of its command.

const fs = require('fs'), path = require('path');
const { open_page } = require('./drive.js');
const [, , browser, lab, native, pictures] = process.argv;
const url = `file://${path.resolve(lab)}`;
const done = '!laboratory.job && laboratory.run.points.length';
const find = id => `document.getElementById('${id}')`;

function tell(ok, name, note = '') { console.log(`${ok ? 'ok' : 'FAILED'} ${name} ${note}`); }

async function first_picture(page) {
  tell(await page.until('window.multipath && window.multipath.ready'), 'a room is shown',
    `after ${Math.round(await page.run('window.multipath.ready'))} ms`);
  tell(await page.run('new Set(new Uint32Array(window.multipath.picture().bytes.buffer)).size') > 100, 'the picture shows something');
}

// The same options give the same bytes as the program itself.
async function same_bytes(page) {
  for (const file of fs.readdirSync(native).filter(name => name.endsWith('.words'))) {
    const name = file.replace('.words', ''), words = fs.readFileSync(path.join(native, file), 'utf8').trim().split('\n');
    const found = await page.run(`laboratory.solver.run({ words: ${JSON.stringify(words)}, files: laboratory.bundled,
      wanted: ['${name}.csv', '${name}.png'] }).done.then(({ files }) => [...files].map(([name, bytes]) => [name, [...bytes]]))`);
    const same = found.length === 2 && found.every(([file, bytes]) => Buffer.from(bytes).equals(fs.readFileSync(path.join(native, file))));
    tell(same, `the bytes of the program by ${name}`);
  }
}

// The error of the curve is that of the program's compare.
async function errors_compared(page) {
  const table = words => `laboratory.solver.run({ words: [...${words}, '-t', '1', '-q', '-o', 'x.csv'], files: laboratory.bundled,
    wanted: ['x.csv'] }).done.then(({ files }) => files.get('x.csv'))`;
  const { error, report } = await page.run(`(async () => {
    const { lines, error } = laboratory.run.points[laboratory.run.points.length - 1];
    const files = new Map([['a.csv', await ${table('laboratory.words(lines)')}], ['b.csv', await ${table('laboratory.reference_words()')}]]);
    return { error, report: (await laboratory.solver.run({ words: ['compare', 'a.csv', 'b.csv', '--json'], files }).done).text };
  })()`);
  const right = JSON.parse(report).relative_mean_square_error;
  tell(Math.abs(error - right) < 1e-4 * right, 'the error is that of compare', `${error} ${right}`);
}

// Every lesson shows what it says, driven by its own buttons.
async function lessons(page) {
  for (const { key, right } of await page.run('laboratory.lessons.map(({ key, right }) => ({ key, right }))')) {
    await page.run(`(${find('lesson-choice')}.value = '${key}', ${find('lesson-choice')}.dispatchEvent(new Event('change')))`);
    await page.until(done);
    await page.run(`${find('lesson-answers')}.children[${right}].click()`);
    const told = await page.until(`${find('lesson-finding')}.textContent`, 600);
    const finding = await page.run(`${find('lesson-finding')}.textContent`);
    tell(told && await page.run('laboratory.confirmed') && finding.startsWith('Right.'), `lesson ${key}:`, finding);
    if (pictures)
      await page.picture(path.join(pictures, `lesson-${key}.png`));
  }
}

// A link holds the state; a reference is measured against; slopes are those of the methods.
async function links(page) {
  await page.run("location.hash = 'scene=cornell&method=local&sequence=random&patches=1000&size=15'");
  await page.until("laboratory.state.scene === 'cornell'");
  tell(await page.until(done), 'a link starts its run');
  const slope = await page.run('fitted(laboratory.run.points).slope');
  tell(slope > -1.25 && slope < -0.75, 'random particles have slope -1', slope.toFixed(2));
  tell((await page.run(`${find('command')}.textContent`)).includes('solve cornell.obj --method local --sequence random'), 'the command is shown');
}

// A long command reports its progress, at most twenty times a second; one that is stopped is heard of no more.
async function progress_told(page) {
  const { shares, steps, said } = await page.run(`(async () => {
    const shares = [], times = [], words = command_words({ ...state_of(''), scene: '5cubes.obj', method: 'local' }, 2 ** 24);
    const { code } = await laboratory.solve(words, share => { shares.push(share); times.push(performance.now()); }).done;
    const job = laboratory.solve(words, () => { said++; if (said === 2) { job.stop(); fulfil(); } });
    let said = 0, fulfil;
    const ended = job.done.then(() => { said = 1000; });
    await new Promise(done => { fulfil = done; });
    await Promise.race([ended, laboratory.solve(laboratory.words(256)).done]);
    return { shares: code === 0 ? shares : [], steps: Math.ceil((times[times.length - 1] - times[0]) / 50) + 1, said };
  })()`);
  const rising = shares.every((share, k) => share <= 1 && (k === 0 || share >= shares[k - 1]));
  tell(shares.length >= 3 && rising && shares[0] < 0.5 && shares[shares.length - 1] > 0.8, 'progress is told and rises',
    `${shares.length} times, from ${shares[0]} to ${shares[shares.length - 1]}`);
  tell(shares.length <= 1.5 * steps + 2, 'not more than twenty times a second', `${shares.length} times in ${steps} steps of 50 ms`);
  tell(said === 2, 'a command that is stopped says no more', said);
  await page.run("(laboratory.restart({ scene: '5cubes', method: 'local', size: 24 }), 0)");
  await page.until("laboratory.job && laboratory.next >= 2 ** 20");
  tell(await page.run(`(${find('start')}.click(), !laboratory.job && ${find('start')}.textContent === 'Go on')`), 'stop ends a run at once');
  await page.run("(laboratory.restart({ size: 9 }), 0)");
  await page.until('!laboratory.job');
  const label = await page.run(`(text => (${find('start')}.click(), text))(${find('start')}.textContent)`);
  await page.until('!laboratory.job');
  tell(label === 'Double N' && await page.run('laboratory.state.size === 10 && laboratory.run.results.length === 3'), 'a complete run is continued with twice as many lines', label);
  await page.until(done);
  const scale = await page.run('multipath.tone.scale');
  await page.run("(laboratory.restart({ method: 'global', size: 12 }), 0)");
  await page.until('!laboratory.job');
  tell(await page.run('multipath.tone.scale') === scale, 'all results of a room are seen with the exposure of the reference', scale);
}

// Everything can be reached by keyboard and has a name; two fingers move nearer; curves differ by more than colour.
async function controls_reached(page) {
  const { nameless, unreached } = await page.run(`(() => {
    const name = c => c.getAttribute('aria-label') || c.textContent.trim() || [...(c.labels || [])].map(l => l.textContent.trim()).join('');
    const controls = [...document.querySelectorAll('button, input, select, summary, canvas')].filter(c => !c.hidden);
    return { nameless: controls.filter(c => !name(c)).map(c => c.outerHTML), unreached: controls.filter(c => c.tabIndex < 0).map(c => c.id) };
  })()`);
  tell(nameless.length === 0 && unreached.length === 0, 'every control has a name and can be reached by keyboard', [...nameless, ...unreached]);
  const ratio = await page.run(`(() => {
    const canvas = ${find('view')}, box = canvas.getBoundingClientRect(), { camera } = multipath, before = camera.distance();
    canvas.setPointerCapture = () => {};
    const point = (type, id, x) => canvas.dispatchEvent(new PointerEvent(type, { pointerId: id, pointerType: 'touch', buttons: 1,
      clientX: box.left + x, clientY: box.top + 100, bubbles: true }));
    point('pointerdown', 11, 100), point('pointerdown', 12, 150), point('pointermove', 12, 175);
    point('pointerup', 11, 100), point('pointerup', 12, 175);
    return camera.distance() / before;
  })()`);
  tell(Math.abs(ratio - 50 / 75) < 1e-6, 'two fingers move nearer', ratio);
}

// Commands that fail say so; the next one runs.
async function own_rooms(page) {
  const open = (name, text) => page.run(`laboratory.open([new File([${JSON.stringify(text)}], '${name}')])`);
  await open('bad.obj', 'v 0 0 0\nf 1 2 3\n');
  tell(await page.until(`${find('lab-message')}.textContent.includes('bad.obj:2')`), 'a file that cannot be read is told');
  await open('box.obj', fs.readFileSync('scenes/furnace.obj', 'utf8').replace(/^mtllib.*/m, ''));
  tell(await page.until(`${find('lab-message')}.textContent.includes('emitter')`, 30), 'a room without light is told');
  await page.run("(laboratory.change({ method: 'reuse' }), 0)");
  const ratios = []; // of the light of the run to that of the reference
  for (const reflectance of ['0.2', '0.8']) { // the same name, another room
    await page.run(`laboratory.open([new File([${JSON.stringify(fs.readFileSync('scenes/cube.obj', 'utf8').replace(/^mtllib.*/m, 'mtllib box.mtl'))}], 'box.obj'),
      new File([${JSON.stringify(fs.readFileSync('scenes/cube.mtl', 'utf8'))}.replace(/^Kd.*$/gm, 'Kd ${reflectance} ${reflectance} ${reflectance}')], 'box.mtl')])`);
    await page.until(done);
    ratios.push(await page.run("((sum => sum(laboratory.run.quantities[0].values) / sum(laboratory.reference))(list => list.reduce((a, b) => a + b)))"));
  }
  tell(ratios.every(ratio => ratio > 0.7 && ratio < 1.3), 'a file that has changed is measured anew', ratios);
}

const choose = (id, value) => `(${find(id)}.value = '${value}', ${find(id)}.dispatchEvent(new Event('change')))`;
const text_of = id => `${find(id)}.innerText`;

// Free play after a lesson: its finding stays that of its own two runs, and a curve that cannot be compared goes.
async function lesson_left(page) {
  await page.run("(laboratory.open([new File(['v 0 0 0'], 'x.obj')]), 0)"); // no reference is there
  await page.run(choose('lesson-choice', '08-ratio'));
  await page.run(`${find('lesson-answers')}.children[0].click()`); // at once: before anything is solved
  tell(await page.until(`${find('lesson-finding')}.textContent`), 'a hasty answer gets its finding, too');
  const finding = await page.run(text_of('lesson-finding'));
  const errors = await page.run("[laboratory.kept, laboratory.run].map(({ points }) => number_text(points[points.length - 1].error, 3))");
  tell(finding.startsWith('The right answer: “is clearly larger”.') && errors.every(error => finding.includes(error)) && finding.includes('5cubes'),
    'the finding names its room and the errors of both runs', finding);
  await page.run(choose('setting-ratio', '0.5'));
  await page.until(done);
  const names = await page.run(text_of('plot-text'));
  tell(/^A \S.* 0\.05: error [^]*\nB \S.* 0\.5: error /.test(names), 'the curves are named by what differs, A first', names);
  await page.run("(multipath.change({ selected: 300 }), 0)");
  const { table, values } = await page.run(`({ table: ${text_of('patch-rows')}, values: [laboratory.kept, laboratory.run].map(({ quantities }) =>
    colour_text([...quantities[0].values.subarray(900, 903)])) })`);
  tell(table.includes(`A: ${values[0]}\nB: ${values[1]}`), 'a patch shows the numbers of both halves', table);
  await page.run(choose('scene', 'cornell'));
  await page.until(done);
  tell(await page.run(text_of('lesson-finding')) === finding, 'free play leaves the finding of a lesson as it was');
  tell(await page.run(`laboratory.kept === null && ${find('plot-text')}.children.length === 2 && ${find('lab-message')}.textContent.startsWith('A was')`),
    'the curve of another room is dropped, and told so');
  await page.run(choose('lesson-choice', '08-ratio'));
  await page.run(`${find('lesson-answers')}.children[0].click()`);
  await page.run(choose('setting-sequence', 'sobol'));
  await page.until(done);
  tell(await page.run(`!${find('lesson-finding')}.textContent && !${find('lesson-answers')}.children[0].disabled`), 'a change during its runs opens the question again');
  await page.run(choose('lesson-choice', ''));
}

// The formulas that texts name are explained, with their values in this room.
async function formulas_explained(page) {
  const unknown = await page.run(`[...JSON.stringify([laboratory.lessons,
    [...document.querySelectorAll('option, [id^=note-]')].map(text => text.textContent)])
    .matchAll(/\\([A-Z]?\\d\\)/g)].map(([label]) => label).filter(label => !(label in JSON.parse(${find('formulas')}.textContent)))`);
  tell(unknown.length === 0, 'every label in lessons and settings has a formula', unknown);
  await page.run("(laboratory.restart({ ...state_of('size=12'), lesson: '' }), 0)");
  await page.until(done);
  // After the extended first shot f = 1 and R_s' = R_ave, both of which the page knows; the threshold is in the notes of the trace.
  const { by_3, by_4, ratio, note } = await page.run(`(({ all: { area, reflectance: r } }, [a, b, c]) => ({
    ratio: Math.sqrt(2 * area / (2 * (a * b + b * c + c * a)) * (1 - r * r) * (1 - r) / (r * r * (1 - r) + 2 * r ** 3)),
    by_3: ${find('setting-ratio')}.options[0].text, by_4: ${find('setting-threshold')}.options[0].text, note: multipath.trace.lines[0].note
  }))(multipath.room, multipath.room.box[1].map((x, k) => x - multipath.room.box[0][k]))`);
  tell(Math.abs(by_3.replace('by (3): ', '') - ratio) < 0.01, 'the value of (3) is that in this room', `${by_3} ${ratio}`);
  tell(by_4 === `by (4): ${/threshold, ([\d.]+) W/.exec(note)[1]} W/m²`, 'the value of (4) is that in this room', by_4);
  await page.run(choose('setting-method', 'first-shot'));
  await page.until(done); // here f is that of the lamps
  tell(Math.abs(await page.run(`Number(${find('setting-ratio')}.options[0].text.replace('by (3): ', ''))`) - 1.29) < 0.011, 'the first shot has its own value of (3)');
  await page.run(choose('setting-method', 'extended'));
  tell(await page.run(`${find('setting-ratio')}.options[0].text`) === by_3, 'which is not taken for that of the extended one');
  await page.until(done);
  const shown = await page.run(`(tip => { tip.focus(); tip.blur(); tip.dispatchEvent(new Event('focus')); return tip.textContent; })(${find('setting-ratio')}.parentNode.firstChild)`);
  tell(shown.includes('√') && shown.includes(by_3.replace('by (3): ', '; here ')), 'the setting shows the formula and its value', shown);
  const ratios = await page.run(`[...${find('setting-ratio')}.options].slice(1).map(({ value }) => Number(value))`);
  tell(ratios.every((ratio, k) => k === 0 || ratio > ratios[k - 1]), 'the choices of the ratio ascend', ratios);
}

// A lesson with a setting lists the values that were tried, with the errors of complete runs only.
async function values_tried(page) {
  await page.run(choose('lesson-choice', '08-ratio'));
  await page.until(done);
  tell(await page.run(`${find('tried')}.rows.length === 0 && ${find('lesson-status')}.textContent.includes('both runs')`), 'a lesson waits for an answer');
  await page.run(`${find('lesson-answers')}.children[1].click()`);
  await page.until(`${find('lesson-finding')}.textContent`);
  await page.run(choose('setting-ratio', '0.5'));
  await page.until(done);
  const { rows, error } = await page.run(`({ rows: [...${find('tried')}.rows].slice(1).map(({ cells: [value, error] }) => [value.innerText, error.innerText]),
    error: number_text(laboratory.run.points[laboratory.run.points.length - 1].error, 3) })`);
  tell(rows.length === 3 && rows[0][0] === '0.05' && rows[1].join() === `0.5,${error}` && /^by \(3\): 1\.[23]/.test(rows[2][0]) && rows[2][1].includes('least'),
    'the ratios that were tried are listed, ascending', rows.join('; '));
  await page.run(choose('lesson-choice', ''));
}

// What lights a patch is told of this patch, this room and this run.
async function lights_told(page) {
  const told = `[${find('patch')}.lastElementChild.rows.length, multipath.rays.length]`;
  for (const [change, name] of [['multipath.change({ selected: 301 })', 'patch'], ["laboratory.restart({ method: 'local' })", 'run'],
                                ["laboratory.restart({ scene: '4chairs' })", 'room']]) {
    await page.run(`(multipath.change({ selected: 300 }), ${find('patch')}.querySelector('button').click())`);
    const before = await page.run(told);
    await page.run(`(${change}, 0)`);
    await page.until('!laboratory.job');
    const after = await page.run(told);
    tell(Math.min(...before) > 0 && Math.max(...after) === 0, `who lights a patch ends with another ${name}`, `${before} ${after}`);
  }
}

// A patch is marked, and can be clicked, only while its surface is drawn.
async function marks_seen(page) {
  await page.run("(laboratory.restart({ scene: '5cubes', method: 'extended', size: 8 }), 0)");
  await page.until(done);
  const { wrong, picked, marks } = await page.run(`(() => {
    const { room, camera } = multipath;
    multipath.go_outside();
    const picked = [], box = ${find('view')}.getBoundingClientRect(), marks = [];
    for (let n = 0; n < 400; ++n) {
      const patch = multipath.patch_at(box.left + (n % 20 + 0.5) * box.width / 20, box.top + (Math.floor(n / 20) + 0.5) * box.height / 20);
      if (patch !== null)
        picked.push(patch);
    }
    const wrong = picked.filter(patch => !room.faces(patch, camera.eye)).length;
    for (const eye of [camera.eye, room.box[0].map((x, k) => 0.5 * (x + room.box[1][k]))])
      for (let patch = 0; patch < room.patch_count; patch += 50) {
        multipath.state.selected = patch;
        camera.eye = eye;
        const s = room.surface_of(patch), u = room.edge_u(s), v = room.edge_v(s), from = eye.map((x, k) => x - room.origin(s)[k]);
        const front = from[0] * (u[1] * v[2] - u[2] * v[1]) + from[1] * (u[2] * v[0] - u[0] * v[2]) + from[2] * (u[0] * v[1] - u[1] * v[0]) > 0;
        marks.push((multipath.marks().length > 0) === front);
      }
    multipath.state.selected = null;
    multipath.go_home();
    return { picked: picked.length, marks, wrong };
  })()`);
  tell(picked > 20 && wrong === 0, 'from outside a click picks what is drawn', `${picked} picked, ${wrong} wrong`);
  tell(marks.every(Boolean), 'a patch is marked while its front is seen', `${marks.filter(x => !x).length} of ${marks.length} wrong`);
}

// Memory after many runs and rooms.
async function many_runs(page) {
  const memory = async () => (await page.run("performance.memory ? performance.memory.usedJSHeapSize : 0")) / 2 ** 20;
  await page.run("laboratory.restart({ scene: '5cubes', size: 8, method: 'extended', patches: '500' })");
  await page.until(done);
  const before = await memory();
  for (let run = 0; run < 100; ++run) {
    await page.run(`laboratory.restart({ scene: '${run % 2 ? '5cubes' : 'cornell'}', size: 8 })`);
    await page.until('!laboratory.job');
  }
  const after = await memory();
  tell(after < before + 30, '100 runs and rooms leave no memory behind', `${before.toFixed(0)} to ${after.toFixed(0)} MB`);
}

async function small_screen() {
  for (const [width, height] of [[390, 844], [1366, 768], [1920, 1080]]) {
    const page = await open_page(browser, `${url}#size=10`, width, height);
    await page.until(done);
    tell(await page.run('document.scrollingElement.scrollWidth <= innerWidth'), `nothing is cut off at ${width} pixels`);
    if (width < 500) {
      await controls_reached(page);
      const open = () => page.run(`[...document.querySelectorAll('aside')].map(aside =>
        [aside.querySelector('header + div').hidden, aside.querySelector('header button').textContent].join())`);
      await page.run(`${find('fold')}.click()`);
      const seen = [await open()];
      await page.run(`${find('lab-fold')}.click()`);
      seen.push(await open());
      tell(seen.join(' ') === 'true,Laboratory,false,Hide false,Hide,true,Controls', 'one panel at a time is open on a telephone', seen.join(' '));
    }
    if (pictures)
      await page.picture(path.join(pictures, `lab-${width}.png`));
    page.close();
  }
}

(async () => {
  const page = await open_page(browser, `${url}#size=12`, 1366, 768);
  try {
    await first_picture(page);
    await page.until(done);
    for (const look of [same_bytes, links, errors_compared, progress_told, controls_reached, own_rooms, lesson_left, formulas_explained, values_tried, lights_told, marks_seen, lessons, many_runs])
      await look(page);
    tell(page.said.length === 0, 'no error on the console', page.said.join('; '));
  } finally {
    page.close();
  }
  if (browser === 'chromium')
    await small_screen();
})().catch(error => {
  console.log(`FAILED ${error}`);
  process.exitCode = 1;
});
