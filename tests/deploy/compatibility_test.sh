#!/usr/bin/env bash
# deploy/compatibility: a version works with itself, and a program that does not work is found in each of its rows:
# compatibility_test.sh SOURCE BIN
set -euo pipefail
source=$1 bin=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED: $1" >&2; exit 1; }
rows() { grep -c "^$1 " "$work/said" || true; }

"$source/deploy/compatibility" --old "$bin" --new "$bin" >"$work/said" || { cat "$work/said" >&2; fail "a version does not work with itself"; }
[ "$(rows works)" = 7 ] || { cat "$work/said" >&2; fail "not all rows work"; }

mkdir "$work/broken"
for program in server station record; do ln -s "$bin/telepalp-$program" "$work/broken/"; done
rm "$work/broken/telepalp-station"
printf '#!/bin/sh\necho "error: it speaks another protocol" >&2\nexit 1\n' >"$work/broken/telepalp-station"
chmod +x "$work/broken/telepalp-station"
if "$source/deploy/compatibility" --old "$work/broken" --new "$bin" >"$work/said"; then fail "a station that ends is not found"; fi
grep -q '^FAILS   new server, old station, new recorder: error: it speaks another protocol' "$work/said" || { cat "$work/said" >&2; fail "the row does not say why"; }
[ "$(rows FAILS)" = 3 ] || { cat "$work/said" >&2; fail "other rows fail than those of the broken station"; }

for words in "" "--old $work" "--old $bin --what" "--old"; do
  status=0
  "$source/deploy/compatibility" $words >/dev/null 2>"$work/said" || status=$?
  [ "$status" = 2 ] || fail "'$words' gives exit code $status"
done
echo "versions: 7 combinations, and a broken one is found"
