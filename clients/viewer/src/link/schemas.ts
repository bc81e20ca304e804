import {create, createFileRegistry, fromBinary, toBinary, type DescMessage} from '@bufbuild/protobuf';
import {FileDescriptorSetSchema} from '@bufbuild/protobuf/wkt';

export type Decode = (payload: Uint8Array) => unknown;
export type Encode = (message: Record<string, unknown>) => Uint8Array;

function typeOf(name: string, schema: string): DescMessage {
  const bytes = Uint8Array.from(atob(schema), (letter) => letter.charCodeAt(0));
  const type: DescMessage | undefined =
      createFileRegistry(fromBinary(FileDescriptorSetSchema, bytes)).getMessage(name);
  if (type === undefined) throw new Error(`the server’s schema lacks message type ${name}: reload the page`);
  return type;
}

/**
 * A decoder for the Protobuf type `name`, made from the schema that the server advertises: the page carries no schema of
 * its own. `schema`: a FileDescriptorSet in base64. Throws if the set does not contain the type.
 */
export function decoderFor(name: string, schema: string): Decode {
  const type = typeOf(name, schema);
  return (payload) => fromBinary(type, payload);
}

/** The encoder for the type, the inverse of decoderFor. A message is an object with its fields in camelCase. */
export function encoderFor(name: string, schema: string): Encode {
  const type = typeOf(name, schema);
  return (message) => toBinary(type, create(type, message));
}
