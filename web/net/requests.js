// Questions to the viewer, and the stream of its frames.

const kTimeout_ms = 5000;
const kAnswerEvery_ms = 3000;  // How often a page shows the shared stream that it is there.

/** What went wrong with a request: `status` is that of HTTP, 0 where there was no answer. */
export class RequestError extends Error {
  constructor(message, status) {
    super(message);
    this.status = status;
  }
}

/**
 * What went wrong, of whatever was thrown; without a status where it was no RequestError.
 * @param {any} error @returns {{message: string, status: number | undefined}}
 */
export function failureOf(error) {
  return {message: String(error?.message ?? error), status: error?.status};
}

export class Requests {
  /** @param token  of the page's address; empty: none */
  constructor(token, fetchFrom = (path, options) => fetch(path, options)) {
    this.token = token;
    this.fetchFrom = fetchFrom;
  }

  /** Asks for JSON. Throws a RequestError that states what went wrong. */
  get(path, query = {}, timeout_ms = kTimeout_ms) {
    return this.#ask(this.address(path, query), {}, timeout_ms);
  }

  /** Asks for bytes. Throws a RequestError. */
  async bytes(path, query, timeout_ms = 60000) {
    const headers = this.token === '' ? {} : {'X-Shoal-Token': this.token};
    let response;
    try {
      response = await this.fetchFrom(this.address(path, query),
        {headers, cache: 'no-store', signal: AbortSignal.timeout(timeout_ms)});
      if (response.ok) return await response.blob();
    } catch {
      throw new RequestError('the viewer does not answer', 0);
    }
    const answer = await response.json().catch(() => null);
    const reason = typeof answer?.error === 'string' ? answer.error : `status ${response.status}`;
    throw new RequestError(reason, response.status);
  }

  post(path, body, timeout_ms = kTimeout_ms) {
    return this.#ask(path, {
      method: 'POST', body: JSON.stringify(body), headers: {'Content-Type': 'application/json'},
    }, timeout_ms);
  }

  /** The path with a query of all that is neither null nor empty. */
  address(path, query) {
    const parts = new URLSearchParams();
    for (const [key, value] of Object.entries(query)) {
      if (value !== null && value !== undefined && value !== '') parts.set(key, String(value));
    }
    const text = parts.toString();
    return text === '' ? path : `${path}?${text}`;
  }

  async #ask(path, options, timeout_ms) {
    const headers = {...options.headers};
    if (this.token !== '') headers['X-Shoal-Token'] = this.token;
    let response;
    let answer = null;
    try {
      response = await this.fetchFrom(path, {
        ...options, headers, cache: 'no-store', signal: AbortSignal.timeout(timeout_ms),
      });
      answer = await response.json();
    } catch {
      if (!response || response.ok) throw new RequestError('the viewer does not answer', 0);
    }
    if (response.ok) return answer;
    const reason = typeof answer?.error === 'string' ? answer.error : `status ${response.status}`;
    throw new RequestError(reason, response.status);
  }
}

function openOwnStream(address, {onText, onFailure}) {
  const events = new EventSource(address);
  events.onmessage = (event) => onText(event.data);
  events.onerror = () => onFailure();
  return {close: () => events.close()};
}

function openSharedStream(address, {onText, onFailure}) {
  const worker = new SharedWorker(new URL('./stream_worker.js', import.meta.url));
  const port = worker.port;
  let answered_ms = 0;
  port.onmessage = ({data}) => {
    const now_ms = performance.now();
    if (now_ms - answered_ms > kAnswerEvery_ms) {
      answered_ms = now_ms;
      port.postMessage({alive: true});
    }
    if (data.failed) onFailure();
    else if (data.data !== undefined) onText(data.data);
  };
  worker.onerror = () => onFailure();
  const leave = () => port.postMessage({close: true});
  addEventListener('pagehide', leave);
  port.postMessage({open: address});
  return {
    close: () => {
      removeEventListener('pagehide', leave);
      leave();
      port.onmessage = null;
    },
  };
}

/**
 * Opens the stream of frames: through a worker that all pages of the browser share or, where it
 * has none or `alone`, by itself. onText gets each frame's JSON; after onFailure nothing comes.
 */
export function openStream(address, listener, alone) {
  const absolute = new URL(address, location.href).href;
  const shared = !alone && typeof SharedWorker === 'function';
  return shared ? openSharedStream(absolute, listener) : openOwnStream(absolute, listener);
}
