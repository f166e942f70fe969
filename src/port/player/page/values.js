// Controls: tunable numbers in the code, and uniforms. Their values are stored in the URL.

/**
 * A tunable number or a uniform.
 * @typedef {object} Control
 * @property {ControlData} data the original data; its value is the one for reset
 * @property {() => number[] | null} read null if it no longer exists
 * @property {(value: number[]) => void} write
 */

/** A tunable value as a control. Its label is a description. @param {TunableData} tunable @returns {ControlData} */
function controlOfTunable(tunable) {
  const { name, label, kind, value } = tunable;
  const [min, max] = limits(tunable);
  return { name, label: name, about: label, kind, value, min, max };
}

/** @param {Player} player @returns {Control[]} */
function allControls(player) {
  const { project } = player;
  const names = [...new Set(project.tunables.map((t) => t.name))];
  /** @param {string} name */
  const tunable = (name) => player.project.tunables.find((t) => t.name === name);
  const tuned = names.map((name) => ({
    data: controlOfTunable(/** @type {TunableData} */ (tunable(name))),
    read: () => tunable(name)?.value ?? null,
    /** @param {number[]} value */
    write: (value) => void player.setTunable(name, value),
  }));
  const set = (project.controls ?? []).map((control) => ({
    data: structuredClone(control),
    read: () => control.value,
    /** @param {number[]} value */
    write: (value) => player.setControl(control.name, value),
  }));
  return [...tuned, ...set];
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

pageParts.takeValues = (player) => takeFromAddress(allControls(player));
