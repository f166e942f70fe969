// Video recording: frame by frame with WebCodecs; in real time if these are not available or if the shader
// reads a video, a device or music.

/** @typedef {{seconds: number, rate: number, size: [number, number] | null, hasSound: boolean, isFromStart: boolean}} FilmOrder */
/** @typedef {{isStopped: boolean, tell: (share: number) => void}} FilmRun */

const LIVE_KINDS = ['video', 'webcam', 'music', 'mic'];

/** @param {Player} player */
function isLive(player) {
  const inputs = player.project.passes.flatMap((p) => p.inputs);
  return inputs.some((i) => i && LIVE_KINDS.includes(i.kind) && (i.urls || i.kind === 'webcam' || i.kind === 'mic'));
}

/** Settings for the encoder; null if none is supported. @param {number} width @param {number} height @param {number} rate */
async function videoSettings(width, height, rate) {
  if (typeof VideoEncoder === 'undefined') return null;
  const bitrate = Math.min(40e6, Math.max(2e6, 0.15 * width * height * rate));
  for (const [codec, name] of [['vp09.00.51.08', 'V_VP9'], ['vp8', 'V_VP8']]) {
    const config = { codec, width, height, framerate: rate, bitrate };
    const { supported } = await VideoEncoder.isConfigSupported(config).catch(() => ({ supported: false }));
    if (supported) return { config, name };
  }
  return null;
}

/** Waits, to keep the page responsive. @param {number} [ms] */
function pauseFor(ms = 0) {
  return new Promise((resolve) => setTimeout(resolve, ms));
}

/** @param {Player} player @param {FilmOrder} order @param {FilmRun} run @param {{config: VideoEncoderConfig, name: string}} settings */
async function filmExactly(player, order, run, settings) {
  const { canvas, clock } = player;
  const { width, height } = canvas;
  /** @type {FilmChunk[]} */
  const chunks = [];
  /** @type {Error | null} */
  let failure = null;
  const encoder = new VideoEncoder({
    output: (chunk) => {
      const data = new Uint8Array(chunk.byteLength);
      chunk.copyTo(data);
      chunks.push({ track: 1, time: chunk.timestamp / 1000, isKey: chunk.type === 'key', data });
    },
    error: (error) => {
      failure = error;
    },
  });
  encoder.configure(settings.config);
  if (order.isFromStart) clock.reset();
  const start = clock.time;
  const count = Math.max(1, Math.round(order.seconds * order.rate));
  let n = 0;
  for (; n < count && !run.isStopped && !failure; n++) {
    clock.time = start + n / order.rate;
    player.paint({ number: clock.number++, time: clock.time, delta: 1 / order.rate, rate: order.rate });
    const frame = new VideoFrame(canvas, { timestamp: Math.round((n * 1e6) / order.rate), duration: Math.round(1e6 / order.rate) });
    encoder.encode(frame, { keyFrame: n % (2 * order.rate) === 0 });
    frame.close();
    run.tell((n + 1) / count);
    do await pauseFor(encoder.encodeQueueSize > 2 ? 5 : 0);
    while (encoder.encodeQueueSize > 2 && !failure);
  }
  if (!failure) await encoder.flush();
  encoder.close();
  if (failure) throw failure;
  const seconds = n / order.rate;
  const sound = order.hasSound ? await encodeSound(player, start, seconds) : null;
  return webm({ codec: settings.name, width, height }, sound?.track ?? null, [...chunks, ...(sound?.chunks ?? [])], 1000 * seconds);
}

/** The sound pass as Opus; null without one. @param {Player} player @param {number} start @param {number} seconds */
async function encodeSound(player, start, seconds) {
  const samples = await player.samples();
  if (!samples || typeof AudioEncoder === 'undefined') return null;
  const rate = 48000;
  const offline = new OfflineAudioContext(2, Math.ceil(seconds * rate), rate);
  const buffer = offline.createBuffer(2, samples[0].length, SOUND_RATE);
  samples.forEach((lane, i) => buffer.copyToChannel(lane, i));
  const source = offline.createBufferSource();
  source.buffer = buffer;
  source.connect(offline.destination);
  source.start(0, start);
  const played = await offline.startRendering();
  /** @type {FilmChunk[]} */
  const chunks = [];
  let head = new Uint8Array();
  const encoder = new AudioEncoder({
    output: (chunk, about) => {
      const data = new Uint8Array(chunk.byteLength);
      chunk.copyTo(data);
      chunks.push({ track: 2, time: chunk.timestamp / 1000, isKey: true, data });
      const { description } = about?.decoderConfig ?? {};
      if (description instanceof ArrayBuffer) head = new Uint8Array(description);
    },
    error: () => {},
  });
  encoder.configure({ codec: 'opus', sampleRate: rate, numberOfChannels: 2, bitrate: 160000 });
  for (let at = 0; at < played.length; at += rate) {
    const count = Math.min(rate, played.length - at);
    const data = new Float32Array(2 * count);
    [0, 1].forEach((lane) => data.set(played.getChannelData(lane).subarray(at, at + count), lane * count));
    encoder.encode(new AudioData({ format: 'f32-planar', sampleRate: rate, numberOfFrames: count, numberOfChannels: 2, timestamp: Math.round((at * 1e6) / rate), data }));
  }
  await encoder.flush();
  encoder.close();
  return { chunks, track: { codec: 'A_OPUS', rate, channels: 2, head } };
}

/** Records image and sound in real time. @param {Player} player @param {FilmOrder} order @param {FilmRun} run @returns {Promise<Blob>} */
async function filmLive(player, order, run) {
  const stream = player.canvas.captureStream(order.rate);
  const { devices } = player;
  if (order.hasSound && devices) {
    player.setSound(true);
    const audio = devices.openAudio();
    const ear = audio.createMediaStreamDestination();
    devices.output?.connect(ear);
    ear.stream.getAudioTracks().forEach((track) => stream.addTrack(track));
  }
  /** @type {Blob[]} */
  const recorded = [];
  const recorder = new MediaRecorder(stream, { videoBitsPerSecond: 16e6 });
  recorder.addEventListener('dataavailable', (event) => recorded.push(event.data));
  const ended = new Promise((resolve) => recorder.addEventListener('stop', resolve));
  if (order.isFromStart) player.restart();
  recorder.start();
  player.play();
  const start = performance.now();
  for (let share = 0; share < 1 && !run.isStopped; await pauseFor(50)) {
    share = (performance.now() - start) / 1000 / order.seconds;
    run.tell(Math.min(1, share));
  }
  recorder.stop();
  await ended;
  stream.getTracks().forEach((track) => track.stop());
  return new Blob(recorded, { type: recorder.mimeType });
}

/** Records a video and restores the state of the player. @param {Player} player @param {FilmOrder} order @param {FilmRun} run */
async function film(player, order, run) {
  const { clock, isPlaying } = player;
  const before = { time: clock.time, number: clock.number };
  canvasSize.isHeld = true;
  // Encoders require even sizes.
  const [width, height] = (order.size ?? [player.canvas.width, player.canvas.height]).map((v) => Math.max(2, v & ~1));
  player.resize(width, height);
  try {
    const settings = isLive(player) ? null : await videoSettings(width, height, order.rate);
    if (!settings) return await filmLive(player, order, run);
    player.pause();
    return await filmExactly(player, order, run, settings);
  } finally {
    canvasSize.isHeld = false;
    canvasSize.fit();
    player.pause();
    Object.assign(clock, before);
    if (isPlaying) player.play();
    else player.poke();
  }
}
