// The map as a film: what a canvas shows from start() to stop(), as WebM.

const kFrames_hz = 30;
const kTypes = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];
const kBits_per_s = 4e6;
const kLongest_ms = 30 * 60 * 1000;  // Some 900 MB, which a browser can still keep.

/** The kind of film that this browser makes, or null. */
export function filmType(isSupported = (type) => globalThis.MediaRecorder?.isTypeSupported(type)) {
  return kTypes.find((type) => isSupported(type)) ?? null;
}

export class MapFilm {
  /** @type {MediaRecorder | null} */
  #recorder = null;
  /** @type {Blob[]} */
  #parts = [];
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param onEnd  gets the film, a Blob, whoever ended it */
  constructor(canvas, onEnd) {
    this.canvas = canvas;
    this.onEnd = onEnd;
  }

  get isRunning() { return this.#recorder !== null; }

  /** Begins; returns false where the browser makes no films. */
  start() {
    const type = filmType();
    if (type === null || this.isRunning) return false;
    this.#parts = [];
    const recorder = new MediaRecorder(this.canvas.captureStream(kFrames_hz),
      {mimeType: type, videoBitsPerSecond: kBits_per_s});
    recorder.addEventListener('dataavailable', ({data}) => {
      if (data.size > 0) this.#parts.push(data);
    });
    recorder.addEventListener('stop', () => {
      for (const track of recorder.stream.getTracks()) track.stop();
      this.onEnd(new Blob(this.#parts, {type: 'video/webm'}));
      this.#parts = [];
    });
    recorder.start(1000);
    this.#recorder = recorder;
    this.#timer = setTimeout(() => this.stop(), kLongest_ms);
    return true;
  }

  stop() {
    clearTimeout(this.#timer);
    this.#recorder?.stop();
    this.#recorder = null;
  }
}
