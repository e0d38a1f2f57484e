import assert from 'node:assert/strict';
import {test} from 'node:test';

import {Camera} from '../../../web/map/map_camera.js';
import {PresentPlan} from '../../../web/map/present_plan.js';
import {changedLines, handleWords, PlanEditor, tidyPlan, updatesBetween}
  from '../../../web/plan/plan_editor.js';
import {PlanLayer} from '../../../web/plan/plan_layer.js';

const way = (points, more = {}) => ({vehicle: 'alpha', name: 'survey', kind: 'waypoints', key: 'points',
  updates: '', shape: 'line', points, ...more});
const planOf = (handles, more = {}) => tidyPlan({file: 'm.toml', text: 'x', handles, ...more});

test('whatever comes is tidied', () => {
  for (const nonsense of [null, 7, [], {handles: 'x', errors: {}}, {handles: [null, {kind: 1}]}]) {
    const plan = tidyPlan(nonsense);
    assert.deepEqual([plan.handles, plan.errors, plan.vehicles], [[], [], []]);
  }
  assert.deepEqual(planOf([way([[1, 2], ['x', 3], null])]).handles[0].points, [[1, 2]]);
});

test('changed lines are those that differ, and no others', () => {
  assert.deepEqual(changedLines('a\nb\nc', 'a\nb\nc'), []);
  assert.deepEqual(changedLines('a\nb\nc', 'a\nB\nc'), [{line: 2, before: 'b', after: null},
    {line: 2, before: null, after: 'B'}]);
  assert.deepEqual(changedLines('a\nc', 'a\nb\nc'), [{line: 2, before: null, after: 'b'}]);
  const long = Array.from({length: 3000}, (_, i) => `line ${i}`);
  const other = long.map((line, i) => (i % 2 === 0 ? line : `${line}!`));
  assert.equal(changedLines(long.join('\n'), other.join('\n')).length, 2 * 2999);
});

test('what vehicles under way can take becomes orders, the rest is named', () => {
  const before = planOf([way([[1, 2]]), way([[0, 0]], {name: 'station', kind: 'station_keep',
    key: 'station_pt', updates: 'UPDATES', shape: 'point'}), way([[5, 5]], {name: '', kind: 'start',
    key: 'start', shape: 'point'}), way([[9, 9]], {name: 'still'})]);
  const after = planOf([way([[1, 2], [3, 4.5]]), way([[7, 8]], {name: 'station', kind: 'station_keep',
    key: 'station_pt', updates: 'UPDATES', shape: 'point'}), way([[6, 5]], {name: '', kind: 'start',
    key: 'start', shape: 'point'}), way([[9, 9]], {name: 'still'}), way([[0, 0]], {name: 'new'})]);
  const {orders, left} = updatesBetween(before, after);
  assert.deepEqual(orders, [{target: 'alpha', words: ['move', 'survey', '1', '2', '3', '4.5']},
    {target: 'alpha', words: ['set', 'UPDATES=station_pt = 7,8']}]);
  assert.deepEqual(left, ['alpha, start', 'alpha, new (waypoints)']);
  assert.equal(handleWords(way([], {vehicle: '', name: 'rock', kind: 'obstacle'})), 'rock (obstacle)');
});

test('an editor goes back step by step, and an answer that is late changes nothing', async () => {
  const waiting = [];
  const requests = {post: (path, body) => new Promise((done) => {
    const text = body.edit ? `${body.text}+` : body.text ?? 'file';
    if (body.slow) waiting.push(() => done({text}));
    else done({text});
  })};
  const editor = new PlanEditor(requests, () => {});
  await editor.open();
  await editor.edit({do: 'remove'});
  await editor.edit({do: 'remove'});
  assert.equal(editor.plan.text, 'file++');
  await editor.undo();
  assert.equal(editor.plan.text, 'file+');
  assert.ok(editor.isChanged);
  await editor.undo();
  await editor.undo();
  assert.equal(editor.plan.text, 'file');
  assert.ok(!editor.isChanged && !editor.canUndo);
  editor.close();
  assert.ok(!editor.isOpen);
});

test('points are dragged, middles become points, and clicks draw', () => {
  const camera = new Camera(400, 300);
  camera.set(0, 0, 1);
  const edits = [];
  const layer = new PlanLayer({onEdit: (edit) => edits.push(edit), onDrawn: (...all) => edits.push(all),
    onChosen: () => {}, onTool: () => {}});
  assert.equal(layer.press(camera, 200, 150), false, 'without a plan it takes nothing');
  layer.show(planOf([way([[0, 0], [100, 0]])]));
  assert.ok(layer.press(camera, 203, 148));
  layer.dragged(camera, 210, 140);
  layer.released(camera, 210.04, 140, true);
  assert.deepEqual(edits.pop(), {do: 'move', handle: 0, point: 0, points: [[10, 10]]});
  assert.ok(layer.press(camera, 250, 150), 'the middle of the leg');
  layer.released(camera, 250, 120, true);
  assert.deepEqual(edits.pop(), {do: 'insert', handle: 0, point: 1, points: [[50, 30]]});
  layer.choose(0, 1);
  layer.removeChosen();
  assert.deepEqual(edits.pop(), {do: 'remove', handle: 0, point: 1});
  assert.equal(layer.press(camera, 10, 10), false, 'beside all: the map is dragged');
  layer.setTool('survey');
  for (const [x, y] of [[200, 150], [300, 150], [300, 50], [300, 51]]) {
    layer.press(camera, x, y);
    layer.released(camera, x, y, false);
  }
  assert.deepEqual(edits.pop(), ['survey', [[0, 0], [100, 0], [100, 100]]]);
  layer.setTool('obstacle');
  layer.press(camera, 200, 150);
  layer.released(camera, 200, 150, false);
  assert.ok(!layer.finish(), 'one corner is no obstacle');
  assert.ok(layer.cancel());
  layer.setTool('__proto__');
  assert.equal(layer.tool, '');
});

test('the plan at a time is that of the file, moved by what the helms took until then', () => {
  const plan = new PresentPlan({vehicles: [{name: 'alpha', tasks: [{name: 'a', points: [[0, 0]]}],
    behaviors: [{name: 'b', points: [[1, 1]], area: [[NaN, 0]]}]}, null]});
  const event = (t, name, points) => ({t, kind: 'replanned', vehicles: ['alpha'],
    plan: {name, parts: [{name, points}]}});
  plan.setEvents([event(10, 'b', [[5, 5]]), event(20, 'b', [[6, 6]]), {t: 1, kind: 'replanned',
    vehicles: [], plan: {}}]);
  const at = (t) => plan.at(t).get('alpha').find(({name}) => name === 'b').points;
  assert.deepEqual([at(0), at(10), at(15), at(25), at(5)],
    [[[1, 1]], [[5, 5]], [[5, 5]], [[6, 6]], [[1, 1]]]);
  assert.deepEqual(plan.at(25).get('alpha').find(({name}) => name === 'a').points, [[0, 0]]);
  assert.deepEqual(plan.at(0).get('alpha')[0].area, []);
});
