#!/usr/bin/env bash
# A site's messages pass a real NATS server to an edge: viewers and recorders get the same from both, an edge takes no
# station, and it comes back after the cluster was away: relay_test.sh BIN. Ends with 77 if nats-server is not installed.
set -uo pipefail
# shellcheck source=tests/end_to_end/around_nats.sh
. "$(dirname "$0")/around_nats.sh"
port_of() { for _ in $(seq 100); do [ -s "$1.ready" ] && break; sleep 0.1; done; sed -n 's/^port=//p' "$1.ready"; }

nats=$((20000 + $$ % 20000))
cluster="nats://127.0.0.1:$nats"
start nats nats-server -a 127.0.0.1 -p $nats
wait_for "the NATS server" nats.log "Server is ready"

# In the wrong order: an edge before its site says so.
timeout 20 telepalp-server --source "$cluster/ward3" --port 0 >early.log 2>&1 && fail "an edge of a site that nobody publishes starts" early.log
grep -q 'fix: start telepalp-server --publish' early.log || fail "the edge does not say what it waits for" early.log

start site telepalp-server --source synthetic --port 0 --publish "$cluster/ward3" --depth-mode temporal --ready-file site.ready
site=$(port_of site)
wait_for "the site publishes" site.log "publishes for edges"
timeout 20 telepalp-server --source synthetic --port 0 --publish "$cluster/ward3" >second.log 2>&1 && fail "two servers publish one site" second.log
grep -q "another server publishes the site 'ward3'" second.log || fail "the second server is not told" second.log

start edge telepalp-server --source "$cluster/ward3" --port 0 --ready-file edge.ready
edge=$(port_of edge)
wait_for "the edge" edge.log "its session clock is known to within"
start station telepalp-station --connect "127.0.0.1:$site" --control none --realtime prefer
wait_for "the station" station.log "touchable"

telepalp-view --connect "127.0.0.1:$edge" --snapshot edge.png --patience 20 >view.log 2>&1 || fail "no picture at the edge" view.log
grep -q "has no hand" view.log && fail "the picture at the edge shows no hand" view.log
timeout 20 telepalp-station --connect "127.0.0.1:$edge" --control none --patience 3 >refused.log 2>&1 && fail "an edge takes a station" refused.log
grep -q "takes no stations" refused.log || fail "the station is not told that this is an edge" refused.log

# The same messages at both ends: number, time and content.
telepalp-record --connect "127.0.0.1:$site" --out site.mcap --seconds 6 >record_site.log 2>&1 & recording=$!
telepalp-record --connect "127.0.0.1:$edge" --out edge.mcap --seconds 5 >record_edge.log 2>&1 || fail "recording at the edge" record_edge.log
wait $recording || fail "recording at the site" record_site.log
telepalp-record verify edge.mcap >verify.log 2>&1 || fail "the edge's recording cannot be read" verify.log
telepalp-record info edge.mcap >info.log 2>&1
for topic in /camera/depth /camera/color /camera/info /station/state /station/ticks; do grep -q "$topic" info.log || fail "the edge's recording has no $topic" info.log; done

# The cluster is killed and comes back: the edge goes on by itself.
kill -KILL "${background[0]}"; wait "${background[0]}" 2>/dev/null
wait_for "the edge notices" edge.log "the connection to the cluster is lost"
wait_for "the site notices" site.log "the connection to the cluster is lost"
start nats2 nats-server -a 127.0.0.1 -p $nats
wait_for "the edge is back" edge.log "connected to the cluster again"
wait_for "the site is back" site.log "connected to the cluster again"
rm -f edge.png
telepalp-view --connect "127.0.0.1:$edge" --snapshot edge.png --patience 20 >view.log 2>&1 || fail "no picture after the cluster came back" view.log
[ -s edge.png ] || fail "no picture after the cluster came back" view.log
[ "$failures" = 0 ] && echo "relay: $(grep -o 'known to within .*' edge.log), and back after the cluster was killed"
exit $((failures > 0))
