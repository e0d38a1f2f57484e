import assert from 'node:assert/strict';
import {test} from 'node:test';

import {age, clip, fileName, heading, missionTime, quantity, ratio, words}
  from '../../../web/page/text.js';

test('a quantity has its unit and digits, and an unknown one a dash', () => {
  assert.equal(quantity(87.06, 1, 'm'), '87.1 m');
  assert.equal(quantity(87.06, 1, '°'), '87.1°');
  assert.equal(quantity(3, 0), '3');
  for (const unknown of [null, undefined, NaN, Infinity, '7']) {
    assert.equal(quantity(unknown, 1, 'm'), '–');
  }
});

test('a quantity that rounds to nothing has no sign', () => {
  assert.equal(quantity(-0.04, 1, 'm'), '0.0 m');
  assert.equal(quantity(-0.06, 1, 'm'), '-0.1 m');
});

test('mission time has hours only where there are any, and carries when it rounds', () => {
  assert.equal(missionTime(0), '00:00.0');
  assert.equal(missionTime(123.44), '02:03.4');
  assert.equal(missionTime(59.96), '01:00.0');
  assert.equal(missionTime(3723.4), '1:02:03.4');
  assert.equal(missionTime(3599.6, 0), '1:00:00');
  assert.equal(missionTime(-5.25, 2), '-00:05.25');
  assert.equal(missionTime(-0.001), '00:00.0');
  assert.equal(missionTime(null), '–');
});

test('an age gets coarser as it grows and is never negative', () => {
  assert.equal(age(0.34), '0.3 s');
  assert.equal(age(-2), '0.0 s');
  assert.equal(age(9.96), '10 s');
  assert.equal(age(99), '99 s');
  assert.equal(age(120), '2 min');
  assert.equal(age(7200), '2 h');
  assert.equal(age(null), '–');
});

test('a heading has three digits and 360 is North', () => {
  assert.equal(heading(7.2), '007°');
  assert.equal(heading(359.7), '000°');
  assert.equal(heading(-10), '350°');
  assert.equal(heading(undefined), '–');
});

test('a ratio is 100% and 0% only where that is so', () => {
  assert.equal(ratio(24, 24), '100%');
  assert.equal(ratio(999, 1000), '99%');
  assert.equal(ratio(1, 1000), '1%');
  assert.equal(ratio(0, 1000), '0%');
  assert.equal(ratio(0, 0), '–');
  assert.equal(ratio(null, 3), '–');
});

test('names are written with blanks', () => {
  assert.equal(words('out_of_range'), 'out of range');
  assert.equal(words(null), '');
});

test('a long text is cut to what was asked for', () => {
  assert.equal(clip('abcdef', 4), 'abc…');
  assert.equal(clip('abcd', 4), 'abcd');
  assert.equal(clip(undefined), '');
  assert.equal(clip('x'.repeat(1e6)).length, 300);
});

test('a file name keeps nothing that a file system could take amiss', () => {
  assert.equal(fileName('../../etc/passwd'), '.._.._etc_passwd');
  assert.equal(fileName('berta 2'), 'berta_2');
  assert.equal(fileName(''), 'mission');
  assert.equal(fileName('x'.repeat(500)).length, 80);
});
