#!/usr/bin/env bash
# rows_test.sh SOURCES: docs/bad-input.md has the rows 1 to 36; each row names a test that carries its number, and every
# test that a row names exists.
set -euo pipefail
cd "$1"
page=docs/bad-input.md
browser=tests/end_to_end/keys_browser_test.mjs
status=0
fail() { echo "error: $page: $1. fix: $2" >&2; status=1; }

tests=$(grep -rhoE --include='*.cpp' 'TEST(_F|_P)?\(\w+, \w+\)' tests | sed -E 's/.*\((\w+), (\w+)\)/\1.\2/')
for number in $(seq 1 36); do
  row=$(grep -E "^\| $number \|" "$page" || true)
  [ -n "$row" ] || { fail "row $number is missing" "write it"; continue; }
  padded=$(printf %02d "$number")
  # shellcheck disable=SC2016
  for name in $(grep -oE '`[A-Z]\w+\.\w+`' <<<"$row" | tr -d '`'); do
    grep -qxF "$name" <<<"$tests" || fail "row $number names $name, which does not exist" "correct the name"
  done
  if grep -q "keys_browser" <<<"$row"; then
    grep -q "test('bad input $number:" "$browser" || fail "row $number: no case 'bad input $number:' in $browser" "write it"
  elif ! grep -q "\`BadInput$padded\." <<<"$row"; then
    fail "row $number names no test BadInput$padded" "write one, with real programs"
  fi
done
exit $status
