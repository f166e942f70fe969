// Tunable numbers in the code, and their positions when the code changes.

/** Minimum and maximum of a tunable number. @param {TunableData} tunable */
function limits(tunable) {
  return [Math.min(tunable.min, tunable.value), Math.max(tunable.max, tunable.value)];
}

/** A number as a GLSL float literal. @param {number} value */
function floatText(value) {
  const text = String(Number(value.toPrecision(6)));
  return /[.e]/.test(text) ? text : `${text}.0`;
}

/**
 * Writes a value into the text.
 * @param {ProjectData} project @param {TunableData} tunable @param {number} value
 */
function setNumber(project, tunable, value) {
  const [least, most] = limits(tunable);
  const kept = Math.min(Math.max(value, least), most);
  const number = tunable.integer ? Math.round(kept) : kept;
  const file = project.files[tunable.file];
  const text = tunable.integer ? String(number) : floatText(number);
  const before = file.text.slice(0, tunable.start);
  // The limits do not change, so every value that was allowed remains allowed.
  Object.assign(tunable, { value: number, min: least, max: most });
  changeText(project, tunable.file, before + text + file.text.slice(tunable.end));
}

const NUMBER = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/;

/**
 * Moves the tunables to the new positions of their numbers when a text is replaced. Tunables without a
 * number are removed.
 * @param {ProjectData} project @param {number} index of the file @param {string} text
 */
function moveNumbers(project, index, text) {
  const file = project.files[index];
  const [from, to] = changed(file.text, text);
  const shift = text.length - file.text.length;
  project.tunables = project.tunables.filter((tunable) => {
    if (tunable.file !== index || tunable.end < from) return true;
    const number = NUMBER.exec(text.slice(tunable.start, tunable.end + shift));
    if (number && from >= tunable.start && to <= tunable.end) {
      tunable.end = tunable.start + number[0].length;
      tunable.value = Number(number[0]);
      return true;
    }
    tunable.start += shift;
    tunable.end += shift;
    return to <= tunable.start - shift;
  });
}

Object.assign(parts, { setNumber, moveNumbers });
