// node check_mcap.mjs FILE.mcap EXPECTED.json: whether @mcap/core reads from the file exactly what was written to it.
// EXPECTED.json: {"chunks", "messages": [{topic, schema, time, sequence, payload (base64), fields (as Protobuf JSON)}]}
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { crc32 } from "@foxglove/crc";
import { decoders, readIndexed, readStream } from "./mcap_file.mjs";

const [file, expectedFile] = process.argv.slice(2);
const expected = JSON.parse(await readFile(expectedFile, "utf8"));

/** One decoded field against Protobuf's own JSON of it: bytes are base64 there, 64-bit numbers and enums text. */
function assertSame(decoded, json, type, path) {
  if (json === undefined) return;
  if (type?.fullName === ".google.protobuf.Timestamp") {
    const ms = Number(decoded.seconds) * 1000 + Math.floor((decoded.nanos ?? 0) / 1e6);
    return assert.equal(ms, Date.parse(json), path);
  }
  if (decoded instanceof Uint8Array) return assert.equal(Buffer.from(decoded).toString("base64"), json, path);
  if (type?.valuesById) return assert.equal(type.valuesById[decoded], json, path);
  if (type?.fields) {
    for (const key of Object.keys(json)) {
      const field = type.fields[key];
      assert.ok(field, `${path}: the schema has no field ${key}`);
      field.resolve();
      if (!field.repeated) assertSame(decoded[key], json[key], field.resolvedType, `${path}.${key}`);
      else json[key].forEach((item, at) => assertSame(decoded[key][at], item, field.resolvedType, `${path}.${key}`));
    }
    return;
  }
  if (typeof json === "string") return assert.equal(decoded.toString(), json, path);
  assert.equal(decoded, json, path);
}

const { reader, messages, metadata } = await readIndexed(file);
const decode = decoders(reader.schemasById);
const byChannel = {};
assert.equal(messages.length, expected.messages.length, "how many messages the index reaches");
assert.equal(Number(reader.statistics.messageCount), expected.messages.length);
assert.equal(reader.statistics.chunkCount, expected.chunks);
assert.equal(reader.chunkIndexes.length, expected.chunks);
messages.forEach((message, at) => {
  const wanted = expected.messages[at];
  const channel = reader.channelsById.get(message.channelId);
  const schema = reader.schemasById.get(channel.schemaId);
  assert.equal(channel.topic, wanted.topic);
  assert.equal(channel.messageEncoding, "protobuf");
  assert.equal(schema.name, wanted.schema);
  assert.equal(message.logTime.toString(), wanted.time);
  assert.equal(message.publishTime.toString(), wanted.time);
  assert.equal(message.sequence, wanted.sequence);
  assert.ok(Buffer.from(wanted.payload, "base64").equals(Buffer.from(message.data)), `payload of message ${at}`);
  const decoded = decode.get(schema.id)(message.data);
  assertSame(decoded, wanted.fields, decoded.$type, `message ${at} ${wanted.topic}`);
  assert.equal(channel.metadata.get("frames") ?? "not marked", wanted.frames);
  byChannel[channel.id] = (byChannel[channel.id] ?? 0) + 1;
});
for (const [id, count] of reader.statistics.channelMessageCounts)
  assert.equal(Number(count), byChannel[id]);

const session = metadata.find((record) => record.name === "telepalp.session");
assert.equal(session.metadata.get("program"), "telepalp-test");
assert.equal(session.metadata.get("scene"), "skin { }");

const records = await readStream(file);
assert.equal(records.filter((record) => record.type === "Message").length, expected.messages.length);
const bytes = await readFile(file);
const dataEnd = records.find((record) => record.type === "DataEnd");
assert.equal(crc32(bytes.subarray(0, Number(reader.dataEndOffset))), dataEnd.dataSectionCrc, "CRC of the data section");
console.log(`${messages.length} messages on ${reader.channelsById.size} channels in ${expected.chunks} chunks: the same`);
