// Films, cameras, microphones and loudspeakers, each opened once and only when the user asks.

/**
 * Something that can be heard.
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

  /** The audio graph, made at the first user's gesture that asks for sound. */
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
