#!/usr/bin/env bash
# deploy/cluster-demo --headless kills a NATS server, and its report says what each viewer got: cluster_demo_test.sh
# SOURCES BIN. Ends with 77 if nats-server is not installed.
set -uo pipefail
sources=$1
# shellcheck source=tests/end_to_end/around_nats.sh
. "$(dirname "$0")/around_nats.sh" "$2"
TELEPALP_BIN=$bin "$sources/deploy/cluster-demo" --headless --seconds 18 --out out >demo.log 2>&1 || fail "deploy/cluster-demo" demo.log
for address in "the patient's site" "edge 1" "edge 2" "the cluster"; do grep -q "telepalp: $address  *\(http\|nats\)" demo.log || fail "the address of $address is not printed" demo.log; done
grep -q "NATS server 1 is killed" demo.log || fail "no server was killed" demo.log
[ -s out/edge1.png ] || fail "no picture" demo.log
for session in site cluster; do grep -q "^$session  */camera/depth .* 0 lost" out/report.txt || fail "$session lacks images" out/report.txt; done
# Each edge goes on within 2 s of the kill.
awk '$1 ~ /^edge/ && $2 == "/camera/depth" {for (i = 1; i < NF; ++i) if ($i == "gap" && $(i + 1) > 2) bad = 1; ++edges} END {exit bad || edges != 2}' out/report.txt ||
  fail "an edge showed nothing for more than 2 s" out/report.txt
[ "$failures" = 0 ] && cat out/report.txt
exit $((failures > 0))
