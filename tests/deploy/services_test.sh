#!/usr/bin/env bash
# No service of an installation writes a core dump: the patient's images and the key would be in it.
# Usage: services_test.sh SOURCE_DIR
set -euo pipefail
services=("$1"/deploy/service/*.service)
[[ -e ${services[0]} ]] || { echo "FAIL: no service in $1/deploy/service"; exit 1; }
for service in "${services[@]}"; do
  grep -qx 'LimitCORE=0' "$service" || { echo "FAIL: $service has no line LimitCORE=0"; exit 1; }
done
echo "${#services[@]} services write no core dump"
