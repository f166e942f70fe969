// Files and devices for channels: a row for each, and a notice for missing ones.

const FILE_KINDS = ['texture', 'cubemap', 'volume', 'video', 'music'];
const FLAT_KINDS = ['texture', 'video', 'music', 'webcam', 'mic', 'keyboard', 'buffer'];
/** Names of input kinds for users. @type {Record<string, string>} */
const KIND_WORDS = { texture: 'texture', cubemap: 'cube map', volume: 'volume', video: 'video', music: 'music file', webcam: 'camera', mic: 'microphone' };

/** @typedef {{pass: number, channel: number}} Slot */

/** @param {File} file @returns {Promise<string>} */
function dataAddress(file) {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(file);
  });
}

/** The kind of a file, by its type. @param {File} file */
function kindOfFile(file) {
  if (/\.bin$/i.test(file.name)) return 'volume';
  return { image: 'texture', video: 'video', audio: 'music' }[file.type.split('/')[0]] ?? null;
}

/** The kind of input for a file on a channel; null if it does not fit. @param {string} wanted @param {string} found */
function kindOnChannel(wanted, found) {
  if (wanted === 'volume' || found === 'volume') return wanted === found ? found : null;
  if (wanted === 'cubemap') return found === 'texture' ? 'cubemap' : null;
  return FLAT_KINDS.includes(wanted) ? found : null;
}

/** The name of the sampler. @param {Player} player @param {Slot} slot */
function channelName(player, { pass, channel }) {
  const input = player.project.passes[pass].inputs[channel];
  return input?.uniform ?? `iChannel${channel}`;
}

/** The channels that accept a file or a device: those with such an input, and empty ones that the code reads. @param {Player} player */
function openSlots(player) {
  return player.project.passes.flatMap(({ inputs }, pass) => {
    const channels = Array.from({ length: Math.max(4, inputs.length) }, (_, channel) => ({ pass, channel }));
    return channels.filter((slot) => {
      const input = inputs[slot.channel];
      return input ? input.kind in KIND_WORDS : isRead(player, slot);
    });
  });
}

/** Whether the compiled code reads a channel. @param {Player} player @param {Slot} slot */
function isRead(player, slot) {
  return player.programs[slot.pass]?.at(channelName(player, slot)) instanceof WebGLUniformLocation;
}

/**
 * Whether the file of a channel is missing. Channels that are empty in an export are empty on ShaderToy too.
 * @param {Player} player @param {Slot} slot
 */
function isMissing(player, slot) {
  const input = player.project.passes[slot.pass].inputs[slot.channel];
  if (!input && player.project.link) return false;
  if (input && (input.urls || input.standIn || !['texture', 'cubemap', 'volume', 'video'].includes(input.kind))) return false;
  return isRead(player, slot);
}

/** Waits until a video or music can be played. @param {string} kind @param {string} url */
function tryToPlay(kind, url) {
  const player = document.createElement(kind === 'video' ? 'video' : 'audio');
  return new Promise((resolve, reject) => {
    player.addEventListener('loadedmetadata', resolve);
    player.addEventListener('error', reject);
    player.preload = 'metadata';
    player.src = url;
  });
}

/** @param {Player} player @param {Slot} slot @param {File} file */
async function putFile(player, slot, file) {
  const wanted = player.project.passes[slot.pass].inputs[slot.channel]?.kind ?? 'texture';
  const found = kindOfFile(file);
  const kind = found && kindOnChannel(wanted, found);
  if (!kind) {
    flash(`${file.name} does not fit ${channelName(player, slot)}, which expects a ${KIND_WORDS[wanted] ?? 'texture'}`);
    return;
  }
  const url = kind === 'volume' ? await dataAddress(file) : URL.createObjectURL(file);
  try {
    if (kind === 'video' || kind === 'music') await tryToPlay(kind, url);
    await player.setInput(slot.pass, slot.channel, file.name, url, kind);
  } catch {
    flash(`Cannot read ${file.name} as a ${KIND_WORDS[kind]}`);
    return;
  }
  flash(`${file.name} loaded into ${channelName(player, slot)}`);
}

/** Assigns dropped files to channels that accept them: to empty ones first. @param {Player} player @param {File[]} files */
async function putFiles(player, files) {
  const slots = openSlots(player);
  const empty = slots.filter((slot) => isMissing(player, slot));
  for (const file of files) {
    const found = kindOfFile(file);
    /** @param {Slot} slot */
    const fits = ({ pass, channel }) => found && kindOnChannel(player.project.passes[pass].inputs[channel]?.kind ?? 'texture', found);
    const slot = empty.find(fits) ?? slots.find(fits);
    if (!found) flash(`${file.name} is not an image, video, audio or volume file`);
    else if (!slot) flash(`No channel accepts ${file.name}`);
    else {
      await putFile(player, slot, file);
      if (empty.includes(slot)) empty.splice(empty.indexOf(slot), 1);
    }
  }
}

/** Requests the camera. @param {Player} player */
async function allowCamera(player) {
  try {
    await player.devices?.openCamera();
  } catch {
    flash('Camera not available');
    return;
  }
  retract('camera');
  player.poke();
}

/** The description of a channel in its row. @param {Player} player @param {Slot} slot */
function wordsOfSlot(player, slot) {
  const input = player.project.passes[slot.pass].inputs[slot.channel];
  if (!input) return 'empty';
  const word = KIND_WORDS[input.kind] ?? input.kind;
  if (input.urls) return input.name || word;
  if (input.standIn) return `stand-in for ${input.title ? `“${input.title}”` : `a ${word}`}`;
  return isMissing(player, slot) ? `${input.name || word} (missing)` : input.name || word;
}

/** @param {Player} player @param {Slot} slot */
function channelRow(player, slot) {
  const row = make('div', '', 'channel');
  const words = make('span');
  const { kind } = player.project.passes[slot.pass].inputs[slot.channel] ?? { kind: 'texture' };
  const name = `${player.project.passes[slot.pass].name} ${channelName(player, slot)}`;
  const chooser = document.createElement('input');
  chooser.type = 'file';
  chooser.accept = { volume: '.bin', cubemap: 'image/*' }[kind] ?? 'image/*,video/*,audio/*';
  chooser.setAttribute('aria-label', `File for ${name}`);
  chooser.hidden = true;
  chooser.addEventListener('change', () => {
    if (chooser.files?.[0]) void putFile(player, slot, chooser.files[0]);
    chooser.value = '';
  });
  const isDevice = !FILE_KINDS.includes(kind);
  const button = makeButton(isDevice ? 'Allow' : 'File…', () => {
    if (kind === 'webcam') void allowCamera(player);
    else if (kind === 'mic') void player.devices?.openMicrophone().catch(() => flash('Microphone not available'));
    else chooser.click();
  }, isDevice ? `Allow the ${KIND_WORDS[kind]}` : `File for ${name}`);
  row.addEventListener('dragover', () => row.classList.add('over'));
  row.addEventListener('dragleave', () => row.classList.remove('over'));
  row.addEventListener('drop', (event) => {
    event.preventDefault();
    event.stopPropagation();
    row.classList.remove('over');
    const file = event.dataTransfer?.files[0];
    if (file) void putFile(player, slot, file);
  });
  const text = make('div');
  text.append(make('b', name), words);
  row.append(text, button, chooser);
  const show = () => {
    words.textContent = wordsOfSlot(player, slot);
  };
  return { row, show, choose: () => chooser.click() };
}

/** Shows a notice about empty channels. @param {Player} player @param {Slot[]} slots @param {(slot: Slot) => void} choose */
function tellMissing(player, slots, choose) {
  const missing = slots.filter((slot) => isMissing(player, slot));
  if (missing.length === 0) return retract('missing');
  const names = [...new Set(missing.map((slot) => channelName(player, slot)))];
  const kinds = missing.map(({ pass, channel }) => KIND_WORDS[player.project.passes[pass].inputs[channel]?.kind ?? 'texture']);
  const words = names.length === 1 ? `${names[0]} has no ${kinds[0]}: drop a file here` : `${names.slice(0, -1).join(', ')} and ${names[names.length - 1]} are empty: drop files here`;
  return notify('missing', words, { label: 'Choose…', act: () => choose(missing[0]) });
}

/** Shows a notice about a channel that waits for the camera. @param {Player} player @param {Slot[]} slots */
function tellCamera(player, slots) {
  const kindOf = (/** @type {Slot} */ { pass, channel }) => player.project.passes[pass].inputs[channel]?.kind;
  const waiting = slots.find((slot) => kindOf(slot) === 'webcam' && isRead(player, slot));
  if (!waiting || player.devices?.cameraFilm?.srcObject) return retract('camera');
  const act = () => void allowCamera(player);
  return notify('camera', `${channelName(player, waiting)} uses the camera`, { label: 'Allow', act });
}

/** Shows a row for each channel, and accepts dropped files. @param {Player} player */
function showChannels(player) {
  const box = element('channels', HTMLElement);
  /** @type {Map<string, ReturnType<typeof channelRow>>} */
  const rows = new Map();
  /** @param {Slot} slot */
  const key = (slot) => `${slot.pass} ${slot.channel}`;
  const show = () => {
    const slots = openSlots(player);
    for (const slot of slots) if (!rows.has(key(slot))) rows.set(key(slot), channelRow(player, slot));
    const shown = slots.flatMap((slot) => rows.get(key(slot)) ?? []);
    shown.forEach((row) => row.show());
    const nodes = shown.map((row) => row.row);
    if (nodes.length !== box.children.length - 1) box.replaceChildren(...(nodes.length > 0 ? [make('h2', 'Channels'), ...nodes] : []));
    showTabs();
    tellMissing(player, slots, (slot) => rows.get(key(slot))?.choose());
    tellCamera(player, slots);
  };
  const picture = element('picture', HTMLElement);
  for (const name of ['dragenter', 'dragover']) {
    document.addEventListener(name, (event) => {
      event.preventDefault();
      picture.classList.add('over');
    });
  }
  document.addEventListener('dragleave', (event) => {
    if (!event.relatedTarget) picture.classList.remove('over');
  });
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    picture.classList.remove('over');
    void putFiles(player, [...(event.dataTransfer?.files ?? [])]);
  });
  player.listeners.push(show);
  show();
}

pageParts.showChannels = showChannels;
