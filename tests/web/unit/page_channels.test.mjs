import assert from 'node:assert/strict';
import {test} from 'node:test';

import {PageChannels} from '../../../web/net/page_channels.js';

const channels = new PageChannels([
  {name: 'NAV_A', type: 'nav_t', count: 100, rate_hz: 10, fields: [['x_m', true], ['ok', false]],
    samples: [[1, 8, '1.5', 'true'], [2, 8, '2.5', 'false'], [3, 8, null, 'true']]},
  {name: 'DECISION', type: 'd_t', count: 1, rate_hz: 1, fields: [['aims[0].name', false],
    ['aims[1].name', false]], samples: [[2, 8, 'a', 'b'], [3, 8, 'a', null]]},
]);

test('channels and messages are those until a time', () => {
  assert.deepEqual(channels.channels(1.5).channels.map(({name, t}) => [name, t]), [['NAV_A', 1]]);
  assert.deepEqual(channels.message('NAV_A', 2.9).fields, [{path: 'x_m', text: '2.5', number: true},
    {path: 'ok', text: 'false', number: false}]);
  assert.equal(channels.message('NAV_A', 3).fields.length, 1, 'a field that it lacks is left out');
  assert.throws(() => channels.message('NAV_A', 0), /no message/);
  assert.throws(() => channels.message('constructor', 5), /no channel/);
});

test('fields are found by words, and elements of arrays together', () => {
  assert.deepEqual(channels.fields('nav X').fields, ['NAV_A:x_m']);
  assert.deepEqual(channels.fields('name').fields, ['DECISION:aims[].name']);
  assert.deepEqual(channels.series('DECISION:aims[].name', 9, 100),
    {field: 'DECISION:aims[].name', number: false, t: [2, 3], value: ['a, b', 'a']});
});

test('a series has numbers, and booleans as 1 and 0', () => {
  assert.deepEqual(channels.series('NAV_A:x_m', 9, 100).value, [1.5, 2.5]);
  assert.deepEqual(channels.series('NAV_A:ok', 2, 0.5), {field: 'NAV_A:ok', number: true, t: [2],
    value: [0]});
  assert.throws(() => channels.series('NAV_A:z', 9, 9), /no such field/);
});

test('a page without channels has none', () => {
  assert.deepEqual(new PageChannels(undefined).channels(9), {channels: []});
});
