'use strict';
// Lessons: a text, a question, and one or two runs whose numbers answer it. docs/lab.md describes the files.

// The numbers that a lesson may name: "A.error" and "B.error" at the most lines, "A.slope", "B.slope", and "A/B", the ratio of
// the errors.
function lesson_numbers(runs) {
  const numbers = {};
  for (const [name, run] of Object.entries(runs)) {
    const fit = fitted(run.points), last = run.points[run.points.length - 1];
    Object.assign(numbers, { [`${name}.error`]: last?.error, [`${name}.slope`]: fit?.slope });
  }
  if (numbers['B.error'])
    numbers['A/B'] = numbers['A.error'] / numbers['B.error'];
  return numbers;
}

// The text with the numbers in place of their names in braces.
function filled_text(text, numbers) {
  return text.replace(/\{([^}]*)\}/g, (_, name) => numbers[name] === undefined ? '?' : number_text(numbers[name], 3));
}

// True if everything holds that a lesson expects: lists of a number, '<' or '>', and a number.
function holds(expected, numbers) {
  const value = x => typeof x === 'number' ? x : numbers[x];
  return expected.every(([a, relation, b]) => relation === '<' ? value(a) < value(b) : value(a) > value(b));
}
