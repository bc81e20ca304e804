import {createFileRegistry, fromBinary, type DescMessage} from '@bufbuild/protobuf';
import {FileDescriptorSetSchema} from '@bufbuild/protobuf/wkt';

export type Decode = (payload: Uint8Array) => unknown;

/**
 * A decoder for the Protobuf type `name`, made from the schema that the server advertises, so that the viewer carries
 * no types of its own. `schema`: a FileDescriptorSet in base64. Throws when the set does not hold the type.
 */
export function decoderFor(name: string, schema: string): Decode {
  const bytes = Uint8Array.from(atob(schema), (letter) => letter.charCodeAt(0));
  const type: DescMessage | undefined =
      createFileRegistry(fromBinary(FileDescriptorSetSchema, bytes)).getMessage(name);
  if (type === undefined) throw new Error(`the server's schema does not hold ${name}`);
  return (payload) => fromBinary(type, payload);
}
