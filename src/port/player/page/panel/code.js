// Editors for the code of the passes.

/** The text with the line breaks of a text area. @param {string} text */
function unified(text) {
  return text.replace(/\r\n?/g, '\n');
}

/** Converts a text to the line breaks of an editor, and adjusts the offsets of its tunable numbers. @param {ProjectData} project @param {number} index */
function unifyText(project, index) {
  const file = project.files[index];
  for (const tunable of project.tunables.filter((t) => t.file === index)) {
    tunable.end = unified(file.text.slice(0, tunable.end)).length;
    tunable.start = unified(file.text.slice(0, tunable.start)).length;
  }
  file.text = unified(file.text);
}

/** @typedef {{index: number, name: string, original: string, tunables: TunableData[]}} OwnText */

/** @param {Player} player @returns {OwnText[]} the texts of the user */
function ownTexts(player) {
  const { files, tunables } = player.project;
  return files.flatMap(({ name, text, hidden }, index) =>
    hidden ? [] : [{ index, name: name || 'code', original: text, tunables: structuredClone(tunables.filter((t) => t.file === index)) }],
  );
}

/** Restores the original text and its tunable numbers. @param {Player} player @param {OwnText} own */
function resetText(player, own) {
  const { project } = player;
  project.tunables = project.tunables.filter((t) => t.file !== own.index);
  project.tunables.push(...structuredClone(own.tunables));
  project.files[own.index].text = own.original;
  return player.setCode(own.index, own.original);
}

/** Shows tabs and editors of the passes, problems, and the reset button. @param {Player} player */
function showCode(player) {
  const box = element('code', HTMLElement);
  const texts = ownTexts(player);
  const tabs = make('div', '', 'passes');
  tabs.setAttribute('role', 'tablist');
  tabs.setAttribute('aria-label', 'Passes');
  goByArrows(tabs);
  const list = make('div', '', 'problems');
  list.setAttribute('role', 'status');
  const reset = makeButton('Reset', () => void resetText(player, texts[current]), 'Restore the original code');
  const row = make('div', '', 'row');
  row.append(tabs, reset);
  let current = 0;
  let pending = 0;
  /** @type {Editor[]} */
  const editors = texts.map((own) => new Editor(own.name, (text) => {
    clearTimeout(pending);
    pending = setTimeout(() => {
      pending = 0;
      unifyText(player.project, own.index);
      void player.setCode(own.index, text);
    }, 300);
  }));
  const buttons = texts.map((own, i) => makeButton(own.name, () => select(i)));
  buttons.forEach((button) => button.setAttribute('role', 'tab'));
  tabs.append(...buttons);
  box.append(row, ...editors.map((e) => e.node), list);

  /** @param {number} index */
  const select = (index) => {
    current = index;
    buttons.forEach((button, i) => selectTab(button, i === index));
    editors.forEach((editor, i) => {
      editor.node.hidden = i !== index;
    });
    show();
  };
  const show = () => {
    if (!isTabOpen('code')) return;
    const all = problems(player);
    texts.forEach((own, i) => {
      const text = unified(player.project.files[own.index].text);
      if (pending === 0 && editors[i].area.value !== text) editors[i].set(text);
      const here = all.filter((p) => p.file === own.index);
      editors[i].mark(here.map((p) => ({ line: p.marks[0].line, words: p.words })));
      buttons[i].classList.toggle('bad', here.length > 0);
    });
    reset.disabled = unified(player.project.files[texts[current].index].text) === unified(texts[current].original);
    list.replaceChildren(...all.map((problem) => {
      const at = texts.findIndex((own) => own.index === problem.file);
      return problemNode(player, problem, at < 0 ? null : () => {
        select(at);
        editors[at].goTo(problem.marks[0].line, problem.marks[0].column);
      });
    }));
  };
  if (texts.length > 0) select(0);
  box.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && event.target instanceof HTMLTextAreaElement) buttons[current].focus();
  });
  player.listeners.push(show);
  panelListeners.push(show);
}
