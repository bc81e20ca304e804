// node write_conformance.mjs FOLDER COMPRESSOR: the variants of MCAP's public conformance set, made by @mcap/core's record
// builder. A file is FOLDER/DATA-FEATURES.mcap; a variant with chunks exists compressed, too: DATA-FEATURES.zstd.mcap.
// Features: ch chunks, mx message indexes, st statistics, rsh and rch schemas and channels repeated in the summary,
// ax, mdx and chx indexes of attachments, metadata and chunks, sum summary offsets, pad bytes after each record's fields.
import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { McapConstants, McapChunkBuilder, McapRecordBuilder } from "@mcap/core";

const [folder, compressor] = process.argv.slice(2);
const { Opcode } = McapConstants;
const FEATURES = ["ch", "mx", "st", "rsh", "rch", "ax", "mdx", "chx", "sum", "pad"];

const schema = { type: "Schema", id: 1, name: "Example", encoding: "c", data: Uint8Array.of(4, 5, 6) };
const channel = { type: "Channel", id: 1, topic: "example", schemaId: 1, messageEncoding: "a", metadata: new Map([["foo", "bar"]]) };
const message = (sequence, publishTime, logTime) => ({
  type: "Message", channelId: 1, sequence, publishTime, logTime, data: Uint8Array.of(1, 2, 3),
});
const attachment = {
  type: "Attachment", name: "myFile", mediaType: "application/octet-stream", logTime: 2n, createTime: 1n, data: Uint8Array.of(1, 2, 3),
};
const TIMES = [0n, 2n, 1n, 3n, 3n, 5n, 4n, 7n, 8n, 9n]; // the writer's order is not the order of time
const DATA = {
  NoData: [],
  OneSchemalessMessage: [{ ...channel, schemaId: 0, messageEncoding: "text", metadata: new Map() }, message(10, 1n, 2n)],
  OneMessage: [schema, channel, message(10, 1n, 2n)],
  OneAttachment: [attachment],
  OneMetadata: [{ type: "Metadata", name: "myMetadata", metadata: new Map([["foo", "bar"]]) }],
  TenMessages: [schema, channel, ...TIMES.map((time, sequence) => message(sequence, time, time))],
};

/** Whether a file of these records can have these features. */
function makesSense(records, has) {
  const contains = (...types) => records.some((record) => types.includes(record.type));
  const needs = { ax: ["Attachment"], mdx: ["Metadata"], rsh: ["Schema"], rch: ["Channel"], ch: ["Message"] };
  if (Object.entries(needs).some(([feature, types]) => has(feature) && !contains(...types))) return false;
  if (!has("ch") && (has("chx") || has("mx"))) return false;
  return !has("sum") || ["chx", "rsh", "rch", "mdx", "ax", "st"].some(has);
}

const compressed = new Map();
function compress(name, bytes) {
  const key = name + Buffer.from(bytes).toString("hex");
  if (name !== "" && !compressed.has(key)) {
    const done = spawnSync(compressor, [name], { input: bytes });
    if (done.status !== 0) throw new Error(`${compressor} ${name}: ${done.stderr}`);
    compressed.set(key, new Uint8Array(done.stdout));
  }
  return compressed.get(key) ?? bytes;
}

/** Writes the data section; returns the indexes for the summary. */
function writeData(file, records, has, compression) {
  const indexes = { chunks: [], attachments: [], metadata: [] };
  const chunk = has("ch") ? new McapChunkBuilder({ useMessageIndex: has("mx") }) : undefined;
  for (const record of records) {
    const offset = BigInt(file.length);
    if (record.type === "Attachment")
      indexes.attachments.push({ ...record, offset, length: file.writeAttachment(record), dataSize: BigInt(record.data.length) });
    else if (record.type === "Metadata") indexes.metadata.push({ name: record.name, offset, length: file.writeMetadata(record) });
    else if (chunk) chunk[`add${record.type}`](record);
    else file[`write${record.type}`](record);
  }
  if (chunk) {
    const { messageStartTime, messageEndTime } = chunk;
    const plain = new Uint8Array(chunk.buffer);
    const bytes = compress(compression, plain);
    const about = { messageStartTime, messageEndTime, compression, uncompressedSize: BigInt(plain.length) };
    const chunkStartOffset = BigInt(file.length);
    const chunkLength = file.writeChunk({ ...about, uncompressedCrc: 0, records: bytes });
    const messageIndexOffsets = new Map();
    let messageIndexLength = 0n;
    for (const index of has("mx") ? chunk.indices : []) {
      messageIndexOffsets.set(index.channelId, BigInt(file.length));
      messageIndexLength += file.writeMessageIndex(index);
    }
    indexes.chunks.push({
      ...about, chunkStartOffset, chunkLength, messageIndexOffsets, messageIndexLength, compressedSize: BigInt(bytes.length),
    });
  }
  return indexes;
}

function statistics(records) {
  const of = (type) => records.filter((record) => record.type === type);
  const times = of("Message").map((record) => record.logTime).sort((a, b) => Number(a - b));
  return {
    schemaCount: of("Schema").length, channelCount: of("Channel").length, messageCount: BigInt(times.length),
    attachmentCount: of("Attachment").length, metadataCount: of("Metadata").length,
    messageStartTime: times[0] ?? 0n, messageEndTime: times.at(-1) ?? 0n,
    channelMessageCounts: new Map(times.length > 0 ? [[1, BigInt(times.length)]] : []),
  };
}

function fileOf(records, has, compression) {
  const file = new McapRecordBuilder({ padRecords: has("pad") });
  file.writeMagic();
  file.writeHeader({ profile: "", library: "" });
  const indexes = writeData(file, records, has, compression);
  file.writeDataEnd({ dataSectionCrc: 0 });
  const summaryStart = BigInt(file.length);
  const groups = [];
  const group = (opcode, wanted, write) => {
    const groupStart = BigInt(file.length);
    if (wanted) write();
    const groupLength = BigInt(file.length) - groupStart;
    if (groupLength > 0n) groups.push({ groupOpcode: opcode, groupStart, groupLength });
  };
  const repeat = (type) => () => records.filter((record) => record.type === type).forEach((record) => file[`write${type}`](record));
  group(Opcode.SCHEMA, has("rsh"), repeat("Schema"));
  group(Opcode.CHANNEL, has("rch"), repeat("Channel"));
  group(Opcode.STATISTICS, has("st"), () => file.writeStatistics({ ...statistics(records), chunkCount: indexes.chunks.length }));
  group(Opcode.METADATA_INDEX, has("mdx"), () => indexes.metadata.forEach((index) => file.writeMetadataIndex(index)));
  group(Opcode.ATTACHMENT_INDEX, has("ax"), () => indexes.attachments.forEach((index) => file.writeAttachmentIndex(index)));
  group(Opcode.CHUNK_INDEX, has("chx"), () => indexes.chunks.forEach((index) => file.writeChunkIndex(index)));
  const hasSummary = BigInt(file.length) !== summaryStart;
  const summaryOffsetStart = has("sum") ? BigInt(file.length) : 0n;
  if (has("sum")) groups.forEach((one) => file.writeSummaryOffset(one));
  file.writeFooter({ summaryStart: hasSummary ? summaryStart : 0n, summaryOffsetStart, summaryCrc: 0 });
  file.writeMagic();
  return file.buffer;
}

let count = 0;
for (const [name, records] of Object.entries(DATA))
  for (let bits = 0; bits < 1 << FEATURES.length; ++bits) {
    const chosen = FEATURES.filter((_, at) => (bits >> at) & 1);
    const has = (feature) => chosen.includes(feature);
    if (!makesSense(records, has)) continue;
    ++count;
    for (const compression of has("ch") ? ["", "zstd", "lz4"] : [""]) {
      const file = `${folder}/${[name, ...chosen].join("-")}${compression && `.${compression}`}.mcap`;
      writeFileSync(file, fileOf(records, has, compression));
    }
  }
console.log(`${count} variants`);
