// Reads tables of an SQLite database that a user has dropped: rows in the order of their rowid, one
// by one, nothing else. Every page and every length is checked, since a file may hold anything.
//
// https://www.sqlite.org/fileformat2.html: 1.3 the header, 1.6 b-tree pages, 2.1 records.

const kMagic = 'SQLite format 3\0';
const kLeaf = 13;
const kInterior = 5;
const kMaxDepth = 20;
const kMaxValue = 8_000_000;  // Bytes of one text or blob.

export class SqliteError extends Error {}

const damaged = () => new SqliteError('the database is damaged, or cut; copy it again');

/** A value of a record: where its bytes are is found when it is asked for. */
class Record {
  #bytes;
  #types = [];
  #body;

  constructor(bytes) {
    this.#bytes = bytes;
    const [size, first] = varint(bytes, 0);
    if (size > bytes.length) throw damaged();
    for (let at = first; at < size;) {
      const [type, next] = varint(bytes, at);
      this.#types.push(type);
      at = next;
    }
    this.#body = size;
  }

  /** Returns a number, a string, bytes (Uint8Array) or null. */
  value(column) {
    let at = this.#body;
    for (let i = 0; i < column; ++i) at += sizeOf(this.#types[i] ?? 0);
    const type = this.#types[column] ?? 0;
    const size = sizeOf(type);
    if (at + size > this.#bytes.length || size > kMaxValue) throw damaged();
    const view = new DataView(this.#bytes.buffer, this.#bytes.byteOffset + at, size);
    if (type === 0) return null;
    if (type === 7) return view.getFloat64(0);
    if (type === 8 || type === 9) return type - 8;
    if (type < 7) {
      let number = view.getInt8(0);
      for (let i = 1; i < size; ++i) number = number * 256 + view.getUint8(i);
      return number;
    }
    const bytes = this.#bytes.subarray(at, at + size);
    return type % 2 === 1 ? new TextDecoder().decode(bytes) : bytes;
  }
}

/** Reads the integer at `at`; returns it and the place behind it. */
function varint(bytes, at) {
  let value = 0;
  for (let i = 0; i < 9; ++i) {
    const byte = bytes[at + i];
    if (byte === undefined) throw damaged();
    if (i === 8) return [value * 256 + byte, at + 9];
    value = value * 128 + (byte & 127);
    if (byte < 128) return [value, at + i + 1];
  }
  throw damaged();
}

function sizeOf(type) {
  if (type >= 12) return Math.floor((type - 12) / 2);
  return [0, 1, 2, 3, 4, 6, 8, 8, 0, 0, 0, 0][type];
}

export class SqlitePages {
  #bytes;
  #view;
  #size;     // Of a page.
  #usable;

  /** Throws an SqliteError. @param {ArrayBuffer} buffer */
  constructor(buffer) {
    this.#bytes = new Uint8Array(buffer);
    this.#view = new DataView(buffer);
    if (buffer.byteLength < 512
        || new TextDecoder().decode(this.#bytes.subarray(0, 16)) !== kMagic) {
      throw new SqliteError('not an SQLite database, as MBTiles are');
    }
    const size = this.#view.getUint16(16);
    this.#size = size === 1 ? 65536 : size;
    this.#usable = this.#size - this.#bytes[20];
    if (this.#size < 512 || this.#usable < 480 || this.#view.getUint32(56) > 1) {
      throw new SqliteError('a database of another kind: UTF-8 is read');
    }
  }

  /** Returns {type, root, sql, columns} of a table or view; null: there is none. */
  find(name) {
    for (const record of this.rows(1)) {
      if (String(record.value(1)).toLowerCase() !== name) continue;
      const sql = String(record.value(4));
      const names = /\(([^]*)\)/.exec(sql)?.[1] ?? '';
      const columns = names.split(',').map((part) => (
        /^\s*["'`[]?(\w+)/.exec(part)?.[1] ?? '').toLowerCase());
      return {type: record.value(0), root: Number(record.value(3)), sql, columns};
    }
    return null;
  }

  /** Yields the records of the table whose root is this page. */
  * rows(root) {
    yield* this.#rowsBelow(root, 0, {pages: 0});
  }

  * #rowsBelow(number, depth, walked) {
    const start = (number - 1) * this.#size;
    // A page that leads back to itself would never end.
    if (!(number >= 1) || start + this.#size > this.#bytes.length || depth > kMaxDepth
        || ++walked.pages > this.#bytes.length / this.#size) throw damaged();
    const header = start + (number === 1 ? 100 : 0);
    const kind = this.#bytes[header];
    if (kind !== kLeaf && kind !== kInterior) throw damaged();
    const count = this.#view.getUint16(header + 3);
    const cells = header + (kind === kLeaf ? 8 : 12);
    if (cells + 2 * count > start + this.#size) throw damaged();
    for (let i = 0; i < count; ++i) {
      const cell = start + this.#view.getUint16(cells + 2 * i);
      if (cell + 4 > start + this.#size) throw damaged();
      if (kind === kLeaf) yield new Record(this.#payload(cell));
      else yield* this.#rowsBelow(this.#view.getUint32(cell), depth + 1, walked);
    }
    if (kind === kInterior) {
      yield* this.#rowsBelow(this.#view.getUint32(header + 8), depth + 1, walked);
    }
  }

  #payload(cell) {
    const [size, behindSize] = varint(this.#bytes, cell);
    const [, at] = varint(this.#bytes, behindSize);
    const most = this.#usable - 35;
    if (size <= most) {
      if (at + size > this.#bytes.length) throw damaged();
      return this.#bytes.subarray(at, at + size);
    }
    if (size > this.#bytes.length || size > kMaxValue + 10_000) throw damaged();
    const least = Math.floor((this.#usable - 12) * 32 / 255) - 23;
    const wanted = least + (size - least) % (this.#usable - 4);
    const local = wanted <= most ? wanted : least;
    const all = new Uint8Array(size);
    if (at + local + 4 > this.#bytes.length) throw damaged();
    all.set(this.#bytes.subarray(at, at + local));
    let page = this.#view.getUint32(at + local);
    for (let filled = local; filled < size;) {
      const start = (page - 1) * this.#size;
      if (!(page >= 1) || start + this.#size > this.#bytes.length) throw damaged();
      const part = Math.min(size - filled, this.#usable - 4);
      all.set(this.#bytes.subarray(start + 4, start + 4 + part), filled);
      filled += part;
      page = this.#view.getUint32(start);
    }
    return all;
  }
}
