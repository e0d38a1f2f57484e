import assert from 'node:assert/strict';
import test from 'node:test';

import {filmType, MapFilm} from '../../../web/map/map_film.js';

test('a film is of the first kind that the browser makes', () => {
  assert.equal(filmType((type) => type.includes('vp8')), 'video/webm;codecs=vp8');
  assert.equal(filmType(() => false), null);
});

test('a browser that makes no films begins none', () => {
  const film = new MapFilm(null, () => {});
  assert.equal(film.start(), false);
  assert.equal(film.isRunning, false);
  film.stop();
});
