// What lies under the mission: the files that it names, those that the user adds or drops, and tiles
// from outside where the viewer allows them.

import {addNamed, outsideTiles} from '../map/named_backgrounds.js';
import {droppedFiles} from './dropped_files.js';

const kMaxNotes = 10;

export class BackgroundDesk {
  #page;

  /** @param stage  the element onto which files are dropped */
  constructor(page, stage) {
    this.#page = page;
    page.map.onBackgroundProblem = (words) => this.#note([words]);
    // Files that are dropped anywhere else must not replace the page.
    for (const type of ['dragover', 'drop']) {
      document.addEventListener(type, (event) => {
        if (/** @type {DragEvent} */ (event).dataTransfer?.types?.includes('Files')) event.preventDefault();
      });
    }
    stage.addEventListener('drop', async (event) => {
      const files = await droppedFiles(event.dataTransfer);
      if (files.length > 0) this.put(files);
    });
  }

  /** Puts under the mission what it names. */
  async ask() {
    const {map, requests, setup, world} = this.#page;
    const isWanted = () => world === this.#page.world;
    map.removeBackgrounds();
    const outside = await requests.get('/api/outside').catch(() => null);
    if (!isWanted()) return;
    if (typeof outside?.tiles === 'string') {
      const tiles = outsideTiles(outside.tiles);
      map.addTiles(`tiles of ${tiles.host}`, tiles);
    }
    const words = await addNamed(setup.backgrounds, requests, map, isWanted);
    if (!isWanted()) return;
    this.#note(words);
    this.#page.top.showBackgrounds(map.backgrounds);
  }

  /** @param files  to lie under the mission; null: none any more */
  async put(files) {
    const {map, setup, top} = this.#page;
    if (!setup) return;
    if (files === null) map.removeBackgrounds();
    else top.note((await map.addBackgrounds(files)).slice(0, kMaxNotes));
    top.showBackgrounds(map.backgrounds);
  }

  /** Shows texts beside those of the mission. */
  #note(words) {
    const {setup, top} = this.#page;
    if (words.length > 0) top.note([...setup.notes, ...words].slice(0, kMaxNotes));
  }
}
