// Numbers in the code that can be tuned, and where they are when the code changes.

/** The least and the most that a tunable number may be. @param {TunableData} tunable */
function limits(tunable) {
  return [Math.min(tunable.min, tunable.value), Math.max(tunable.max, tunable.value)];
}

/** A number as GLSL takes it for a float. @param {number} value */
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
  // Its limits stay where they are, so that every value that was allowed still is.
  Object.assign(tunable, { value: number, min: least, max: most });
  changeText(project, tunable.file, before + text + file.text.slice(tunable.end));
}

const NUMBER = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/;

/**
 * Puts another text into the place of one, and moves the tunables to where their numbers stand now.
 * One whose number is no longer there is dropped.
 * @param {ProjectData} project @param {number} index of the file @param {string} text
 */
function changeText(project, index, text) {
  const file = project.files[index];
  const [from, to] = changed(file.text, text);
  const shift = text.length - file.text.length;
  file.text = text;
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

/** What of a text another one replaces: where it begins, and where it ends. @param {string} before @param {string} after */
function changed(before, after) {
  const most = Math.min(before.length, after.length);
  let start = 0;
  while (start < most && before[start] === after[start]) start++;
  let tail = 0;
  while (tail < most - start && before[before.length - 1 - tail] === after[after.length - 1 - tail]) tail++;
  return [start, before.length - tail];
}
