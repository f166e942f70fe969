// Files and devices for channels.

/** @param {File} file @returns {Promise<string>} */
function dataAddress(file) {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(file);
  });
}

/** @param {Player} player @param {number} pass @param {number} channel @param {File} file */
async function putFile(player, pass, channel, file) {
  const isVolume = player.project.passes[pass].inputs[channel]?.kind === 'volume';
  const url = isVolume ? await dataAddress(file) : URL.createObjectURL(file);
  try {
    await player.setInput(pass, channel, file.name, url);
  } catch {
    player.errors.push({ pass: '', line: -1, text: `${file.name} cannot be read` });
  }
  player.listeners.forEach((listener) => listener());
}

const FILE_KINDS = ['texture', 'cubemap', 'volume', 'video', 'music'];

/** A line for each channel that a file or a device can feed. @param {Player} player */
function showChannels(player) {
  const box = element('channels', HTMLElement);
  player.project.passes.forEach((pass, index) => {
    pass.inputs.forEach((input, channel) => {
      if (!input || (!FILE_KINDS.includes(input.kind) && !['webcam', 'mic'].includes(input.kind))) return;
      if (!box.hasChildNodes()) box.append(make('h2', 'Channels'));
      box.append(channelRow(player, index, channel, input));
    });
  });
  const stage = element('stage', HTMLElement);
  stage.addEventListener('dragover', (event) => event.preventDefault());
  stage.addEventListener('drop', (event) => {
    event.preventDefault();
    const file = event.dataTransfer?.files[0];
    const image = player.project.passes.findIndex((p) => p.kind === 'image');
    const channel = player.project.passes[image].inputs.findIndex((i) => i && FILE_KINDS.includes(i.kind));
    if (file) void putFile(player, image, Math.max(0, channel), file);
  });
}

/** @param {Player} player @param {number} pass @param {number} channel @param {InputData} input */
function channelRow(player, pass, channel, input) {
  const row = make('div', '', 'channel');
  const text = make('span', `${player.project.passes[pass].name} iChannel${channel}: ${input.name || input.kind}`);
  const button = make('button', FILE_KINDS.includes(input.kind) ? 'file…' : 'allow');
  /** @param {File | undefined} file */
  const put = async (file) => {
    if (!file) return;
    await putFile(player, pass, channel, file);
    text.textContent = `${player.project.passes[pass].name} iChannel${channel}: ${file.name}`;
  };
  const chooser = document.createElement('input');
  chooser.type = 'file';
  chooser.addEventListener('change', () => void put(chooser.files?.[0]));
  button.addEventListener('click', () => {
    if (input.kind === 'webcam') void player.devices.openCamera().catch(() => {});
    else if (input.kind === 'mic') void player.devices.openMicrophone().catch(() => {});
    else chooser.click();
  });
  row.addEventListener('dragover', () => row.classList.add('over'));
  row.addEventListener('dragleave', () => row.classList.remove('over'));
  row.addEventListener('drop', (event) => {
    event.preventDefault();
    event.stopPropagation();
    row.classList.remove('over');
    void put(event.dataTransfer?.files[0]);
  });
  row.append(text, button);
  return row;
}

