// Parts of the player that need no page.
import assert from 'node:assert/strict';
import { load } from './player.js';

function logs() {
  const { mapErrors, readLog } = load(['draw/gl.js', 'draw/log.js'], ['mapErrors', 'readLog']);
  const said = (log) => readLog(log).map((e) => [e.line, e.token, e.words]);
  assert.deepEqual(said("ERROR: 0:12: 'x' : undeclared identifier\nERROR: 0:13: '' : syntax error\n\0"), [
    [12, 'x', 'undeclared identifier'],
    [13, '', 'syntax error'],
  ]);
  assert.deepEqual(said("ERROR: 0:4: '\n' : unexpected token\nERROR: 0:5: '}' : syntax error\n"), [
    [4, '\n', 'unexpected token'],
    [5, '}', 'syntax error'],
  ], 'a token may be a line break');
  assert.deepEqual(said("ERROR: 0:4: ''' : invalid character\nERROR: 0:4: '' :  a: 'b' : c\n"), [
    [4, "'", 'invalid character'],
    [4, '', "a: 'b' : c"],
  ], 'quotes and colons too');
  assert.deepEqual(said('ERROR: Function f() called by main() is undefined\n'), [
    [0, '', 'Function f() called by main() is undefined'],
  ], 'the position may be missing');
  const files = [{ name: '', text: 'one\ntwo\n', hidden: true }, { name: 'Common', text: 'a', hidden: false }, { name: 'Image', text: 'b\nc', hidden: false }];
  const places = mapErrors("WARNING: 0:1: 'w' : no\nERROR: 0:3: 'a' : bad\nERROR: 0:5: '\n' : worse\nERROR: 0:1: 'x' : ours\n", files, 'Image');
  assert.deepEqual(places.map((e) => [e.pass, e.line, e.text]), [
    ['Common', 1, "'a' : bad"],
    ['Image', 2, 'end of line : worse'],
    ['Image', 0, "'x' : ours"],
  ]);
  assert.deepEqual(mapErrors('the link failed', files, 'Image'), [{ pass: 'Image', line: 0, text: 'the link failed' }]);
}

/** A project with one text that contains one tunable value. */
function tuned(text, literals, scalar, value) {
  const start = text.indexOf(literals);
  const ends = { min: value.map(() => 0), max: value.map(() => 8) };
  const tunable = { name: 'N', label: '', kind: '', scalar, value, ...ends, file: 0, start, end: start + literals.length };
  return { files: [{ name: '', text, hidden: false }], tunables: [tunable] };
}

function tunables() {
  const { changeText, setNumber } = load(['parts.js', 'draw/tunable.js', 'draw/programs.js'], ['changeText', 'setNumber']);
  const found = (project) => project.tunables.map((t) => [project.files[0].text.slice(t.start, t.end), ...t.value]);
  const moved = (text, literals, scalar, value, after) => {
    const project = tuned(text, literals, scalar, value);
    changeText(project, 0, after);
    return found(project);
  };
  for (const [after, expected] of [
    ['x a = 1.5; b', [['1.5', 1.5]]],
    ['a = 1.5; bcd', [['1.5', 1.5]]],
    ['a = 2.75; b', [['2.75', 2.75]]],
    ['a = 11.5; b', [['11.5', 11.5]]],
    ['a =  1.5; b', [['1.5', 1.5]]],
    ['a = x; b', []],
    ['', []],
  ]) {
    assert.deepEqual(moved('a = 1.5; b', '1.5', 'float', [1.5], after), expected, after);
  }
  for (const [after, expected] of [
    ['vec3(1., 2.5, 3.)', [['1., 2.5, 3.', 1, 2.5, 3]]],
    ['vec3(-1., 2., 3.)', [['-1., 2., 3.', -1, 2, 3]]],
    ['vec3(1., 3.)', []],
    ['vec3(4.)', [['4.', 4, 4, 4]]],
    ['x vec3(1., 2., 3.)', [['1., 2., 3.', 1, 2, 3]]],
  ]) {
    assert.deepEqual(moved('vec3(1., 2., 3.)', '1., 2., 3.', 'float', [1, 2, 3], after), expected, after);
  }
  assert.deepEqual(moved('b = true;', 'true', 'bool', [1], 'b = false;'), [['false', 0]]);
  const set = (text, literals, scalar, value, written) => {
    const project = tuned(text, literals, scalar, value);
    setNumber(project, project.tunables[0], written);
    return project.files[0].text;
  };
  for (const [value, written] of [[1e9, '8.0'], [-1, '0.0'], [2.25, '2.25'], [1.5, '1.5']]) {
    assert.equal(set('a = 1.5; b', '1.5', 'float', [1.5], [value]), `a = ${written}; b`);
  }
  assert.equal(set('N 4 x', '4', 'int', [4], [6.6]), 'N 7 x');
  assert.equal(set('N = 4u;', '4u', 'uint', [4], [5]), 'N = 5u;');
  assert.equal(set('N = true;', 'true', 'bool', [1], [0]), 'N = false;');
  assert.equal(set('vec3(.5)', '.5', 'float', [0.5, 0.5, 0.5], [1, 0.25, 0]), 'vec3(1.0, 0.25, 0.0)');
}

function clock() {
  const { Clock } = load(['clock.js'], ['Clock']);
  const at = new Clock();
  assert.throws(() => at.seek(NaN), TypeError);
  assert.throws(() => at.seek('1'), TypeError);
  at.time = 1;
  assert.throws(() => at.seek(NaN), TypeError);
  assert.equal(at.time, 1, 'an invalid time changes nothing');
  at.seek(-1);
  assert.equal(at.time, 0);
}

/** A tab that slept does not lose its simulation; frames that always take long are not sleep. */
function gaps() {
  const { Clock } = load(['clock.js'], ['Clock']);
  const at = new Clock();
  at.tick();
  at.last -= 16;
  at.tick();
  const before = at.time;
  at.last -= 600e3;
  assert.equal(at.tick().delta, 1 / 60);
  assert.ok(at.time - before < 1, `${at.time - before} s`);
  at.usual = 0.016;
  const passed = [1, 2, 3].map(() => {
    at.last -= 3000;
    return at.tick().delta >= 3;
  });
  assert.deepEqual(passed, [false, true, true]);
}

export const unitTests = [
  { name: 'unit: pauses between frames do not advance the simulation', run: gaps },
  { name: "unit: the compiler's log is parsed", run: logs },
  { name: 'unit: tunable numbers move with the text', run: tunables },
  { name: 'unit: invalid times are refused', run: clock },
];
