import assert from 'node:assert/strict';
import {test} from 'node:test';

import {actionOf, kKeys} from '../../../web/page/help.js';

const press = (key, target = {tagName: 'BODY'}, more = {}) => actionOf({key, target, ...more});

test('keys do what the sheet shows', () => {
  assert.equal(press('f'), 'fit');
  assert.equal(press('V'), 'unfollow');
  assert.equal(press('0'), 'layer9');
  assert.equal(press('F1'), 'help');
  assert.equal(press('q'), null);
});

test('no key means two things', () => {
  const keys = kKeys.flatMap(({actions}) => Object.keys(actions));
  assert.equal(new Set(keys).size, keys.length);
});

test('nothing happens while a user types in a field', () => {
  for (const type of ['text', 'search', 'number']) {
    assert.equal(press('f', {tagName: 'INPUT', type}), null);
    assert.equal(press('X', {tagName: 'INPUT', type}), null);
  }
  assert.equal(press('f', {tagName: 'TEXTAREA'}), null);
  assert.equal(press('f', {tagName: 'DIV', isContentEditable: true}), null);
  assert.equal(press('c', {tagName: 'SELECT'}), null);
  assert.equal(press('Escape', {tagName: 'INPUT', type: 'text'}), 'escape');
});

test('the browser keeps its own keys', () => {
  for (const modifier of ['ctrlKey', 'metaKey', 'altKey']) {
    assert.equal(press('f', undefined, {[modifier]: true}), null);
  }
});

test('a button, a tab and the time line keep the keys that they use themselves', () => {
  assert.equal(press(' ', {tagName: 'BUTTON'}), null);
  assert.equal(press('ArrowLeft', {tagName: 'BUTTON', role: 'tab'}), null);
  assert.equal(press('ArrowLeft', {tagName: 'INPUT', type: 'range'}), null);
  assert.equal(press(' ', {tagName: 'INPUT', type: 'range'}), 'play');
  assert.equal(press(' ', {tagName: 'INPUT', type: 'checkbox'}), null);
  assert.equal(press('f', {tagName: 'BUTTON'}), 'fit');
});
