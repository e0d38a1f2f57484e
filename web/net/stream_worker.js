// Holds one stream of frames for all pages of a browser that show the same viewer. A browser opens
// at most six connections to one server; with a stream for each page, the seventh would hang.
//
// A page sends {open: address}, {alive: true} now and then, {close: true}. It is sent {data: text}
// for each frame, and {failed: true} at the end; after that it may open again.

const kSilence_ms = 15000;  // A page that answered no frame for so long has gone.

const streams = new Map();  // address -> {events, pages: Map of port -> when it last answered}

function send(stream, message) {
  const now = Date.now();
  for (const [port, last] of stream.pages) {
    if (now - last > kSilence_ms) stream.pages.delete(port);
    else port.postMessage(message);
  }
}

function closeStream(address) {
  streams.get(address)?.events.close();
  streams.delete(address);
}

function openStream(address) {
  const stream = {events: new EventSource(address), pages: new Map()};
  stream.events.onmessage = (event) => {
    send(stream, {data: event.data});
    if (stream.pages.size === 0) closeStream(address);
  };
  stream.events.onerror = () => {
    send(stream, {failed: true});
    if (streams.get(address) === stream) closeStream(address);
    stream.events.close();
  };
  streams.set(address, stream);
  return stream;
}

function leave(port) {
  for (const [address, stream] of streams) {
    if (stream.pages.delete(port) && stream.pages.size === 0) closeStream(address);
  }
}

self.addEventListener('connect', (event) => {
  const port = /** @type {MessageEvent} */ (event).ports[0];
  port.onmessage = ({data}) => {
    if (typeof data.open === 'string') {
      leave(port);
      const stream = streams.get(data.open) ?? openStream(data.open);
      stream.pages.set(port, Date.now());
    } else if (data.close) {
      leave(port);
      port.close();
    } else {
      for (const stream of streams.values()) {
        if (stream.pages.has(port)) stream.pages.set(port, Date.now());
      }
    }
  };
});
