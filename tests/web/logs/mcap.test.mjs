// `shoal log mcap`, read by the reader that MCAP's makers publish and by protobufjs.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { McapIndexedReader, McapStreamReader } from '@mcap/core';
import protobuf from 'protobufjs';
import 'protobufjs/ext/descriptor/index.js';

const root = join(import.meta.dirname ?? new URL('.', import.meta.url).pathname, '../../..');
const shoal = join(process.env.SHOAL_BINARY_DIR, 'bin/shoal');
const run = (...args) => execFileSync(shoal, args, { cwd: root, encoding: 'utf8' });

const folder = mkdtempSync(join(tmpdir(), 'shoal-mcap-'));
const log = join(folder, 'berta.lcm');
const counts = new Map(); // Messages of each topic.
const first = new Map(); // Decoded, of each topic.
let bytes;
let reader;

before(async () => {
  run('sim', 'missions/berta.toml', '--log', log);
  run('log', 'mcap', log, '--out', join(folder, 'berta.mcap'));
  run('log', 'csv', log, '--out', join(folder, 'csv'));
  bytes = readFileSync(join(folder, 'berta.mcap'));
  reader = await McapIndexedReader.Initialize({
    readable: {
      size: async () => BigInt(bytes.length),
      read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)),
    },
  });
  for await (const message of reader.readMessages()) {
    const channel = reader.channelsById.get(message.channelId);
    counts.set(channel.topic, (counts.get(channel.topic) ?? 0) + 1);
    if (first.has(channel.topic)) continue;
    const schema = reader.schemasById.get(channel.schemaId);
    const types = protobuf.Root.fromDescriptor(schema.data);
    const type = types.lookupType(schema.name);
    const content = type.toObject(type.decode(message.data), { defaults: true, longs: Number });
    first.set(channel.topic, { time: message.logTime, schema: schema.name, content });
  }
});
after(() => rmSync(folder, { recursive: true }));

test('has as many messages on each channel as the log', () => {
  let compared = 0;
  for (const line of run('log', 'info', log).split('\n')) {
    const row = /^([A-Z]\S*)\s+\S+_t\s+(\d+)\s/.exec(line);
    if (!row) continue;
    assert.equal(counts.get(row[1]), Number(row[2]), row[1]);
    compared += 1;
  }
  assert.equal(compared, [...counts.keys()].filter((topic) => !topic.includes('/')).length);
});

test('has the numbers of the log', () => {
  const [names, values] = readFileSync(join(folder, 'csv/NAV_ALPHA.csv'), 'utf8').split('\n')
    .map((line) => line.split(','));
  const { content, schema, time } = first.get('NAV_ALPHA');
  assert.equal(schema, 'shoal.nav_t');
  assert.equal(Number(time), Number(values[0]) * 1e9);
  let compared = 0;
  for (const [i, name] of names.entries()) {
    if (name.endsWith('time_s') || name === 'utime_s') continue;
    // The descriptor's order is that of the columns.
    assert.equal(Object.values(content)[i - 1], Number(values[i]), name);
    compared += 1;
  }
  assert.equal(compared, 19);
});

test('shows a place, a pose and lines of text', () => {
  const place = first.get('foxglove/location/ALPHA');
  assert.equal(place.schema, 'foxglove.LocationFix');
  assert.ok(Math.abs(place.content.latitude - 43.8253) < 0.1, `${place.content.latitude}`);
  assert.equal(counts.get('foxglove/location/ALPHA'), counts.get('NAV_ALPHA'));
  assert.equal(first.get('foxglove/pose/ALPHA').content.frame_id, 'mission');
  assert.equal(first.get('foxglove/fates').schema, 'foxglove.Log');
  assert.match(first.get('foxglove/fates').content.message, / to /);
});

test('is whole by its checksums, read from begin to end', () => {
  const stream = new McapStreamReader({ validateCrcs: true });
  stream.append(bytes);
  let messages = 0n;
  for (let record; (record = stream.nextRecord());) if (record.type === 'Message') messages += 1n;
  assert.ok(stream.done());
  assert.equal(messages, reader.statistics.messageCount);
});
