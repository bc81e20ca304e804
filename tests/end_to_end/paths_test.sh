#!/usr/bin/env bash
# paths_test.sh SOURCE_DIR BIN: the programs find the best path for datagrams that two routers allow, fall back to TCP when it is
# cut, and find another one. Ends with 77 where namespaces, nftables or coturn are missing.
set -uo pipefail
source_dir=$1 bin=$2
# shellcheck source=tests/end_to_end/nat_sites.sh
. "$(dirname "$0")/nat_sites.sh"
make_keys
begin_relay
begin_meet

way() { # the way of the datagrams, as telepalp-link check says it
  (cd "$work" && timeout 60 ip netns exec "$doctor" "$bin/telepalp-link" check --connect ward3.meet.example@meet.example --key keys/anna.key --consent signed-form --seconds "${1:-3}") >"$work/check.log" 2>&1
  sed -n 's/^UDP *//p' "$work/check.log"
}
server_at=
while read -r at_patient at_doctor expected; do
  router doctor "$at_doctor"
  [ "$server_at" = "$at_patient" ] || server_behind "$at_patient"
  found=$(way)
  echo "paths: patient $at_patient, doctor $at_doctor: $found"
  grep -q "$expected" <<<"$found" || fail "patient $at_patient, doctor $at_doctor: expected '$expected', found '$found'" "$work/check.log"
  grep -qE '^images +[1-9][0-9]*' "$work/check.log" || fail "patient $at_patient, doctor $at_doctor: no images" "$work/check.log"
done <<'PAIRS'
open open directly from computer to computer
independent symmetric through the routers
address port through the routers
port port through the routers
port symmetric over a relay (UDP)
symmetric symmetric over a relay (UDP)
no-udp port over a relay (TCP)
tcp-443 tcp-443 over a relay (TCP)
PAIRS
exit $((failures > 0))
