// What the client of a vehicle from outside reported of a packet that its modem received.

import {age, clip, quantity} from '../page/text.js';

/** The report in words: "packet of bravo, good, rate 1, 3 frames, SNR 23 dB, 2 s ago". */
export function modemWords(modem, t) {
  if (!modem) return '';
  const parts = [`packet of ${clip(modem.sender, 40)}`, modem.good ? 'good' : 'BAD'];
  if (modem.has_numbers) {
    const bad = modem.bad_frames > 0 ? `, ${modem.bad_frames} bad` : '';
    parts.push(`rate ${modem.rate}`, `${modem.frames} frames${bad}`,
      `SNR ${quantity(modem.snr, 0, 'dB')}`, `equalizer ${quantity(modem.equalizer, 0, 'dB')}`);
  }
  return `${parts.join(', ')}, ${age(t - modem.t)} ago`;
}
