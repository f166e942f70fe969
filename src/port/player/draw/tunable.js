// Tunable values in the code, and their positions when the code changes.

/** Minimum and maximum of each component of a tunable value. @param {TunableData} tunable */
function limits({ min, max, value }) {
  return [value.map((v, i) => Math.min(min[i], v)), value.map((v, i) => Math.max(max[i], v))];
}

/** A number as a GLSL float literal. @param {number} value */
function floatText(value) {
  const text = String(Number(value.toPrecision(6)));
  return /[.e]/.test(text) ? text : `${text}.0`;
}

/** @type {Record<string, (value: number) => string>} a literal, by type */
const LITERALS = { float: floatText, int: String, uint: (value) => `${value}u`, bool: (value) => String(value > 0) };

/**
 * Writes a value into the text.
 * @param {ProjectData} project @param {TunableData} tunable @param {number[]} value
 */
function setNumber(project, tunable, value) {
  const [min, max] = limits(tunable);
  const isFloat = tunable.scalar === 'float';
  const numbers = tunable.value.map((old, i) => {
    const kept = Math.min(Math.max(value[i] ?? old, min[i]), max[i]);
    return isFloat ? kept : Math.round(kept);
  });
  const text = numbers.map(LITERALS[tunable.scalar]).join(', ');
  const file = project.files[tunable.file];
  const before = file.text.slice(0, tunable.start);
  // The limits do not change, so every value that was allowed remains allowed.
  Object.assign(tunable, { value: numbers, min, max });
  changeText(project, tunable.file, before + text + file.text.slice(tunable.end));
}

/**
 * Sets the tunable values of a name. Returns whether there are any.
 * @param {ProjectData} project @param {string} name @param {number | boolean | (number | boolean)[]} value
 */
function setTunables(project, name, value) {
  const all = project.tunables.filter((t) => t.name === name);
  const numbers = [value].flat();
  const isFit = numbers.every((v) => typeof v === 'boolean' || (typeof v === 'number' && !Number.isNaN(v)));
  if (!isFit) throw new TypeError(`${name} must be a number, a boolean or an array of numbers`);
  for (const tunable of all) setNumber(project, tunable, numbers.map(Number));
  return all.length > 0;
}

const LITERAL = '(?:true|false|(?:[+-]\\s*)?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?[uU]?)';
const NUMBERS = new RegExp(`^${LITERAL}(?:\\s*,\\s*${LITERAL})*`);

/** The numbers in the text of a value; null if it has another number of components. @param {string} text @param {number} count */
function numbersOf(text, count) {
  const numbers = text.split(',').map((part) => (part.trim() === 'true' ? 1 : parseFloat(part.replace(/\s|false/g, '') || '0')));
  if (numbers.length === count) return numbers;
  return numbers.length === 1 ? Array(count).fill(numbers[0]) : null;
}

/**
 * Moves the tunables to the new positions of their values when a text is replaced. Tunables without a
 * value are removed.
 * @param {ProjectData} project @param {number} index of the file @param {string} text
 */
function moveNumbers(project, index, text) {
  const file = project.files[index];
  const [from, to] = changed(file.text, text);
  const shift = text.length - file.text.length;
  project.tunables = project.tunables.filter((tunable) => {
    if (tunable.file !== index || tunable.end < from) return true;
    if (from >= tunable.start && to <= tunable.end) {
      const found = NUMBERS.exec(text.slice(tunable.start, tunable.end + shift));
      const numbers = found && numbersOf(found[0], tunable.value.length);
      if (numbers) {
        tunable.end = tunable.start + found[0].length;
        tunable.value = numbers;
        return true;
      }
    }
    tunable.start += shift;
    tunable.end += shift;
    return to <= tunable.start - shift;
  });
}

Object.assign(parts, { setTunables, moveNumbers });
