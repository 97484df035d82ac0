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

// Commands that fail say so; the next one runs.
async function own_rooms(page) {
  const open = (name, text) => page.run(`laboratory.open([new File([${JSON.stringify(text)}], '${name}')])`);
  await open('bad.obj', 'v 0 0 0\nf 1 2 3\n');
  tell(await page.until(`${find('lab-message')}.textContent.includes('bad.obj:2')`), 'a file that cannot be read is told');
  await open('box.obj', fs.readFileSync('scenes/furnace.obj', 'utf8').replace(/^mtllib.*/m, ''));
  tell(await page.until(`${find('lab-message')}.textContent.includes('emitter')`, 30), 'a room without light is told');
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
    for (const look of [same_bytes, links, errors_compared, own_rooms, lessons, many_runs])
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
