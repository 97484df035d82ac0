'use strict';
// Pictures of the laboratory to look at: every lesson after its runs, on a telephone, a notebook and a large screen, in light and
// dark colours; or those of the documents.
// usage: node lab_looks.js LAB.html FOLDER            LESSON-WIDTH-COLOURS.png in FOLDER
//        node lab_looks.js LAB.html --documents DOCS  DOCS/readme/lab.png and DOCS/gallery/lesson.png

const path = require('path');
const { open_page } = require('./drive.js');
const [, , lab, folder, docs] = process.argv;
const telephone = [[390, 844, 'light'], [390, 844, 'dark']];
const others = [[1280, 800, 'light'], [1280, 800, 'dark'], [1920, 1080, 'light']];
const find = id => `document.getElementById('${id}')`;

const settle = page => page.until('!laboratory.job && laboratory.run.points.length && (!laboratory.queue || !laboratory.queue.length)', 300);
const colours = (page, value) => page.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value }] });
async function resize(page, [width, height, scheme]) {
  await colours(page, scheme);
  await page.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: width < 500 });
  await page.run('new Promise(done => setTimeout(done, 400))');
}

async function run_lesson(page, key, answer) {
  await page.run(`(${find('lesson-choice')}.value = '${key}', ${find('lesson-choice')}.dispatchEvent(new Event('change')))`);
  await settle(page);
  await page.run(`${find('lesson-answers')}.children[${answer}].click()`);
  await page.until(`${find('lesson-finding')}.textContent`, 600);
}

async function opened(width, height) {
  const page = await open_page('chromium', `file://${path.resolve(lab)}#size=8`, width, height);
  await page.until('window.laboratory && laboratory.run');
  await settle(page);
  return page;
}

(async () => {
  for (const sizes of folder === '--documents' ? [others] : [telephone, others]) {
    const page = await opened(sizes[0][0], sizes[0][1]);
    for (const { key, right } of await page.run('laboratory.lessons.map(({ key, right }) => ({ key, right }))')) {
      const name = folder !== '--documents' ? '' : { '03-ceiling': 'gallery/lesson', '10-reuse': 'readme/lab' }[key];
      if (name === undefined)
        continue;
      await resize(page, sizes[0]);
      await run_lesson(page, key, right);
      for (const size of name ? [sizes[0]] : sizes) {
        await resize(page, size);
        await page.picture(name ? path.join(docs, `${name}.png`) : path.join(folder, `${key}-${size[0]}-${size[2]}.png`));
      }
    }
    page.close();
  }
})();
