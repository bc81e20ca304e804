// deploy/size counts what it says, on small sources whose figures are known: node size_test.mjs SOURCE_DIR
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {after, test} from 'node:test';

const sourceDir = process.argv[2];
const numbers = (file) => import(join(sourceDir, 'deploy/numbers', file));
const {codeLines} = await numbers('cpp_text.mjs');
const {functionsIn, membersOf} = await numbers('cpp_blocks.mjs');
const {archivesIn, minimalStatus} = await numbers('packages.mjs');

const made = [];
after(() => made.forEach((folder) => rmSync(folder, {recursive: true, force: true})));

test('a line counts unless it is blank or only a comment', () => {
  for (const [text, lines] of [
    ['', 0], ['\n  \n\t\n', 0], ['int a;\n\n// no\nint b;  // yes\n', 2], ['/* no\n no */ int a;\n', 1], ['#include <x>\n', 1],
    ['auto url = "http://x";\n', 1], ['auto a = "/*";\nint b;\nauto c = "*/";\n', 3], ["char a = '\"';\n// no\n", 1],
    ['int a = 10\'000;\n// it\'s no\nint b;\n', 2], ['auto a = R"(\n// in a raw string\n)";\n', 3], ['/// no\n}  // namespace\n', 1],
  ])
    assert.equal(codeLines(text), lines, text);
});

test('functions are found with their lines, whatever stands around them', () => {
  const text = `namespace a::b {
enum class Kind { One, Two };
constexpr int kTable[] = {1, 2,
                          3};
template <class T>
T twice(const T& of) noexcept {
  if (of > 0) { return of; }
  return 2 * of;
}
class Box : public Base {
 public:
  explicit Box(int a, Options o = {}) : Base(a), a_{a}, list_{{1, 2}} {
    use(a);
  }
  auto size() const -> std::vector<int> { return {a_}; }
  bool operator==(const Box& other) const = default;
  std::function<void(int)> on{};
 private:
  int a_ = 0;
};
#define BLOCK {
TEST(Box, Holds) {
  const auto deep = [](int a) {
    return a;
  };
}
}  // namespace`;
  assert.deepEqual(functionsIn(text).map(({name, line, lines}) => [name, line, lines]),
                   [['twice', 5, 5], ['Box', 12, 3], ['size', 15, 1], ['TEST', 22, 5]]);
});

test('a function of 61 lines is one too many, and one of 60 is not', () => {
  const of = (lines) => `void f() {\n${'  g();\n'.repeat(lines - 2)}}\n`;
  assert.equal(functionsIn(of(60))[0].lines, 60);
  assert.equal(functionsIn(of(61))[0].lines, 61);
});

test('members are the fields of the class itself', () => {
  const text = `class Other { int no_; };
class Station;
class Station final : public Base {
 public:
  struct Options { int no_ = 0; };
  Station(int a, int b) : first_(a), table_{b} {}
  int first() const { return first_; }
  [[nodiscard]] const int& at(int no_) const noexcept;
 private:
  std::map<int, std::vector<int>> table_;  // not this_;
  int first_ = 0, second_{1};
  std::function<void(int no_)> call_;
  std::atomic<bool> flags_[4]{};
  const char* text_ = "no_;";
  unsigned bits_ : 3;
  static constexpr int kConstant = 1;
};`;
  assert.deepEqual(membersOf(text, 'Station'), ['table_', 'first_', 'second_', 'call_', 'flags_', 'text_', 'bits_']);
  assert.equal(membersOf(text, 'Connection'), undefined);
});

/** A checkout with one commit for each of `commits`: path to text, null to delete. */
function repository(...commits) {
  const folder = mkdtempSync(join(tmpdir(), 'size-test-'));
  made.push(folder);
  const git = (...words) => execFileSync('git', ['-C', folder, '-c', 'user.name=test', '-c', 'user.email=test@test', ...words]);
  git('init', '-q', '-b', 'main');
  for (const files of commits) {
    for (const [path, text] of Object.entries(files)) {
      mkdirSync(dirname(join(folder, path)), {recursive: true});
      if (text === null) rmSync(join(folder, path));
      else writeFileSync(join(folder, path), text);
    }
    git('add', '-A');
    git('commit', '-q', '--allow-empty', '-m', 'a commit');
  }
  return folder;
}

function size(folder, ...words) {
  const {status, stdout, stderr} = spawnSync(join(sourceDir, 'deploy/size'), ['--source', folder, ...words], {encoding: 'utf8'});
  return {status, stdout, stderr};
}

function rowOf(folder, name, ...words) {
  const {status, stdout, stderr} = size(folder, '--json', ...words);
  const report = JSON.parse(stdout);
  assert.equal(report.bench, 'size', stderr);
  assert.equal(status, report.rows.every(({holds}) => holds) ? 0 : 1, 'the exit code is that of the rows');
  return report.rows.find((row) => row.name.includes(name));
}

const small = (members) => `class C {\n${members.map((name) => `  int ${name};\n`).join('')}};\n`;
const classes = Object.fromEntries(['Station', 'ClientLink', 'SessionPlayer', 'Connection', 'HapticLoop'].map(
  (name) => [`server/${name}.h`, small(['a_']).replace('class C', `class ${name}`)]));
const lines = (count) => 'int a;\n'.repeat(count);

test('lines are counted against the base, without tests, with what is apart in a row of its own', () => {
  const folder = repository(
    {...classes, 'server/old.cpp': lines(3500), 'tests/a.cpp': lines(9000), 'page.ts': lines(9000)},
    {'server/old.cpp': null, 'server/new.cpp': lines(400), 'tests/a.cpp': null, 'core/journal/j.cpp': lines(200)}, {});
  assert.deepEqual(rowOf(folder, 'removed since', '--base', 'HEAD~2').value, 2900);
  const row = rowOf(folder, 'removed since', '--base', 'HEAD~2', '--apart', 'core/journal');
  assert.deepEqual(row, {name: row.name, value: 3100, unit: 'lines', reach: 3000, holds: true});
  assert.equal(rowOf(folder, 'added apart', '--base', 'HEAD~2', '--apart', 'core/journal').value, 200);
  assert.equal(rowOf(folder, 'removed since').value, 0, 'without --base: against the commit before the last');
});

test('every planted defect makes its row miss, and names the place', () => {
  const judge = 'void f() {\n  loop::TickIn in{};\n  const auto out = loop_.tick(in);\n';
  const tick = `${judge}  rig_.apply(out.force, 0.0005);\n}\n`;
  const sound = {...classes, 'haptic_station/loop/rig_tick.h': tick, 'haptic_station/core/judge.cpp': `${judge}}\n`, 'tests/t.cpp': tick};
  const defects = [
    ["tick's sequence", {'tools/replay/copy.cpp': tick}, 'tools/replay/copy.cpp'],
    ['members of Station', {'server/Station.h': small(Array.from({length: 16}, (_, at) => `m${at}_`)).replace('class C', 'class Station')}, undefined],
    ['members of HapticLoop', {'server/HapticLoop.h': 'class Renamed {};\n'}, 'there is no class HapticLoop'],
    ['over 60 lines', {'server/long.cpp': `int longest() {\n${lines(70)}}\n`}, 'server/long.cpp:1 longest (72)'],
  ];
  const holds = repository(sound);
  for (const [name, files, place] of defects) {
    assert.equal(rowOf(holds, name).holds, true, name);
    const folder = repository({...sound, ...files});
    assert.equal(rowOf(folder, name).holds, false, name);
    if (place !== undefined) assert.ok(size(folder).stderr.includes(place), size(folder).stderr);
  }
});

test('the files that decide on key frames are those that the architecture test counts', () => {
  const program = join(sourceDir, 'build/release/bin/architecture_test');
  const counted = existsSync(program) && / (\d+) files outside codec/.exec(
    ` ${spawnSync(program, ['--gtest_filter=Architecture.*KeyFrame*'], {encoding: 'utf8'}).stdout.replaceAll('\n', ' ')}`)?.[1];
  const {stdout, stderr} = size(sourceDir, '--json', '--base', 'HEAD');
  assert.notEqual(stdout, '', stderr);
  const row = JSON.parse(stdout).rows.find(({name}) => name.startsWith('files that decide on key frames'));
  if (counted) assert.equal(row.value, Number(counted));
  else assert.match(stderr, /skipped: the files that decide on key frames/);
});

test('what cannot be measured here is skipped and said', () => {
  const folder = repository(classes);  // a single commit, as in a shallow clone
  const {stdout, stderr} = size(folder, '--json');
  for (const said of ['skipped: the processor time of a build', 'skipped: the files that decide on key frames', 'skipped: the lines removed', 'has no package telepalp-clients'])
    assert.ok(stderr.includes(said), stderr);
  assert.ok(!stdout.includes('processor time'));
  assert.equal(size(folder, '--base', 'nowhere').status, 2);
  assert.equal(size(folder, '--bild').status, 2);
  assert.equal(size(folder, '--base').status, 2);
});

test('the build row is the ratio of processor times of the two commits', () => {
  const project = (work) => ({...classes, 'CMakeLists.txt': `cmake_minimum_required(VERSION 3.25)
project(small NONE)
find_program(CCACHE NAMES ccache sh)
find_program(NPM NAMES npm sh)
if(CCACHE OR NPM OR TELEPALP_NPM)
  message(FATAL_ERROR "a measured build has neither ccache nor npm")
endif()
add_custom_target(work ALL COMMAND sh -c "i=0; while [ $i -lt ${work} ]; do i=$((i+1)); done" VERBATIM)
`});
  const folder = repository(project(600000), project(60000));
  const row = rowOf(folder, "of the base's", '--build');
  assert.ok(row.value > 0 && row.value < 0.6 && row.holds, JSON.stringify(row));
  const back = repository(project(60000), project(600000));
  assert.equal(rowOf(back, "of the base's", '--build').holds, false);
});

test('a minimal Debian has the required packages and what they depend on', () => {
  const status = 'Package: libc6\nStatus: install ok installed\nVersion: 1\n\nPackage: bash\nEssential: yes\nPre-Depends: libc6 (>= 1), libx | liby\n' +
      'Description: a shell\n with Essential: no\n\nPackage: libpcl\nPriority: optional\nDepends: libc6\n\nPackage: liby\nPriority: optional\n';
  assert.deepEqual([...minimalStatus(status).matchAll(/^Package: (.*)$/gm)].map(([, name]) => name).sort(), ['bash', 'libc6', 'liby']);
  const uris = "Reading package lists...\n'http://x/pool/libpcl-io_1%2b2_amd64.deb' libpcl-io1.13_1.13.0_amd64.deb 123456 MD5Sum:00\n" +
      "'file:/x/telepalp-data_1_all.deb' telepalp-data_1_all.deb 99 \n";
  assert.deepEqual(archivesIn(uris), [{name: 'libpcl-io1.13', bytes: 123456}, {name: 'telepalp-data', bytes: 99}]);
});

/** A folder with the packages of a thin client, which needs `needs`. */
function thinClient(needs) {
  const folder = mkdtempSync(join(tmpdir(), 'size-test-'));
  made.push(folder);
  for (const [name, depends] of [['telepalp-clients', `telepalp-data, ${needs}`], ['telepalp-data', 'libc6']]) {
    mkdirSync(join(folder, name, 'DEBIAN'), {recursive: true});
    writeFileSync(join(folder, name, 'DEBIAN/control'), `Package: ${name}\nVersion: 1\nArchitecture: all\nMaintainer: nobody\n` +
        `Depends: ${depends}\nDescription: made by a test\n`);
    execFileSync('dpkg-deb', ['--build', '-Zgzip', join(folder, name), join(folder, `${name}_1_all.deb`)]);
  }
  return folder;
}

const aptKnows = (name) => spawnSync('apt-cache', ['show', name]).status === 0;

test('a thin client that needs a camera driver misses', {skip: aptKnows('libopenni2-0') ? false : 'apt has no lists of packages'}, () => {
  const folder = repository(classes);
  const [thin, thick] = [thinClient('libpng16-16'), thinClient('libopenni2-0')];
  assert.deepEqual(rowOf(folder, 'libpcl', '--packages', thin).value, 0);
  const row = rowOf(folder, 'to fetch', '--packages', thin);
  assert.ok(row.value > 0.1 && row.value < 40 && row.holds, JSON.stringify(row));
  assert.equal(rowOf(folder, 'libpcl', '--packages', thick).holds, false);
  assert.ok(size(folder, '--packages', thick).stderr.includes('telepalp-clients needs libopenni2-0'));
});

test('the help ends with a line to paste', () => {
  const {status, stdout} = size(sourceDir, '--help');
  assert.equal(status, 0);
  assert.match(stdout.trim().split('\n').at(-1), /^example: deploy\/size --base/);
  assert.ok(stdout.split('\n').every((line) => line.length <= 80));
});
