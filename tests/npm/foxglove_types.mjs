// The message types that Foxglove publishes (npm's @foxglove/schemas), and whether the types in a file are the same.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import protobuf from "protobufjs";

const { foxgloveEnumSchemas, foxgloveMessageSchemas, generateProto } =
  createRequire(import.meta.url)("@foxglove/schemas/internal");

/** All published types, in one protobufjs root. */
export function publishedTypes() {
  const root = new protobuf.Root();
  for (const name of ["timestamp", "duration"]) root.addJSON(protobuf.common.get(`google/protobuf/${name}.proto`).nested);
  for (const schema of Object.values(foxgloveMessageSchemas)) {
    const enums = Object.values(foxgloveEnumSchemas).filter((one) => one.parentSchemaName === schema.name);
    protobuf.parse(generateProto(schema, enums), root, { keepCase: true });
  }
  root.resolveAll();
  return root;
}

/** Each field of `ours`, and of the types within it, has the published number, type and multiplicity. */
export function assertPublished(ours, published, path = ours.name) {
  for (const field of ours.fieldsArray) {
    const theirs = published.fields[field.name];
    assert.ok(theirs, `${path}.${field.name} is a published field`);
    assert.equal(field.id, theirs.id, `${path}.${field.name}: number`);
    assert.equal(field.repeated, theirs.repeated, `${path}.${field.name}: repeated`);
    field.resolve();
    theirs.resolve();
    const [own, other] = [field.resolvedType, theirs.resolvedType];
    if (own instanceof protobuf.Enum) assert.deepEqual({ ...own.values }, { ...other.values }, `${path}.${field.name}: values`);
    else if (own instanceof protobuf.Type) assertPublished(own, other, `${path}.${field.name}`);
    else assert.equal(field.type, theirs.type, `${path}.${field.name}: type`);
  }
}
