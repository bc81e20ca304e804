// Checks a list of parts by the standard's own schema: node cyclonedx.mjs FILE prints each error.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {fileURLToPath} from 'node:url';

const require = createRequire(new URL('../npm/package.json', import.meta.url));
const SCHEMAS = new URL('../npm/node_modules/@cyclonedx/cyclonedx-library/res/schema/', import.meta.url);

const schema = (name) => JSON.parse(readFileSync(new URL(name, SCHEMAS), 'utf8'));

/** What is wrong with `bom` as CycloneDX 1.5, as texts. */
export function cyclonedxErrors(bom) {
  const Ajv = require('ajv').default;
  const ajv = new Ajv({strict: false, allErrors: true});
  for (const name of ['spdx.SNAPSHOT.schema.json', 'jsf-0.82.SNAPSHOT.schema.json'])
    ajv.addSchema({...schema(name), $id: `http://cyclonedx.org/schema/${name}`});
  require('ajv-formats').default(ajv);
  ajv.addFormat('iri-reference', true);
  ajv.addFormat('idn-email', true);
  const check = ajv.compile(schema('bom-1.5.SNAPSHOT.schema.json'));
  return check(bom) ? [] : check.errors.map(({instancePath, message}) => `${instancePath}: ${message}`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const errors = cyclonedxErrors(JSON.parse(readFileSync(process.argv[2], 'utf8')));
  for (const error of errors) console.error(error);
  process.exitCode = errors.length === 0 ? 0 : 1;
}
