// Widgets of controls.

/** @typedef {{nodes: HTMLElement[], show: (value: number[]) => void}} Face the widget of a control */

/** Formats a number. @param {number} value */
function shortNumber(value) {
  return String(Number(value.toPrecision(4)));
}

/** The name that the user sees. @param {ControlData} data */
function shownName(data) {
  return data.label || data.name;
}

/** A slider and a number box for one component. @param {ControlData} data @param {number} lane @param {(value: number) => void} write */
function lane(data, lane, write) {
  const isWhole = data.kind === 'int';
  const slider = document.createElement('input');
  const box = document.createElement('input');
  slider.type = 'range';
  box.type = 'number';
  const [least, most] = [data.min?.[lane] ?? 0, data.max?.[lane] ?? 1];
  const component = data.value.length > 1 ? `.${'xyzw'[lane]}` : '';
  const label = shownName(data) + component;
  for (const input of [slider, box]) {
    input.min = String(least);
    input.max = String(most);
    input.setAttribute('aria-label', input === box ? `${label}, number` : label);
  }
  slider.name = data.name + component;
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
  box.setAttribute('aria-label', shownName(data));
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
  picker.setAttribute('aria-label', shownName(data));
  picker.addEventListener('input', () => {
    const color = [1, 3, 5].map((at) => Number((parseInt(picker.value.slice(at, at + 2), 16) / 255).toFixed(4)));
    write([...color, ...read().slice(3)]);
  });
  const alpha = data.value.length > 3 ? lane({ ...data, name: `${data.name}, opacity`, label: `${shownName(data)}, opacity`, value: [data.value[3]], min: [0], max: [1] }, 0, (v) => write([...read().slice(0, 3), v])) : null;
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
  select.setAttribute('aria-label', shownName(data));
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
  }, shownName(data));
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
  const reset = makeButton('↺', () => write([...data.value]), `Reset ${shownName(data)}`);
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
  const name = make(data.kind === 'bool' ? 'label' : 'b', shownName(data));
  name.title = data.name;
  if (data.kind === 'bool') name.setAttribute('for', face.nodes[0].id);
  head.append(name, reset, ...(isShort ? face.nodes : []));
  row.append(head, ...(isShort ? [] : face.nodes));
  if (data.about && data.about.toLowerCase() !== data.name.toLowerCase()) row.append(make('small', data.about));
  show();
  return { row, show };
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
