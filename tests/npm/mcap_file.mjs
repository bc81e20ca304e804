// A session file as @mcap/core sees it, with messages decoded by the schemas that it carries.
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { decompress as unzstd } from "fzstd";
import { readFile } from "node:fs/promises";
import protobuf from "protobufjs";
import "protobufjs/ext/descriptor/index.js";

const decompressHandlers = { zstd: (bytes, size) => unzstd(bytes, new Uint8Array(Number(size))) };

class Bytes {
  constructor(bytes) {
    this.bytes = bytes;
  }
  async size() {
    return BigInt(this.bytes.length);
  }
  async read(offset, length) {
    return this.bytes.subarray(Number(offset), Number(offset + length));
  }
}

/** Types by schema id, made from each schema's FileDescriptorSet and nothing else. */
export function typesOf(schemas) {
  const bySchema = new Map();
  for (const schema of schemas.values()) {
    if (schema.encoding !== "protobuf") throw new Error(`${schema.name}: encoding ${schema.encoding}`);
    const set = protobuf.descriptor.FileDescriptorSet.decode(schema.data);
    bySchema.set(schema.id, protobuf.Root.fromDescriptor(set).lookupType(schema.name));
  }
  return bySchema;
}

/** Decoders by schema id. */
export function decoders(schemas) {
  return new Map([...typesOf(schemas)].map(([id, type]) => [id, (bytes) => type.decode(bytes)]));
}

/** Through the index: { reader, messages } with messages in the reader's order. */
export async function readIndexed(file) {
  const readable = new Bytes(await readFile(file));
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  const messages = [];
  for await (const message of reader.readMessages({ validateCrcs: true })) messages.push(message);
  const metadata = [];
  for await (const record of reader.readMetadata()) metadata.push(record);
  return { reader, messages, metadata };
}

/** From front to back, with every CRC checked: the records. */
export async function readStream(file) {
  const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  stream.append(await readFile(file));
  const records = [];
  for (let record; (record = stream.nextRecord()); ) records.push(record);
  if (!stream.done()) throw new Error("the file does not end as it should");
  return records;
}
