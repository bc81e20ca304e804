// The figures that the architecture test counts, which knows the laws and their exceptions.
import {spawnSync} from 'node:child_process';
import {existsSync} from 'node:fs';
import {join} from 'node:path';

import {atMost} from './rows.mjs';

const TEST = 'build/release/bin/architecture_test';

/** The row of the files that decide on key frames; a note instead, if the test has not been built, or counts none. */
export function lawRows(checkout, notes) {
  const program = join(checkout, TEST);
  if (!existsSync(program)) {
    notes.push('skipped: the files that decide on key frames. fix: deploy/build release architecture_test');
    return [];
  }
  const {stdout} = spawnSync(program, ['--gtest_filter=Architecture.*KeyFrame*'], {encoding: 'utf8'});
  const files = /^(\d+) files outside codec and the topics' table decide on key frames$/m.exec(stdout)?.[1];
  if (files === undefined) {
    notes.push(`skipped: the files that decide on key frames, because ${TEST} prints no number of them. fix: build it again`);
    return [];
  }
  return [atMost('files that decide on key frames outside codec and the table of topics', Number(files), 'files', 0)];
}
