'use strict';
// Lines per second of the laboratory's program in chromium and in node, and of the program itself with SSE2, on one thread:
// millions, by the seconds that the program reports without those for outputs. All take turns; printed are medians, and the middle of the ratios.
// usage: node lab_rate.js PROGRAM LAB.html [ROUNDS [LINES]]     at the top of the sources

const { execFileSync } = require('child_process');
const fs = require('fs'), os = require('os'), path = require('path'), zlib = require('zlib');
const { open_page } = require('./drive.js');
const [, , program, lab, rounds = 7, line_count = '2^23'] = process.argv;
const room = 'scenes/5cubes.obj', files = [room, room.replace('obj', 'mtl')].map(name => [path.basename(name), fs.readFileSync(name)]);
const words = (method, scene) => ['solve', scene, '-m', method, '-n', line_count, '--patches', '3198', '--threads', '1', '--json', '-o', 'room.csv'];
const rate = ({ lines, seconds, seconds_outputs }) => lines / (seconds - seconds_outputs) / 1e6;
const median = list => list.sort((a, b) => a - b)[list.length >> 1];

// The worker of the page in node, which lacks what workers of browsers have.
function in_node() {
  const page = fs.readFileSync(lab, 'utf8');
  const held = id => zlib.gunzipSync(Buffer.from(new RegExp(`id="${id}">([^<]*)`).exec(page)[1], 'base64'));
  const module = new WebAssembly.Module(held('program')), script = held('worker').toString();
  Object.assign(globalThis, { self: globalThis, WorkerGlobalScope: Object, importScripts: () => {}, location: { href: '' } });
  const start = new Function('postMessage', `const process = undefined, require = undefined; let onmessage; ${script}; return onmessage;`);
  return method => new Promise(fulfil => {
    const run = start(message => { if ('code' in message) fulfil(message.text); });
    run({ data: { module, words: words(method, '5cubes.obj'), files, wanted: [] } });
  });
}

(async () => {
  const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'rate-'));
  const page = await open_page('chromium', `file://${path.resolve(lab)}#size=8`, 800, 600);
  await page.until('window.laboratory && !laboratory.job && laboratory.run.points.length');
  const node = in_node();
  const contestants = {
    native: method => execFileSync(path.resolve(program), words(method, path.resolve(room)), { env: { ...process.env, MULTIPATH_KERNELS: 'sse2' }, cwd: scratch, stdio: ['ignore', 'pipe', 'ignore'] }),
    chromium: method => page.run(`laboratory.solver.run({ words: ${JSON.stringify(words(method, '5cubes.obj'))}, files: laboratory.bundled }).done.then(({ text }) => text)`),
    node };
  for (const method of ['extended', 'reuse', 'local']) {
    const rates = Object.fromEntries(Object.keys(contestants).map(name => [name, []]));
    for (let round = 0; round < rounds; ++round)
      for (const [name, run] of Object.entries(contestants))
        rates[name].push(rate(JSON.parse(await run(method))));
    const ratio = name => median(rates[name].map((rate, k) => rate / rates.native[k])).toFixed(2);
    const [chromium, inside] = [ratio('chromium'), ratio('node')];
    console.log(method, ...Object.entries(rates).map(([name, list]) => `${name} ${median(list).toFixed(2)}`), `ratios: chromium ${chromium}, node ${inside}`);
  }
  page.close();
  fs.rmSync(scratch, { recursive: true });
})();
