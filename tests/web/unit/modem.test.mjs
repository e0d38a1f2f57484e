import assert from 'node:assert/strict';
import {test} from 'node:test';

import {modemWords} from '../../../web/panels/modem.js';

const kReport = {t: 10, sender: 'bravo', good: true, has_numbers: true, rate: 1, frames: 3,
  bad_frames: 0, snr: 23, equalizer: -12};

test('a modem report is put in words', () => {
  assert.match(modemWords(kReport, 12),
    /^packet of bravo, good, rate 1, 3 frames, SNR 23 dB, equalizer -12 dB, 2.* ago$/);
});

test('damage stands out, and numbers are left out where there are none', () => {
  assert.match(modemWords({...kReport, good: false, bad_frames: 2}, 12), /BAD, rate 1, 3 frames, 2 bad/);
  assert.match(modemWords({...kReport, has_numbers: false}, 12), /^packet of bravo, good, 2.* ago$/);
});

test('no report gives no words', () => {
  assert.equal(modemWords(null, 12), '');
});
