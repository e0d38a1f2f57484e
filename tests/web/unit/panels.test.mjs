import assert from 'node:assert/strict';
import {test} from 'node:test';

import {axisRange, cleanColumns, headingStrokes} from '../../../web/charts/charts.js';
import {commandWords, gotoWords} from '../../../web/panels/commands.js';
import {mergeFates} from '../../../web/panels/panel_fates.js';
import {causeCounts} from '../../../web/panels/panel_link.js';
import {cellSize, cellWords, mediaToChoose} from '../../../web/panels/panel_matrix.js';
import {pageMatches} from '../../../web/panels/panel_status.js';
import {contactWords} from '../../../web/panels/panel_swarm.js';
import {alarmsOf, modeOf, reportAge, shortMode} from '../../../web/panels/panel_vehicle.js';
import {marksOf} from '../../../web/page/timeline.js';
import {bannerWords, clockWords} from '../../../web/page/top_bar.js';
import {chosenEvents, kEventGroups} from '../../../web/panels/panel_events.js';
import {marginWords, resultWords, tidyVerdict} from '../../../web/panels/verdict.js';

test('a verdict has the number and the margin of every expectation', () => {
  assert.equal(marginWords({passed: true, margin: 2.25, unit: 'm'}), 'margin 2.25 m');
  assert.equal(marginWords({passed: false, margin: -12, unit: 's'}), 'missed by 12 s');
  assert.equal(marginWords({passed: true, margin: null}), '');
  assert.equal(resultWords({result: 'PASS', why: ''}), 'ended: PASS');
  assert.equal(resultWords({result: 'FAIL', why: '1 collision'}), 'ended: FAIL: 1 collision');
  for (const answer of [null, {}, {verdict: 7}, {verdict: {result: 3}}]) {
    assert.equal(tidyVerdict(answer), null);
  }
  assert.deepEqual(tidyVerdict({verdict: {result: 'PASS', expectations: [1, {text: 'a'}]}})
    .expectations, [{text: 'a'}]);
});

test('events are chosen by kind, vehicle and words', () => {
  const events = [{kind: 'task', vehicles: ['alpha'], text: 'alpha: task survey'},
    {kind: 'message_lost', vehicles: ['alpha', 'bravo'], text: 'message 3: out of range'},
    {kind: 'collision', vehicles: ['bravo'], text: 'bravo'}];
  const kinds = (choice) => chosenEvents(events, choice).map(({kind}) => kind);
  assert.deepEqual(kinds({group: 'all', vehicle: '', text: ''}).length, 3);
  assert.deepEqual(kinds({group: 'messages', vehicle: '', text: ''}), ['message_lost']);
  assert.deepEqual(kinds({group: 'all', vehicle: 'bravo', text: ''}), ['message_lost', 'collision']);
  assert.deepEqual(kinds({group: 'all', vehicle: '', text: ' SURVEY'}), ['task']);
  assert.deepEqual(kinds({group: 'no such', vehicle: '', text: 'message lost'}), ['message_lost']);
  assert.ok(kEventGroups.every(([, , list]) => list === null || list.length > 0));
});

test('a viewer that ended with its mission is no trouble', () => {
  assert.match(bannerWords({state: 'ended'}, 'lost', 'no news'), /The mission has ended/);
  assert.match(bannerWords({state: 'running'}, 'lost', 'no news'), /Connection lost/);
  assert.equal(bannerWords({state: 'ended'}, 'live', ''), '', 'the verdict is shown instead');
});

test('a chart gets columns as long as its times, which grow, whatever came', () => {
  assert.deepEqual(cleanColumns([1, 1, 0, 2, NaN, 3], [[5, 6, 7, null], 'nonsense']),
    [[1, 2, 3], [5, null, null], [null, null, null]]);
  assert.deepEqual(cleanColumns(undefined, [undefined]), [[], []]);
  assert.equal(cleanColumns(Array.from({length: 1e5}, (_, i) => i), [])[0].length, 20000);
});

test('a line of headings is broken at North and at gaps', () => {
  assert.deepEqual(headingStrokes([350, 358, 3, 5, null, 8, 355]), [[0, 1], [2, 3], [5], [6]]);
  assert.deepEqual(headingStrokes([]), []);
});

test('an axis covers its values and never less than its span', () => {
  assert.deepEqual(axisRange(10, 10, 2), [9, 11]);
  const [low, high] = axisRange(0, 100, 2);
  assert.ok(low < 0 && high > 100);
  assert.equal(axisRange(0, 100, 2, 0)[0], 0);
  assert.deepEqual(axisRange(null, null, 5), [0, 5]);
});

test('fates are merged newest first, each once, and only the newest', () => {
  const fate = (id) => ({id});
  const merged = mergeFates([fate(2), fate(1)], [fate(4), fate(2)], 3);
  assert.deepEqual(merged.map(({id}) => id), [4, 2, 1]);
  const many = Array.from({length: 500}, (_, id) => fate(id));
  assert.equal(mergeFates([], many, 200).length, 200);
});

test('causes come with the most frequent first', () => {
  assert.deepEqual(causeCounts({dropped: 2, delivered: 5, x: 'y'}).map(({cause}) => cause),
    ['delivered', 'dropped']);
  assert.deepEqual(causeCounts(undefined), []);
});

test('a cell of the matrix shows in signs and words what its colour shows', () => {
  const link = {receives: false, delivered: 3, offered: 12, last_received_s: 2, text: '300 m of 250 m'};
  const cell = cellWords(link, 10);
  assert.deepEqual([cell.state, cell.sign, cell.ratio, cell.received], ['deaf', '✗', '25%', '8.0 s']);
  assert.match(cell.title, /does not receive; 3 of 12 .* 300 m of 250 m/);
  assert.equal(cellWords({...link, receives: true}, 10).sign, '✓');
  assert.equal(cellWords({...link, last_received_s: null}, 10).received, 'never');
  assert.equal(cellWords(null, 10).state, 'unknown');
});

test('a medium is to choose where there are several, and only then', () => {
  assert.deepEqual(mediaToChoose({media: ['acoustic', 'vhf']}), ['acoustic', 'vhf']);
  assert.deepEqual(mediaToChoose({media: ['vhf']}), []);
  assert.deepEqual(mediaToChoose({}), []);
  assert.deepEqual(mediaToChoose({media: 'nonsense'}), []);
  assert.deepEqual(mediaToChoose({media: ['vhf', 7, '', 'acoustic']}), ['vhf', 'acoustic']);
});

test('cells of the matrix are as large as the width lets all be seen', () => {
  assert.deepEqual(cellSize(850, 8), {compact: false, cell_px: 36});
  assert.equal(cellSize(388, 8).compact, true);
  assert.equal(cellSize(388, 3).compact, false);
  assert.equal(cellSize(388, 100).cell_px, 14);
  assert.equal(cellSize(2000, 100).cell_px, 17);
  assert.ok(100 * (cellSize(2000, 100).cell_px + 1) <= 2000 - 100);
  assert.deepEqual(cellSize(0, 20), cellSize(388, 20));
});

test('an all-stop is grave, parked and stale are shown, and an empty entry shows nothing', () => {
  const stopped = alarmsOf({helm: {state: 'ALL-STOP', all_stop: 'no NAV for 2.0 s'}, stale: true});
  assert.deepEqual(stopped.map(({grave}) => grave), [true, false]);
  assert.match(stopped[0].text, /no NAV for 2.0 s/);
  assert.equal(alarmsOf({helm: {state: 'ALL-STOP', all_stop: 'all_stop command'}})[0].text,
    'all-stop: by command');
  assert.equal(alarmsOf({helm: {state: 'PARK', all_stop: 'never deployed'}})[0].grave, false);
  assert.deepEqual(alarmsOf({helm: null}), []);
  assert.deepEqual(alarmsOf({helm: {state: 'DRIVE', all_stop: 'clear'}}), []);
});

test('a vehicle has the mode of its report, or that of its helm', () => {
  assert.equal(modeOf({mode: 'DRIVE survey', helm: null}), 'DRIVE survey');
  assert.equal(modeOf({mode: '', helm: {state: 'PARK', task: ''}}), 'PARK');
  assert.equal(modeOf({mode: '', helm: null}), '');
  assert.equal(shortMode({mode: 'DRIVE:loiter_west'}), 'loiter_west');
  assert.equal(shortMode({mode: 'DRIVE:'}), 'DRIVE:');
  assert.equal(shortMode({mode: 'ALL-STOP:survey'}), 'ALL-STOP:survey');
  assert.equal(reportAge({report: {t: 3}}, 5), 2);
  assert.equal(reportAge({report: null}, 5), null);
});

test('what a vehicle knows of another is shown in words', () => {
  assert.equal(contactWords({target: true, received: false, recovered: ['reporter_pos predict']}),
    'target, never received itself, recovered: reporter_pos predict');
  assert.equal(contactWords({received: true}), '');
});

test('the filter of status pages looks for all words, everywhere', () => {
  const page = {app: 'helm_alpha', text: 'Task survey', run_warnings: ['no NAV']};
  assert.ok(pageMatches(page, 'alpha nav'));
  assert.ok(pageMatches(page, 'SURVEY'));
  assert.ok(!pageMatches(page, 'bravo'));
});

test('a command shows its state and the reason', () => {
  assert.equal(commandWords({state: 'refused', reason: 'resume first'}), '✗ refused: resume first');
  assert.equal(commandWords({state: 'taken', reason: ''}), '✓ taken');
  assert.deepEqual(gotoWords({x: 100.04, y: -50}), ['goto', '100.0', '-50.0']);
});

test('grave events have their marks before all others', () => {
  const events = Array.from({length: 1000},
    (_, t) => ({t, kind: t % 10 ? 'lost_contact' : 'collision'}));
  const marks = marksOf(events, 150);
  assert.equal(marks.length, 150);
  assert.equal(marks.filter(({kind}) => kind === 'collision').length, 100);
  assert.ok(marks.every((mark, i) => i === 0 || marks[i - 1].t <= mark.t));
  assert.deepEqual(marksOf([], 10), []);
});

test('the top line shows how fast the mission goes', () => {
  assert.equal(clockWords({state: 'running', warp: 5, factor: 4.98}),
    '● running 4.98 × real time (of 5 ×)');
  assert.equal(clockWords({state: 'running', warp: 0, factor: 80}),
    '● running 80.00 × real time (of max)');
  assert.equal(clockWords({state: 'running', warp: null, factor: null}), '● running');
  assert.equal(clockWords({state: 'paused', warp: 5}), '❚❚ paused');
});

test('the banner shows what is the matter, and nothing where all is well', () => {
  assert.equal(bannerWords({state: 'running'}, 'live', ''), '');
  assert.match(bannerWords({state: 'running'}, 'lost', 'no news'), /Connection lost \(no news\)/);
  assert.match(bannerWords({state: 'gathering', awaited: ['helm_alpha']}, 'live', ''),
    /helm_alpha/);
  assert.match(bannerWords({state: 'waiting'}, 'live', ''), /shoal run/);
  assert.match(bannerWords({state: 'lost'}, 'live', ''), /launcher/);
});
