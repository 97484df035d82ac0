'use strict';
// The settings of a run: a table of the program's options that the laboratory offers. From it come the controls, the words of
// the command and the link of the page.

// Each has a key, its option, a title, its values as [word, text], or words alone, the usual one, and the methods that it
// applies to. panel.html explains them.
const walks = ['first-shot', 'extended', 'global'];
const settings = [
  { key: 'method', option: '--method', title: 'Method', values: [
      ['local', 'local Monte Carlo'], ['global', 'global lines'], ['first-shot', 'first shot'], ['extended', 'extended first shot'],
      ['reuse', 'line reuse'], ['jacobi', 'stochastic Jacobi'], 'transillumination', ['gathering', 'gathering walk']], usual: 'extended' },
  { key: 'sequence', option: '--sequence', title: 'Lines from', values: [
      ['random', 'random numbers'], ['sobol', 'Sobol'], ['halton', 'Halton'], ['sobol-owen', 'Sobol, scrambled']], usual: 'sobol' },
  { key: 'pairing', option: '--pairing', title: 'A line takes', values: [['4d', 'one 4-D item'], ['2d', 'two 2-D items']],
    usual: '4d', of: walks, more: true },
  { key: 'order', option: '--line-order', title: 'Order', values: ['shuffled', ['sequence', 'of the sequence']],
    usual: 'shuffled', of: walks, more: true },
  { key: 'bidirectional', option: '--bidirectional', title: 'Power goes', values: [['yes', 'both ways'], ['no', 'one way']],
    usual: 'yes', of: walks, more: true },
  { key: 'ratio', option: '--ratio', title: 'Ratio', values: [['auto', 'by (3)'], '0.05', '0.1', '0.2', '0.5', '1', '2', '4', '8'],
    usual: 'auto', of: ['first-shot', 'extended'], more: true },
  { key: 'threshold', option: '--threshold', title: 'Threshold', values: [
      ['auto', 'by (4)'], ['0', '0: shoot all'], ['0.01', '0.01 W/m²'], ['0.1', '0.1 W/m²'], ['1', '1 W/m²']],
    usual: 'auto', of: ['extended'], more: true },
  { key: 'steps', option: '--steps', title: 'Passes at most', values: ['1', '2', '3', '4', '6', ['1000', 'all']],
    usual: '1000', of: ['extended'], more: true },
  { key: 'patches', option: '--patches', title: 'Patches', values: ['500', ['1000', '1,000'], ['3000', '3,000'], ['10000', '10,000']],
    usual: '3000', more: true },
];
for (const setting of settings)
  setting.values = new Map(setting.values.map(value => [value].flat()).map(([word, text = word]) => [word, text]));

const usual_settings = () => Object.fromEntries(settings.map(({ key, usual }) => [key, usual]));
const applies = (setting, method) => !setting.of || setting.of.includes(method);

// The name of a run by its state: what differs from another one beside it; alone, its method and sequence.
function run_name(state, other) {
  const value = (setting, of) => applies(setting, of.method) ? of[setting.key] : setting.usual;
  const named = settings.filter(setting => other ? value(setting, state) !== value(setting, other) : !setting.more);
  const texts = named.map(setting => `${setting.more ? `${setting.title} ` : ''}${setting.values.get(value(setting, state))}`);
  return named.length > 0 ? texts.join(', ') : run_name(state);
}

// The words of the command that solves the room with N lines, a power of two.
function command_words(state, lines) {
  const words = ['solve', state.scene];
  for (const setting of settings)
    if (applies(setting, state.method) && (state[setting.key] !== setting.usual || setting.key === 'method' || setting.key === 'patches'))
      words.push(setting.option, state[setting.key]);
  words.push('--lines', `2^${Math.log2(lines)}`);
  return words;
}

// A link holds what differs from the usual settings.
function link_of(state) {
  const words = Object.entries(state).filter(([key, value]) => String(value) !== String(usual_state()[key]));
  return words.map(([key, value]) => `${key}=${encodeURIComponent(value)}`).join('&');
}
function state_of(link) {
  const state = usual_state();
  for (const [key, value] of new URLSearchParams(link))
    if (key in state)
      state[key] = typeof state[key] === 'number' ? Number(value) : value;
  return state;
}
const usual_state = () => ({ scene: '5cubes', lesson: '', size: 16, ...usual_settings() });
