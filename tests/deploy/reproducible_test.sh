#!/usr/bin/env bash
# Packages of the same files are the same bytes, made in another folder, at another time, in another time zone. It makes
# the two packages without programs: reproducible_test.sh CPACK BUILD
set -euo pipefail
cpack=$1 build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED: $1" >&2; exit 1; }
for tool in dpkg-deb sha256sum; do command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }; done

make() { # FOLDER
  "$cpack" --config "$build/CPackConfig.cmake" -D "CPACK_COMPONENTS_ALL=data;demo" -B "$work/$1" >"$work/log" 2>&1 || { tail -n 20 "$work/log" >&2; fail "cpack"; }
}
hashes() { (cd "$work/$1" && sha256sum telepalp*.deb); }
make one
sleep 2
TZ=Asia/Tokyo make another
[ "$(hashes one | wc -l)" = 2 ] || fail "other packages than expected: $(hashes one)"
[ "$(hashes one)" = "$(hashes another)" ] || fail "packages of the same files differ: $(diff <(hashes one) <(hashes another))"
echo "packages made twice: $(hashes one | awk '{print $2 " " substr($1, 1, 12)}' | xargs)"
