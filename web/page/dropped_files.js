// The files that a user has dropped, those of folders included.

const kMaxFiles = 100_000;
const kMaxDepth = 8;

const entriesOf = (reader) => new Promise((done) => { reader.readEntries(done, () => done([])); });
const fileOf = (entry) => new Promise((done) => { entry.file(done, () => done(null)); });

async function addFiles(entry, path, depth, files) {
  if (files.length >= kMaxFiles || depth > kMaxDepth) return;
  if (entry.isFile) {
    const file = await fileOf(entry);
    if (!file) return;
    // The browser gives dropped files no path of their own.
    if (depth > 0) file.path = `${path}${entry.name}`;
    files.push(file);
  } else if (entry.isDirectory) {
    const reader = entry.createReader();
    for (;;) {
      const some = await entriesOf(reader);  // A hundred at a time.
      if (some.length === 0) return;
      for (const each of some) await addFiles(each, `${path}${entry.name}/`, depth + 1, files);
    }
  }
}

/** Returns the files of a drop; those below a dropped folder have a `path`. */
export async function droppedFiles(transfer) {
  // Entries are there only until the event is over.
  const entries = [...transfer?.items ?? []].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  if (entries.length === 0) return [...transfer?.files ?? []];
  const files = [];
  for (const entry of entries) await addFiles(entry, '', 0, files);
  return files;
}
