// Shows the pages of a shader one after another. A page is loaded hidden and replaces the visible one when
// it draws, with the same time, mouse, slider values and open tab.
'use strict';

const vscode = acquireVsCodeApi();
// The editor restores the preview from this.
vscode.setState({ uri: document.body.dataset.uri });

const pages = document.getElementById('pages');
const trouble = document.getElementById('trouble');
const offer = document.getElementById('write');
const value = document.getElementById('value');
const assumed = document.getElementById('assumed');
const hint = document.getElementById('pick');

/** The visible frame. */
let shown = null;
/** The frame that is loading. */
let next = null;
let lastTime = -1;
/** Whether the next click chooses the pixel to debug. */
let isPicking = false;

/** The interface of a page; `null` if it could not start. */
function faceOf(frame) {
    return frame?.contentWindow?.shaderport ?? null;
}

function say(words, isError) {
    trouble.textContent = words;
    trouble.classList.toggle('error', isError);
    trouble.hidden = words === '';
}

function load(html) {
    next?.remove();
    const frame = document.createElement('iframe');
    next = frame;
    frame.className = 'next';
    frame.allow = 'autoplay; clipboard-write; fullscreen';
    frame.addEventListener('load', () => void loaded(frame));
    frame.srcdoc = html;
    pages.append(frame);
}

async function loaded(frame) {
    const face = faceOf(frame);
    await face?.ready;
    if (frame !== next) return;
    const error = face?.errors[0];
    // The last image is more useful than an empty page; the editor shows the error.
    if (error && faceOf(shown)) {
        say(error.line > 0 ? `${error.pass}, line ${error.line}: ${error.text}` : `${error.pass}: ${error.text}`, true);
        frame.remove();
        next = null;
        return;
    }
    if (face) {
        remember(frame, face.player);
        const before = faceOf(shown);
        if (before) carry(shown, frame);
    }
    frame.className = '';
    forget(shown);
    shown = frame;
    next = null;
    say('', false);
    offerNumbers();
    for (const name of ['change', 'input']) frame.contentWindow.addEventListener(name, offerNumbers);
    frame.contentWindow.addEventListener('keydown', passOn);
    frame.contentWindow.addEventListener('pointerdown', (event) => pickPixel(frame, event), { capture: true });
    pick(isPicking);
}

/** A tunable value as the code has it. */
function written(project, { file, start, end }) {
    return project.files[file].text.slice(start, end);
}

/** Stores the values in the code. */
function remember(frame, player) {
    frame.numbers = new Map(player.project.tunables.map((tunable) => [tunable.name, written(player.project, tunable)]));
    frame.controls = new Map([...player.controls].map(([name, value]) => [name, JSON.stringify(value)]));
}

/** Transfers the state of one player to another. */
function carry(from, to) {
    const [old, face] = [faceOf(from), faceOf(to)];
    const { clock, isPlaying, mouse, project } = old.player;
    for (const tunable of project.tunables) {
        const { name, value } = tunable;
        const came = from.numbers.get(name);
        // A value that changed in the code takes precedence.
        if (written(project, tunable) !== came && to.numbers.get(name) === came) face.player.setTunable(name, value);
    }
    for (const [name, value] of old.player.controls) {
        const isSet = JSON.stringify(value) !== from.controls.get(name);
        if (isSet && to.controls.get(name) === from.controls.get(name)) face.player.setControl(name, value);
    }
    const { x, y, clickX, clickY } = mouse;
    Object.assign(face.player.mouse, { x, y, clickX, clickY });
    const tab = [from, to].map((frame) => frame.contentDocument);
    if (!tab[0].getElementById('panel').hidden) {
        const name = tab[0].querySelector('#tabs [aria-selected=true]')?.getAttribute('aria-controls');
        tab[1].querySelector(`#tabs [aria-controls="${name}"]`)?.click();
    }
    face.seek(clock.time);
    if (isPlaying) face.player.play();
    else face.player.pause();
}

/** Frees the graphics memory now instead of at the next garbage collection. */
function forget(frame) {
    const player = faceOf(frame)?.player;
    // A player without its resources has no context any more.
    const gl = player?.gl;
    player?.dispose?.();
    gl?.getExtension('WEBGL_lose_context')?.loseContext();
    frame?.remove();
}

/** The values that differ from those in the code, as texts. */
function setNumbers() {
    const project = faceOf(shown)?.player.project;
    const texts = project?.tunables.map((tunable) => ({ name: tunable.name, text: written(project, tunable) })) ?? [];
    return texts.filter(({ name, text }) => text !== shown.numbers.get(name));
}

function offerNumbers() {
    const numbers = setNumbers();
    offer.hidden = numbers.length === 0;
    const words = numbers.map(({ name, text }) => `${name} ${text}`);
    offer.querySelector('span').textContent = words.join(', ');
}

/** Starts or ends the choice of a pixel. */
function pick(isOn) {
    isPicking = isOn;
    hint.hidden = !isOn;
    const canvas = faceOf(shown)?.player.canvas;
    if (canvas) canvas.style.cursor = isOn ? 'crosshair' : '';
}

/** Debugs the clicked pixel, with the time and frame that are shown. */
function pickPixel(frame, event) {
    const { canvas, clock, isPlaying } = faceOf(frame)?.player ?? {};
    if (!canvas || event.target !== canvas || !(isPicking || event.altKey)) return;
    // The shader does not see this click.
    event.preventDefault();
    event.stopImmediatePropagation();
    pick(false);
    const box = canvas.getBoundingClientRect();
    const { width, height } = canvas;
    const column = Math.floor((event.clientX - box.left) / box.width * width);
    const row = Math.floor((box.bottom - event.clientY) / box.height * height);
    const pixel = [Math.min(Math.max(column, 0), width - 1), Math.min(Math.max(row, 0), height - 1)];
    // The number is that of the next frame, unless the clock stands.
    const number = Math.max(0, clock.number - (isPlaying ? 1 : 0));
    vscode.postMessage({ type: 'pixel', shown: { pixel, size: [width, height], time: clock.time, frame: number } });
}

/** Forwards keys to this window, the only one that the editor listens to; text fields keep theirs. */
function passOn(event) {
    if (event.key === 'Escape') pick(false);
    const isCommand = event.ctrlKey || event.metaKey || /^F\d+$/.test(event.key);
    if (!isCommand || /^(INPUT|TEXTAREA)$/.test(event.target.tagName)) return;
    const { key, code, keyCode, ctrlKey, metaKey, shiftKey, altKey } = event;
    window.dispatchEvent(new KeyboardEvent('keydown', { key, code, keyCode, ctrlKey, metaKey, shiftKey, altKey }));
}

function tellTime() {
    const time = faceOf(shown)?.player.clock.time ?? 0;
    if (time !== lastTime) vscode.postMessage({ type: 'time', time });
    lastTime = time;
    setTimeout(tellTime, 500);
}

offer.querySelector('button').addEventListener('click', () => {
    vscode.postMessage({ type: 'write', numbers: setNumbers() });
});
value.querySelector('button').addEventListener('click', () => {
    vscode.postMessage({ type: 'colour' });
});
assumed.querySelector('button').addEventListener('click', () => {
    vscode.postMessage({ type: 'channels' });
});

/** Says what is shown: a value, and the channels that nothing gives an input. */
function describe(page) {
    value.hidden = page.value === null;
    const [least, most] = page.value?.limits.map((limit) => Number(limit.toPrecision(3))) ?? [];
    value.querySelector('span').textContent = `Value of ${page.value?.text}, from ${least} to ${most}`;
    assumed.hidden = page.assumed.length === 0;
    const channels = page.assumed.map(({ pass, channel, shows }) => `${channel} of ${pass} (${shows})`);
    assumed.querySelector('span').textContent = `Channels without an input: ${channels.join(', ')}`;
    const button = assumed.querySelector('button');
    button.hidden = page.channels === null;
    const name = page.channels?.uri.replace(/^.*\//, '') ?? '';
    button.textContent = `${page.channels?.exists ? 'Open' : 'Write'} ${decodeURIComponent(name)}`;
}

window.addEventListener('message', ({ data }) => {
    if (data.type === 'page') {
        describe(data);
        load(data.html);
    } else if (data.type === 'pick') pick(true);
    else if (data.type === 'trouble') say(data.words, true);
});
window.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') pick(false);
});
tellTime();
vscode.postMessage({ type: 'ready' });
