#!/usr/bin/env bash
# No service of an installation writes a core dump: the patient's images and the key would be in it. And each is shut in.
# Usage: services_test.sh SOURCE_DIR
set -euo pipefail
services=("$1"/deploy/service/*.service)
[[ -e ${services[0]} ]] || { echo "FAIL: no service in $1/deploy/service"; exit 1; }
for service in "${services[@]}"; do
  grep -qx 'LimitCORE=0' "$service" || { echo "FAIL: $service has no line LimitCORE=0"; exit 1; }
done
echo "${#services[@]} services write no core dump"
# Each service is shut in: its exposure by systemd's own judgement is at most 2.0 of 10.
if ! command -v systemd-analyze >/dev/null; then echo "systemd-analyze is not installed: the exposure was not judged"; exit 0; fi
for service in "${services[@]}"; do
  systemd-analyze security --offline=true --threshold=20 "$service" >/dev/null 2>&1 ||
    { systemd-analyze security --offline=true "$service" | tail -n 1; echo "FAIL: $service is exposed by more than 2.0"; exit 1; }
done
echo "${#services[@]} services have an exposure of at most 2.0"
