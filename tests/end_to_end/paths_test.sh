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

# A relay that refuses is said once at each end, and the images come over TCP.
server_behind symmetric
router doctor symmetric
cp "$work/relay.secret" "$work/its.secret" && openssl rand -hex 32 >"$work/relay.secret"
meet_again
for round in 1 2; do
  found=$(way)
  grep -q 'finds no path' <<<"$found" || fail "a relay that refuses: found '$found'" "$work/check.log"
  grep -qE '^images +[1-9][0-9]*' "$work/check.log" || fail "a relay that refuses: no images" "$work/check.log"
  grep -q '^but *relay: the relay at 192.0.2.1 gives no address.*fix: ' "$work/check.log" || fail "the doctor is not told that the relay refuses (round $round)" "$work/check.log"
done
said=$(grep -ac 'relay: the relay at 192.0.2.1 gives no address.*fix: ' "$work/server.log")
[ "$said" = 1 ] || fail "the site says $said times instead of once that the relay refuses" "$work/server.log"
cp "$work/its.secret" "$work/relay.secret"
meet_again

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
router doctor port
probe 14
sleep 3
router doctor half-open
expect "datagrams come in and do not go out" 2 1 "over a relay (TCP)"
router doctor no-udp
probe 50 directly
router doctor port
expect "UDP passes again: the relay is left" 0.5 1 "through the routers"
router doctor port
probe 10
sleep 3
move doctor 3
expect "the doctor's address changes" 2 2 "through the routers"
probe 10
sleep 3
router patient symmetric
expect "the patient's router draws other ports" 2 1 "through the routers"
router patient port
probe 14
sleep 3
router patient no-udp
expect "UDP is cut at the patient's site" 2 1 "over a relay (TCP)"
router patient port
probe 10
sleep 3
move patient 3
expect "the patient's address changes" 2 2 "through the routers"
grep -q "this computer's address has changed" "$work/server.log" || fail "the server does not say that its address has changed" "$work/server.log"
grep -qE 'has changed: [0-9]+ streams? ends?' "$work/meet.log" || fail "the meeting point ends no stream of the lost address" "$work/meet.log"
server_behind symmetric
probe 10
sleep 3
renumber patient 3
# The computer's own address stays, so only silence shows it.
expect "the router of the patient's site gets another address" 8 2 "over a relay (UDP)"
took=$(grep -c 'event=took-touch who=doctor anna .*by=new-connection' "$work/keys/audit.log")
[ "$took" -ge 2 ] || fail "the touch passed $took times to a new connection instead of 2" "$work/keys/audit.log"
exit $((failures > 0))
