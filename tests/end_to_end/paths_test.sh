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
  (cd "$work" && timeout 60 ip netns exec "$doctor" "$bin/telepalp-link" check --connect ward3.meet.example@meet.example --key keys/anna.key --consent signed-form --seconds 3) >"$work/check.log" 2>&1
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

# The network changes while images come: the longest gap between two images, and how often the program connected.
probe() { # SECONDS [WAY]: ends early when the datagrams go by this way
  (cd "$work" && exec timeout 60 ip netns exec "$doctor" "$bin/telepalp-path-probe" ward3.meet.example@meet.example keys/anna.key "$@") >"$work/probe.out" 2>"$work/probe.log" &
  probe_pid=$!
  wait_for "a way for the datagrams" "$work/probe.log" "the images come by sealed datagrams"
}
expect() { # WHAT GAP_S CONNECTIONS WAY
  wait "$probe_pid" || fail "$1: the probe failed" "$work/probe.log"
  read -r _ _ _ gap connections found <"$work/probe.out"
  echo "paths: $1: gap $gap s, connections $connections, $found"
  awk -v gap="$gap" -v most="$2" 'BEGIN {exit !(gap < most)}' || fail "$1: images pause for $gap s" "$work/probe.log"
  [ "$connections" = "$3" ] || fail "$1: $connections connections instead of $3" "$work/probe.log"
  grep -q "$4" <<<"$found" || fail "$1: expected '$4', found '$found'" "$work/probe.log"
}
router doctor port
server_behind port
probe 14
sleep 3
router doctor no-udp
expect "UDP is cut" 2 1 "over a relay (TCP)"
router doctor no-udp
probe 50 directly
router doctor port
expect "UDP passes again: the relay is left" 0.5 1 "through the routers"
router doctor port
probe 10
sleep 3
ip -n "$doctor" addr flush dev pdoa
ip -n "$doctor" addr add 10.2.0.3/24 dev pdoa && ip -n "$doctor" route add default via 10.2.0.1
expect "the doctor's address changes" 2 2 "through the routers"
exit $((failures > 0))
