// What the page tells of a shader: errors, who made it, sliders.

/** @param {Player} player */
function showErrors(player) {
  const box = element('errors', HTMLElement);
  player.listeners.push(() => {
    const { errors, project } = player;
    box.hidden = errors.length === 0;
    const nodes = [make('h2', errors.length === 1 ? '1 error' : `${errors.length} errors`)];
    for (const [i, error] of errors.entries()) {
      const place = error.line > 0 ? `${error.pass}, line ${error.line}: ` : error.pass ? `${error.pass}: ` : '';
      nodes.push(make('p', place + error.text));
      const file = project.files.find((f) => !f.hidden && f.name === error.pass);
      const line = error.line > 0 ? file?.text.split(/\r\n|\r|\n/)[error.line - 1] : '';
      const next = errors[i + 1];
      const isLast = next?.pass !== error.pass || next?.line !== error.line;
      if (line?.trim() && isLast) nodes.push(make('pre', line));
    }
    box.replaceChildren(...nodes);
  });
}

/** Who made the shader; all of it is text. @param {ProjectData} project */
function showCredits(project) {
  document.title = project.title || 'shader';
  element('title', HTMLElement).textContent = project.title;
  element('license', HTMLElement).textContent = project.license;
  element('description', HTMLElement).textContent = project.description;
  const credits = element('credits', HTMLElement);
  if (project.author) credits.append(`by ${project.author}`);
  if (project.link.startsWith('https://')) {
    const link = document.createElement('a');
    link.href = project.link;
    link.rel = 'noopener noreferrer';
    link.textContent = project.link;
    credits.append(project.author ? ', ' : '', link);
  }
}

/** A slider for each number that the author left to be tuned. @param {Player} player */
function showSliders(player) {
  const box = element('sliders', HTMLElement);
  const seen = new Set();
  for (const tunable of player.project.tunables) {
    if (seen.has(tunable.name)) continue;
    seen.add(tunable.name);
    if (seen.size === 1) box.append(make('h2', 'Tunable'));
    const label = make('label', tunable.name);
    const value = document.createElement('output');
    const slider = document.createElement('input');
    slider.type = 'range';
    slider.min = String(Math.min(tunable.min, tunable.value));
    slider.max = String(Math.max(tunable.max, tunable.value));
    slider.step = tunable.integer ? '1' : 'any';
    slider.value = String(tunable.value);
    slider.name = tunable.name;
    value.value = slider.value;
    slider.addEventListener('input', () => {
      const number = Number(Number(slider.value).toPrecision(4));
      value.value = String(number);
      void player.setTunable(tunable.name, number);
    });
    label.append(value, slider);
    if (tunable.label) label.append(make('small', tunable.label));
    box.append(label);
  }
}

