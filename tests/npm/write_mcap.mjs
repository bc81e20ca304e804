// node write_mcap.mjs OUT.mcap MESSAGES.json OPTIONS.json: an MCAP file made by @mcap/core.
// OPTIONS: {chunkSize, compression: "" | "zstd" | "lz4" | a name that is not read, compressor: program, writer: {…}}
import { spawnSync } from "node:child_process";
import { readFile, writeFile } from "node:fs/promises";
import { McapWriter } from "@mcap/core";

const [out, messagesFile, optionsFile] = process.argv.slice(2);
const { messages, schemas } = JSON.parse(await readFile(messagesFile, "utf8"));
const options = JSON.parse(await readFile(optionsFile, "utf8"));

function compressChunk(chunk) {
  const { compression, compressor } = options;
  if (!compressor) return { compression, compressedData: chunk }; // only its name is read
  const done = spawnSync(compressor, [compression], { input: chunk, maxBuffer: 1 << 28 });
  if (done.status !== 0) throw new Error(`${compressor}: ${done.stderr}`);
  return { compression, compressedData: done.stdout };
}

const parts = [];
let size = 0n;
const writable = {
  position: () => size,
  write: async (bytes) => {
    parts.push(Buffer.from(bytes));
    size += BigInt(bytes.length);
  },
};
const writer = new McapWriter({
  writable,
  chunkSize: options.chunkSize,
  ...(options.compression === "" ? {} : { compressChunk }),
  ...options.writer,
});
await writer.start({ profile: "", library: "@mcap/core" });
await writer.addMetadata({ name: "note", metadata: new Map([["from", "@mcap/core"]]) });
await writer.addAttachment({
  name: "a.txt",
  mediaType: "text/plain",
  logTime: 1n,
  createTime: 2n,
  data: new TextEncoder().encode("attached"),
});
const schemaIds = new Map();
for (const [name, data] of Object.entries(schemas))
  schemaIds.set(name, await writer.registerSchema({ name, encoding: "protobuf", data: Buffer.from(data, "base64") }));
const channels = new Map();
for (const message of messages) {
  if (!channels.has(message.topic))
    channels.set(
      message.topic,
      await writer.registerChannel({
        topic: message.topic,
        schemaId: schemaIds.get(message.schema),
        messageEncoding: "protobuf",
        metadata: new Map(),
      }),
    );
  await writer.addMessage({
    channelId: channels.get(message.topic),
    sequence: message.sequence,
    logTime: BigInt(message.time),
    publishTime: BigInt(message.time),
    data: Buffer.from(message.payload, "base64"),
  });
}
await writer.end();
await writeFile(out, Buffer.concat(parts));
