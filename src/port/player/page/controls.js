// Controls: tunable numbers in the code, and uniforms. Their values are stored in the URL.

/**
 * A tunable number or a uniform.
 * @typedef {object} Control
 * @property {ControlData} data the original data; its value is the one for reset
 * @property {() => number[] | null} read null if it no longer exists
 * @property {(value: number[]) => void} write
 */

/** @typedef {{nodes: HTMLElement[], show: (value: number[]) => void}} Face the widget of a control */

/** A tunable number as a control. @param {TunableData} tunable @returns {ControlData} */
function controlOfTunable(tunable) {
  const [min, max] = limits(tunable);
  const kind = !tunable.integer ? 'float' : min === 0 && max === 1 ? 'bool' : 'int';
  return { name: tunable.name, label: tunable.label, kind, value: [tunable.value], min: [min], max: [max] };
}

/** @param {Player} player @returns {Control[]} */
function allControls(player) {
  const { project } = player;
  const names = [...new Set(project.tunables.map((t) => t.name))];
  /** @param {string} name */
  const tunable = (name) => player.project.tunables.find((t) => t.name === name);
  const tuned = names.map((name) => ({
    data: controlOfTunable(/** @type {TunableData} */ (tunable(name))),
    read: () => {
      const found = tunable(name);
      return found ? [found.value] : null;
    },
    /** @param {number[]} value */
    write: (value) => void player.setTunable(name, value[0]),
  }));
  const set = (project.controls ?? []).map((control) => ({
    data: structuredClone(control),
    read: () => control.value,
    /** @param {number[]} value */
    write: (value) => player.setControl(control.name, value),
  }));
  return [...tuned, ...set];
}

/** Formats a number. @param {number} value */
function shortNumber(value) {
  return String(Number(value.toPrecision(4)));
}

/** A slider and a number box for one component. @param {ControlData} data @param {number} lane @param {(value: number) => void} write */
function lane(data, lane, write) {
  const isWhole = data.kind === 'int';
  const slider = document.createElement('input');
  const box = document.createElement('input');
  slider.type = 'range';
  box.type = 'number';
  const [least, most] = [data.min?.[lane] ?? 0, data.max?.[lane] ?? 1];
  const name = data.value.length > 1 ? `${data.name}.${'xyzw'[lane]}` : data.name;
  for (const input of [slider, box]) {
    input.min = String(least);
    input.max = String(most);
    input.setAttribute('aria-label', input === box ? `${name}, number` : name);
  }
  slider.name = name;
  slider.step = isWhole ? '1' : 'any';
  box.step = isWhole ? '1' : shortNumber((most - least) / 100);
  slider.addEventListener('input', () => write(Number(shortNumber(Number(slider.value)))));
  slider.addEventListener('dblclick', () => write(data.value[lane]));
  box.addEventListener('change', () => {
    const value = Number(box.value);
    if (box.value !== '' && Number.isFinite(value)) write(Math.min(Math.max(value, least), most));
  });
  /** @param {number} value */
  const show = (value) => {
    slider.value = String(value);
    if (document.activeElement !== box) box.value = shortNumber(value);
  };
  return { slider, box, show };
}

/** @param {ControlData} data @param {(value: number[]) => void} write @param {() => number[]} read @returns {Face} */
function sliderFace(data, write, read) {
  const lanes = data.value.map((_, i) => lane(data, i, (v) => write(read().map((old, j) => (j === i ? v : old)))));
  const line = lanes.map(({ slider, box }) => {
    const node = make('div', '', 'lane');
    node.append(slider, box);
    return node;
  });
  return { nodes: line, show: (value) => lanes.forEach((l, i) => l.show(value[i])) };
}

/** @param {ControlData} data @param {(value: number[]) => void} write @returns {Face} */
function switchFace(data, write) {
  const box = document.createElement('input');
  box.type = 'checkbox';
  box.name = data.name;
  box.id = `u.${data.name}`;
  box.setAttribute('aria-label', data.name);
  box.addEventListener('change', () => write([box.checked ? 1 : 0]));
  return {
    nodes: [box],
    show: ([value]) => {
      box.checked = value !== 0;
    },
  };
}

/** A colour picker; the fourth component is the opacity. @param {ControlData} data @param {(value: number[]) => void} write @param {() => number[]} read @returns {Face} */
function colorFace(data, write, read) {
  const picker = document.createElement('input');
  picker.type = 'color';
  picker.name = data.name;
  picker.setAttribute('aria-label', data.name);
  picker.addEventListener('input', () => {
    const color = [1, 3, 5].map((at) => Number((parseInt(picker.value.slice(at, at + 2), 16) / 255).toFixed(4)));
    write([...color, ...read().slice(3)]);
  });
  const alpha = data.value.length > 3 ? lane({ ...data, name: `${data.name}, opacity`, value: [data.value[3]], min: [0], max: [1] }, 0, (v) => write([...read().slice(0, 3), v])) : null;
  const node = make('div', '', 'lane');
  node.append(picker, ...(alpha ? [alpha.slider, alpha.box] : []));
  return {
    nodes: [node],
    show: (value) => {
      const byte = (/** @type {number} */ v) => Math.round(Math.min(Math.max(v, 0), 1) * 255).toString(16).padStart(2, '0');
      picker.value = `#${value.slice(0, 3).map(byte).join('')}`;
      alpha?.show(value[3]);
    },
  };
}

/** A position: a pad and two sliders. @param {ControlData} data @param {(value: number[]) => void} write @param {() => number[]} read @returns {Face} */
function pointFace(data, write, read) {
  const pad = make('div', '', 'pad');
  const dot = make('i');
  pad.append(dot);
  const low = [0, 1].map((i) => data.min?.[i] ?? 0);
  const high = [0, 1].map((i) => data.max?.[i] ?? 1);
  /** @param {PointerEvent} event */
  const place = (event) => {
    const box = pad.getBoundingClientRect();
    const at = [(event.clientX - box.left) / box.width, 1 - (event.clientY - box.top) / box.height];
    write(at.map((t, i) => Number(shortNumber(low[i] + Math.min(Math.max(t, 0), 1) * (high[i] - low[i])))));
  };
  pad.addEventListener('pointerdown', (event) => {
    pad.setPointerCapture(event.pointerId);
    place(event);
  });
  pad.addEventListener('pointermove', (event) => {
    if (pad.hasPointerCapture(event.pointerId)) place(event);
  });
  const sliders = sliderFace(data, write, read);
  return {
    nodes: [pad, ...sliders.nodes],
    show: (value) => {
      sliders.show(value);
      const [x, y] = [0, 1].map((i) => (100 * (value[i] - low[i])) / (high[i] - low[i] || 1));
      dot.style.left = `${x}%`;
      dot.style.bottom = `${y}%`;
    },
  };
}

/** @param {ControlData} data @param {(value: number[]) => void} write @returns {Face} */
function choiceFace(data, write) {
  const select = document.createElement('select');
  select.name = data.name;
  select.setAttribute('aria-label', data.name);
  for (const { label, value } of data.choices ?? []) select.add(new Option(label, String(value)));
  select.addEventListener('change', () => write([Number(select.value)]));
  return {
    nodes: [select],
    show: ([value]) => {
      select.value = String(value);
    },
  };
}

/** A button for an event of one frame. @param {ControlData} data @param {(value: number[]) => void} write @returns {Face} */
function eventFace(data, write) {
  const button = makeButton('Trigger', () => {
    write([1]);
    requestAnimationFrame(() => requestAnimationFrame(() => write([0])));
  }, data.name);
  return { nodes: [button], show: () => {} };
}

/** @type {Record<string, (data: ControlData, write: (value: number[]) => void, read: () => number[]) => Face>} */
const FACES = { float: sliderFace, int: sliderFace, vector: sliderFace, bool: switchFace, color: colorFace, point: pointFace, choice: choiceFace, event: eventFace };

/** A control with its name and reset button. @param {Control} control */
function controlRow(control) {
  const { data } = control;
  const row = make('div', '', 'control');
  /** @param {number[]} value */
  const write = (value) => {
    control.write(value);
    const isAsItCame = value.every((v, i) => v === data.value[i]);
    if (data.kind !== 'event') keepInAddress({ [`u.${data.name}`]: isAsItCame ? null : value.map(shortNumber).join(',') });
    show();
  };
  const read = () => control.read() ?? data.value;
  const face = (FACES[data.kind] ?? sliderFace)(data, write, read);
  const reset = makeButton('↺', () => write([...data.value]), `Reset ${data.name}`);
  reset.className = 'undo';
  const show = () => {
    const value = control.read();
    row.hidden = value === null;
    if (!value) return;
    face.show(value);
    reset.disabled = data.kind === 'event' || value.every((v, i) => v === data.value[i]);
  };
  const head = make('div', '', 'head');
  const isShort = ['bool', 'choice', 'event'].includes(data.kind);
  const name = make(data.kind === 'bool' ? 'label' : 'b', data.name);
  if (data.kind === 'bool') name.setAttribute('for', face.nodes[0].id);
  head.append(name, reset, ...(isShort ? face.nodes : []));
  row.append(head, ...(isShort ? [] : face.nodes));
  if (data.label && data.label.toLowerCase() !== data.name.toLowerCase()) row.append(make('small', data.label));
  show();
  return { row, show };
}

/** Applies the values in the URL. @param {Control[]} controls */
function takeFromAddress(controls) {
  const { values } = readAddress();
  for (const { data, write } of controls) {
    const asked = values.get(data.name);
    if (asked?.length !== data.value.length || data.kind === 'event') continue;
    write(asked.map((v, i) => Math.min(Math.max(v, data.min?.[i] ?? -Infinity), data.max?.[i] ?? Infinity)));
  }
}

/** @param {Player} player */
function showSliders(player) {
  const controls = allControls(player);
  const rows = controls.map(controlRow);
  takeFromAddress(controls);
  window.addEventListener('hashchange', () => takeFromAddress(controls));
  const box = element('sliders', HTMLElement);
  box.append(...rows.map((r) => r.row));
  if (rows.length > 1) {
    const resetAll = makeButton('Reset all', () => {
      controls.forEach((c) => {
        c.write([...c.data.value]);
        keepInAddress({ [`u.${c.data.name}`]: null });
      });
    });
    box.append(resetAll);
  }
  const show = () => rows.forEach((r) => r.show());
  show();
  player.listeners.push(show);
}

pageParts.showSliders = showSliders;
