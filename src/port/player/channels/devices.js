// Videos, cameras, microphones and audio output. Each is opened once, on request of the user.

/**
 * An audio source.
 * @typedef {object} Signal
 * @property {() => AnalyserNode | null} analyser null while it is silent
 * @property {() => number} time seconds
 * @property {(isOn: boolean) => void} play
 * @property {() => void} rewind
 */

class Devices {
  constructor() {
    /** @type {AudioContext | null} */
    this.audio = null;
    /** @type {GainNode | null} */
    this.output = null;
    this.isAudible = false;
    /** @type {HTMLVideoElement | null} */
    this.cameraFilm = null;
    /** @type {AnalyserNode | null} */
    this.microphone = null;
    /** @type {HTMLMediaElement[]} */
    this.elements = [];
    /** @type {MediaStream[]} */
    this.streams = [];
  }

  /** The audio context, created on the first user gesture that requires sound. */
  openAudio() {
    if (!this.audio) {
      this.audio = new AudioContext({ sampleRate: 44100 });
      this.output = this.audio.createGain();
      this.output.connect(this.audio.destination);
    }
    return this.audio;
  }

  /** @param {boolean} isAudible */
  setAudible(isAudible) {
    this.isAudible = isAudible;
    if (isAudible) void this.openAudio().resume();
    if (this.output) this.output.gain.value = isAudible ? 1 : 0;
    for (const element of this.elements) element.muted = !isAudible;
  }

  /** @param {string} url */
  film(url) {
    const film = document.createElement('video');
    film.muted = true;
    film.loop = true;
    film.playsInline = true;
    film.src = url;
    this.elements.push(film);
    return film;
  }

  camera() {
    if (!this.cameraFilm) {
      this.cameraFilm = document.createElement('video');
      this.cameraFilm.muted = true;
      this.cameraFilm.playsInline = true;
    }
    return this.cameraFilm;
  }

  async openCamera() {
    const stream = await navigator.mediaDevices.getUserMedia({ video: true });
    const film = this.camera();
    this.streams.push(stream);
    film.srcObject = stream;
    await film.play();
  }

  async openMicrophone() {
    const stream = await navigator.mediaDevices.getUserMedia({ audio: true });
    const audio = this.openAudio();
    this.streams.push(stream);
    this.microphone = audio.createAnalyser();
    audio.createMediaStreamSource(stream).connect(this.microphone);
    await audio.resume();
  }

  /** @param {InputData} data @returns {Signal} */
  signal(data) {
    if (data.kind === 'mic') {
      return {
        analyser: () => this.microphone,
        time: () => this.audio?.currentTime ?? 0,
        play: () => {},
        rewind: () => {},
      };
    }
    return data.urls ? this.#music(data.urls[0]) : silence;
  }

  /** @param {string} url @returns {Signal} */
  #music(url) {
    const element = new Audio(url);
    element.loop = true;
    element.muted = !this.isAudible;
    this.elements.push(element);
    /** @type {AnalyserNode | null} */
    let analyser = null;
    const connect = () => {
      const audio = this.openAudio();
      analyser = audio.createAnalyser();
      const source = audio.createMediaElementSource(element);
      source.connect(analyser);
      if (this.output) analyser.connect(this.output);
      return analyser;
    };
    return {
      analyser: () => (this.isAudible && !element.paused ? (analyser ?? connect()) : null),
      time: () => element.currentTime,
      play: (isOn) => void (isOn ? element.play().catch(() => {}) : element.pause()),
      rewind: () => {
        element.currentTime = 0;
      },
    };
  }

  /**
   * Computed sound, played in a loop.
   * @param {Promise<Float32Array<ArrayBuffer>[]>} samples of the left and right channel
   * @returns {Signal}
   */
  loop(samples) {
    /** @type {AudioBuffer | null} */
    let buffer = null;
    /** @type {AudioBufferSourceNode | null} */
    let source = null;
    /** @type {AnalyserNode | null} */
    let analyser = null;
    let isPlaying = false;
    /** Start time by the clock of the audio context, as if it had been played from the beginning. */
    let begin = 0;
    /** Position at which it was stopped, in seconds. */
    let offset = 0;
    const seconds = () => (source ? (this.openAudio().currentTime - begin) % (buffer?.duration ?? 1) : offset);
    const stop = () => {
      offset = seconds();
      source?.stop();
      source?.disconnect();
      source = null;
    };
    const start = async () => {
      const sides = await samples;
      const audio = this.openAudio();
      if (source || !isPlaying) return;
      if (!buffer) {
        buffer = audio.createBuffer(2, sides[0].length, 44100);
        buffer.copyToChannel(sides[0], 0);
        buffer.copyToChannel(sides[1], 1);
      }
      analyser ??= audio.createAnalyser();
      if (this.output) analyser.connect(this.output);
      source = audio.createBufferSource();
      source.buffer = buffer;
      source.loop = true;
      source.connect(analyser);
      source.start(0, offset);
      begin = audio.currentTime - offset;
    };
    return {
      analyser: () => {
        if (!this.isAudible || !isPlaying) return null;
        if (!source) void start();
        return source && analyser;
      },
      time: seconds,
      play: (isOn) => {
        isPlaying = isOn;
        if (!isOn) stop();
      },
      rewind: () => {
        stop();
        offset = 0;
      },
    };
  }

  dispose() {
    this.elements.forEach((e) => e.pause());
    this.streams.forEach((s) => s.getTracks().forEach((t) => t.stop()));
    void this.audio?.close();
  }
}

/** @type {Signal} */
const silence = {
  analyser: () => null,
  time: () => 0,
  play: () => {},
  rewind: () => {},
};

/** A sample in -1..1, from its low and high byte. @param {number} low @param {number} high */
function soundSample(low, high) {
  return -1 + (2 * (low + 256 * high)) / 65535;
}

parts.Devices = Devices;
