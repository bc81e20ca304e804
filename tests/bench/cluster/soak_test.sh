#!/usr/bin/env bash
# A minute of the soak that `telepalp-bench cluster --part soak --seconds 3600` runs for an hour: soak_test.sh BENCH. Ends
# with 77 where nats-server or network namespaces are missing.
set -uo pipefail
[ -x /usr/sbin/nats-server ] || { echo "skipped: nats-server is not installed"; exit 77; }
unshare -n true 2>/dev/null || { echo "skipped: this computer allows no network namespaces"; exit 77; }
exec "$1" cluster --part soak --seconds 60
