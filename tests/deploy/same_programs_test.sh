#!/usr/bin/env bash
# A program that is built again, in another folder, at another time and without the compiler's cache, is the same bytes:
# same_programs_test.sh CMAKE SOURCES BUILD. It builds telepalp-keys, which needs few sources.
set -euo pipefail
cmake=$1 sources=$2 build=$3
program=telepalp-keys
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED: $1" >&2; tail -n 20 "$work/log" >&2; exit 1; }
[ -x "$build/bin/$program" ] || { echo "skipped: $program is not built"; exit 77; }
grep -q '^CMAKE_BUILD_TYPE:.*=Release' "$build/CMakeCache.txt" || { echo "skipped: not a release build"; exit 77; }
"$build/bin/$program" --version | grep -q "$(git -C "$sources" rev-parse --short=7 HEAD)" || { echo "skipped: $program was built from another commit"; exit 77; }
export CCACHE_DISABLE=1
# The options of the first build, without its folders.
mapfile -t options < <(sed -n 's/^\(TELEPALP_[A-Z_]*\|CMAKE_BUILD_TYPE\):[A-Z]*=\(.*\)/-D\1=\2/p' "$build/CMakeCache.txt" | grep -v -e _DIR -e "$build")
"$cmake" -S "$sources" -B "$work/again" -G Ninja "${options[@]}" >"$work/log" 2>&1 || fail "cmake"
TZ=Asia/Tokyo "$cmake" --build "$work/again" --target $program >"$work/log" 2>&1 || fail "the second build"
cmp "$build/bin/$program" "$work/again/bin/$program" || fail "$program of two builds differs"
echo "built twice: $program $(sha256sum <"$build/bin/$program" | cut -c1-12)"
