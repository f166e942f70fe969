// Errors in the code: those of the checker if they are available, otherwise those of the browser.

/**
 * @typedef {object} Problem
 * @property {string} place the position as text
 * @property {string} words
 * @property {string} rule its name; empty for errors of the browser
 * @property {number} file index of the text; -1 if it is not in the user's code
 * @property {Mark[]} marks the primary mark first
 * @property {string[]} notes
 */

/** The original texts, for which the findings of the checker are valid. @type {string[]} */
const checkedTexts = [];

/** @param {Player} player @param {FindingData} finding @returns {Problem} */
function problemOfFinding(player, finding) {
  const { file } = finding.labels[0];
  const { name, text } = player.project.files[file];
  const marks = finding.labels.filter((l) => l.file === file).map((l) => markOf(text, l));
  const { message, rule, notes } = finding;
  return { place: `${name}, line ${marks[0].line}`, words: message, rule, file, marks, notes };
}

/** @param {Player} player @param {ShaderError} error @returns {Problem} */
function problemOfError(player, error) {
  const file = error.line > 0 ? player.project.files.findIndex((f) => !f.hidden && f.name === error.pass) : -1;
  const marks = file < 0 ? [] : [markToken(player.project.files[file].text, error.line, error.token ?? '')];
  const place = error.line > 0 ? `${error.pass}, line ${error.line}` : error.pass;
  return { place, words: error.text, rule: '', file, marks, notes: [] };
}

/** All current errors. @param {Player} player @returns {Problem[]} */
function problems(player) {
  const { project } = player;
  const failures = player.renderer?.compiled.failures ?? [];
  /** @param {FindingData} finding */
  const holds = (finding) => finding.labels.every((l) => project.files[l.file].text === checkedTexts[l.file]);
  /** @type {Set<FindingData>} */
  const told = new Set();
  /** @type {ShaderError[]} */
  const plain = player.errors.filter((e) => e.line < 0);
  project.passes.forEach((pass, i) => {
    if (!failures[i]?.length) return;
    const known = (project.findings ?? []).filter((f) => pass.files.includes(f.labels[0].file) && holds(f));
    known.forEach((finding) => told.add(finding));
    if (known.length === 0) plain.push(...failures[i]);
  });
  const distinct = new Map(plain.map((e) => [`${e.pass}\n${e.line}\n${e.text}`, e]));
  return [
    ...[...told].map((finding) => problemOfFinding(player, finding)),
    ...[...distinct.values()].map((error) => problemOfError(player, error)),
  ];
}

/** The DOM node of a problem. @param {Player} player @param {Problem} problem @param {(() => void) | null} goTo */
function problemNode(player, problem, goTo) {
  const node = make('article');
  const head = make('p');
  if (problem.place) head.append(goTo ? makeButton(problem.place, goTo) : make('b', problem.place), ': ');
  head.append(makeWords('span', problem.words));
  if (problem.rule) head.append(' ', make('small', `[${problem.rule}]`));
  node.append(head);
  if (problem.marks.length > 0) node.append(excerpt(player.project.files[problem.file].text, problem.marks));
  for (const note of problem.notes) node.append(makeWords('p', note, 'note'));
  return node;
}

/** Shows errors over the image, unless the code tab is open, which shows them too. @param {Player} player */
function showErrors(player) {
  const box = element('errors', HTMLElement);
  const badge = element('wrong', HTMLButtonElement);
  let shown = '';
  let isClosed = false;
  const show = () => {
    const all = problems(player);
    const words = JSON.stringify(all);
    if (words !== shown) isClosed = false;
    shown = words;
    const count = all.length === 1 ? '1 error' : `${all.length} errors`;
    const isElsewhere = isClosed || isTabOpen('code');
    badge.hidden = all.length === 0 || !isElsewhere;
    badge.textContent = count;
    box.hidden = all.length === 0 || isElsewhere;
    if (box.hidden) return;
    const head = make('header');
    head.append(make('h2', count));
    if (all.some((p) => p.file >= 0) && canOpenPanel()) head.append(makeButton('Edit', () => openTab('code')));
    head.append(makeButton('×', () => {
      isClosed = true;
      show();
    }, 'Close'));
    box.replaceChildren(head, ...all.map((problem) => problemNode(player, problem, null)));
  };
  badge.addEventListener('click', () => {
    isClosed = false;
    if (isTabOpen('code')) closePanel();
    show();
  });
  player.listeners.push(show);
  panelListeners.push(show);
}
