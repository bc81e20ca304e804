#!/usr/bin/env bash
# One minute of the soak: server, station, recorder, relay, an edge with 20 viewers over a mobile network, and a
# certificate that is renewed: soak_test.sh BIN. Ends with 77 without root, nats-server or network namespaces.
set -uo pipefail
bin=$1
skip() { echo "skipped: $1"; exit 77; }
[ "$(id -u)" = 0 ] || skip "needs root"
[ -x /usr/sbin/nats-server ] || skip "nats-server is not installed"
unshare -n true 2>/dev/null || skip "no network namespace can be made"
[ -x "$bin/telepalp-bench" ] || skip "telepalp-bench is not built"
"$bin/telepalp-bench" cluster --part soak --seconds 60
