#!/usr/bin/env bash
# deploy/check and deploy/base in small checkouts with one planted fault each: check_test.sh SOURCE_DIR
set -euo pipefail
source_dir=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for tool in git clang-format clang-tidy; do command -v $tool >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }; done
failures=0
failed() { echo "FAILED: $*"; sed 's/^/  /' "$work/log"; failures=$((failures + 1)); }
git_as() { git -C "$1" -c user.name=test -c user.email=test@test "${@:2}" >/dev/null; }

readonly SOUND='int f() { return 1; }'
readonly BAD_LAYOUT='int  f( ){return 1;}'
readonly FAULT='#include <cstddef>
std::size_t f(int a) { return a * 1024; }'

# A checkout with the scripts, and sound sources that cmake configures, of one commit. The network's sanitizers, which
# would build the whole network, leave a mark.
checkout() { # NAME
  local at=$work/$1
  mkdir -p "$at/proto/wire" "$at/codec" "$at/tests/fuzz" "$at/build/release/generated/messages"
  cp -r "$source_dir/deploy" "$source_dir/.clang-format" "$source_dir/.clang-tidy" "$at"
  cp "$source_dir/tests/fuzz/source_location.h" "$at/tests/fuzz"
  printf '#!/bin/sh\ntouch sanitized\n' >"$at/deploy/sanitize"
  touch "$at/build/release/generated/messages/station.pb.h"
  printf 'build/\nsanitized\n' >"$at/.gitignore"
  cat >"$at/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(small CXX)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
add_library(small codec/a.cpp codec/b.cpp proto/wire/c.cpp)
END
  echo '{"version": 5, "configurePresets": [{"name": "release", "generator": "Ninja", "binaryDir": "${sourceDir}/build/release"}]}' >"$at/CMakePresets.json"
  local file
  for file in codec/a.cpp codec/b.cpp proto/wire/c.cpp; do echo "$SOUND" >"$at/$file"; done
  git init -q -b main "$at"
  git_as "$at" add -A
  git_as "$at" commit -m 'the first commit'
}
write() { echo "$3" >"$work/$1/$2"; git_as "$work/$1" add -A; git_as "$work/$1" commit -m 'a change'; }
check() { "$work/$1/deploy/check" "${@:2}" >"$work/log" 2>&1; }

checkout sound
write sound codec/a.cpp 'int g() { return 2; }'
check sound || failed "a sound change is refused"
[ ! -e "$work/sound/sanitized" ] || failed "a change of the codec runs the network's sanitizers"
write sound proto/wire/c.cpp 'int g() { return 2; }'
check sound || failed "a sound change of the network is refused"
[ -e "$work/sound/sanitized" ] || failed "a change of the network does not run its sanitizers"

checkout layout
write layout codec/b.cpp "$BAD_LAYOUT"
write layout codec/a.cpp 'int  g( ){return 2;}'
check layout && failed "a bad layout passes"
grep -q 'codec/a.cpp' "$work/log" || failed "the file of the bad layout is not named"
! grep -q 'codec/b.cpp' "$work/log" || failed "a file that did not change is checked"
check layout HEAD~2 && failed "a bad layout passes with a base"
grep -q 'codec/b.cpp' "$work/log" || failed "the named base is not taken"

checkout fault
write fault codec/a.cpp "$FAULT"
check fault && failed "a fault passes"
grep -q 'codec/a.cpp:2:.*bugprone-implicit-widening' "$work/log" || failed "the fault is not named"
write fault codec/a.cpp "$FAULT
int g() { return 3; }"
check fault || failed "an old fault in a line that did not change is refused"
printf '%s\n' "$FAULT" >"$work/fault/codec/new.cpp"
sed -i 's#proto/wire/c.cpp#codec/new.cpp#' "$work/fault/CMakeLists.txt"
check fault && failed "a fault in a file that is not yet known to git passes"
grep -q 'codec/new.cpp:2:.*bugprone-implicit-widening' "$work/log" || failed "the fault of the new file is not named"

checkout shallow
check shallow || failed "a clone without an earlier commit is refused"
grep -q 'only the layout is checked, of all files' "$work/log" || failed "a clone without an earlier commit is not told"
echo "$BAD_LAYOUT" >"$work/shallow/codec/a.cpp"
git_as "$work/shallow" commit -a --amend --no-edit
check shallow && failed "a bad layout passes without an earlier commit"
check shallow nowhere && failed "an unknown commit passes"
grep -q "there is no commit 'nowhere' here. fix:" "$work/log" || failed "an unknown commit is not named"

: >"$work/log"
base() { "$source_dir/deploy/base" "$work/$1"; }
commit() { git -C "$work/$1" rev-parse "$2"; }
checkout branch
[ -z "$(base branch)" ] || failed "the first commit has a base"
write branch codec/a.cpp 'int g() { return 2; }'
[ "$(base branch)" = "$(commit branch HEAD~1)" ] || failed "the base on the main branch is not the commit before"
git_as "$work/branch" checkout -q -b other
for number in 3 4; do write branch codec/a.cpp "int g() { return $number; }"; done
[ "$(base branch)" = "$(commit branch main)" ] || failed "the base of a branch is not where it left the main branch"

# with no time at all, each file is left out and named
"$work/fault/deploy/tidy" --for 0 codec/a.cpp codec/b.cpp >"$work/log" 2>&1 || failed "deploy/tidy --for 0 fails"
grep -q '2 of 2 files were not checked' "$work/log" || failed "deploy/tidy does not say what it left out"

echo "check: $failures failures"
[ "$failures" = 0 ]
