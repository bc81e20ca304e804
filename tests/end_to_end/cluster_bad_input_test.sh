#!/usr/bin/env bash
# Bad input of a cluster: each is refused, said, and disturbs neither the site nor its edge: cluster_bad_input_test.sh BIN
# PRELOAD. Ends with 77 if nats-server is not installed.
set -uo pipefail
preload=$2
# shellcheck source=tests/end_to_end/around_nats.sh
. "$(dirname "$0")/around_nats.sh"
port_of() { for _ in $(seq 100); do [ -s "$1.ready" ] && break; sleep 0.1; done; sed -n 's/^port=//p' "$1.ready"; }
say_to_nats() { # LINE…: as a client of the NATS server
  exec 9<>"/dev/tcp/127.0.0.1/$nats"
  printf '%s\r\n' 'CONNECT {"verbose":false,"user":"site","pass":"right"}' "$@" 'PING' >&9
  timeout 2 grep -q -m 1 PONG <&9
  exec 9<&-
}
nats=$((20000 + ($$ + 9) % 20000))

# No cluster.
timeout 20 telepalp-server --source synthetic --port 0 --publish "nats://127.0.0.1:$nats/ward3" >none.log 2>&1 && fail "a server publishes without a cluster" none.log
grep -q 'fix: start the NATS server' none.log || fail "the missing cluster is not said" none.log

# A small limit on messages, and an account with a password.
cat >nats.conf <<EOF
listen: 127.0.0.1:$nats
max_payload: 20000
authorization { user: site, password: right }
EOF
start nats nats-server -c nats.conf
wait_for "the NATS server" nats.log "Server is ready"
timeout 20 telepalp-server --source synthetic --port 0 --publish "nats://site:wrong@127.0.0.1:$nats/ward3" >wrong.log 2>&1 && fail "wrong credentials are taken" wrong.log
grep -qi 'authorization' wrong.log || fail "the wrong credentials are not said" wrong.log
grep -q 'wrong@' wrong.log && fail "the password is in the log" wrong.log

cluster="nats://site:right@127.0.0.1:$nats"
start site telepalp-server --source synthetic --port 0 --publish "$cluster/ward3" --ready-file site.ready
site=$(port_of site)
wait_for "the site publishes" site.log "publishes for edges"
# An edge whose wall clock is an hour ahead.
printf '\x10\x0e\0\0\0\0\0\0' >ahead
start edge env "LD_PRELOAD=$preload/telepalp_stepped_wall_clock.so" "TELEPALP_WALL_CLOCK_STEP=$work/ahead" \
  telepalp-server --source "$cluster/ward3" --port 0 --ready-file edge.ready
edge=$(port_of edge)
wait_for "the edge" edge.log "its session clock is known to within"
start station telepalp-station --connect "127.0.0.1:$site" --control none --realtime prefer
wait_for "the station" station.log "touchable"

# Images are larger than the cluster's limit, and arrive whole, with the site's times.
telepalp-record --connect "127.0.0.1:$site" --out site.mcap --seconds 8 >record_site.log 2>&1 & recording=$!
telepalp-record --connect "127.0.0.1:$edge" --out edge.mcap --seconds 6 >record_edge.log 2>&1 & at_edge=$!
sleep 2
# Somebody else publishes at the site's subjects, and at those of another site.
say_to_nats 'PUB telepalp.ward3.camera.depth 5' 'hello' 'PUB telepalp.ward3.station.state 32' "$(printf '%032d' 0)" \
  'PUB telepalp.ward4.camera.depth 5' 'hello' 'PUB telepalp.ward3.nothing 5' 'hello' || fail "the NATS server does not answer"
wait $at_edge || fail "recording at the edge" record_edge.log
wait $recording || fail "recording at the site" record_site.log
wait_for "the refused message is said" edge.log "message from the cluster refused" 5
telepalp-record info edge.mcap >edge_info.log 2>&1
telepalp-record info site.mcap >site_info.log 2>&1
awk '($1 == "/camera/depth" || $1 == "/station/state") && $7 > 0 {print; bad = 1} END {exit bad}' edge_info.log || fail "the edge lacks messages" edge_info.log
awk '($1 == "/camera/depth" || $1 == "/station/state") && $7 > 0 {print; bad = 1} END {exit bad}' site_info.log || fail "the site was disturbed" site_info.log
grep -q "^/camera/depth" edge_info.log || fail "the edge has no images" edge_info.log
grep -q FAULT station.log && fail "the doctor's touch was disturbed" station.log

# A cluster without JetStream keeps no session.
timeout 20 telepalp-record copy site.mcap --keep-days 1 --out "nats://127.0.0.1:$nats/ward3/a.mcap" >store.log 2>&1 && fail "a session is stored without JetStream" store.log
grep -q "fix: " store.log || fail "the missing consent or JetStream is not said" store.log
[ "$failures" = 0 ] && echo "cluster, bad input: all refused; $(grep -c 'message from the cluster refused' edge.log) lines in the edge's log"
exit $((failures > 0))
