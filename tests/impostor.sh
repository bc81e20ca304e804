#!/usr/bin/env bash
# tests/impostor.sh [BUILD]: runs what docs/bad-input.md lists as an impostor's kit, with the programs of BUILD
# (build/release), and says for each row how many of its tests passed.
set -uo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
build=${1:-$here/build/release}
[ -e "$build/CTestTestfile.cmake" ] || { echo "error: $build: no build is here. fix: deploy/build release" >&2; exit 2; }
rows=0 failures=0
while IFS='|' read -r _ tries tests _; do
  names=$(grep -o '`[^`]*`' <<<"$tests" | tr -d '`')
  pattern=$(sed 's/[.]/[.]/' <<<"$names" | paste -sd'|')
  wanted=$(wc -l <<<"$names")
  # A test with parameters has a prefix and a suffix of its own, so that one name may be several tests.
  log=$(ctest --test-dir "$build" -R "(^|/)($pattern)(/|\$)" --no-tests=error 2>&1)
  outcome=$?
  ran=$(grep -oE '(^| )[A-Za-z0-9_/]+\.[A-Za-z0-9_/]+ \.+ +Passed' <<<"$log" | wc -l)
  printf '%-6s %3d of %3d passed:%s\n' "$([ $outcome = 0 ] && [ "$ran" -ge "$wanted" ] && echo ok || echo FAILED)" "$ran" "$wanted" "$tries"
  if [ $outcome != 0 ] || [ "$ran" -lt "$wanted" ]; then
    failures=$((failures + 1))
    tail -n 20 <<<"$log"
  fi
  rows=$((rows + 1))
done < <(awk '/^## / {inside = /An impostor/} inside && /`[A-Z]/ && /^\|/' "$here/docs/bad-input.md")
[ "$rows" -ge 7 ] || { echo "error: docs/bad-input.md: $rows rows instead of 7 are in the impostor's kit" >&2; exit 1; }
exit $((failures > 0))
