#!/usr/bin/env bash
# A session is recorded in a cluster of three NATS servers while one of them is killed, and lacks nothing; it is copied to
# a file and back, byte by byte; and played from the middle: cluster_sessions_test.sh BIN. Ends with 77 if nats-server is
# not installed.
set -uo pipefail
# shellcheck source=tests/end_to_end/around_nats.sh
. "$(dirname "$0")/around_nats.sh"
port_of() { for _ in $(seq 100); do [ -s "$1.ready" ] && break; sleep 0.1; done; sed -n 's/^port=//p' "$1.ready"; }
base=$((20000 + ($$ + 7) % 20000))
url() { echo "nats://127.0.0.1:$((base + $1))"; }
routes="nats://127.0.0.1:$((base + 11)),nats://127.0.0.1:$((base + 12)),nats://127.0.0.1:$((base + 13))"
for n in 1 2 3; do
  start "nats$n" nats-server -a 127.0.0.1 -p $((base + n)) -js -sd "store$n" --name "n$n" --cluster_name test \
    --cluster "nats://127.0.0.1:$((base + 10 + n))" --routes "$routes"
done
for n in 1 2 3; do wait_for "NATS server $n" "nats$n.log" "Server is ready"; done
for _ in $(seq 200); do grep -q "new metadata leader" nats?.log && break; sleep 0.1; done
all="$(url 1),$(url 2),$(url 3)"

start site telepalp-server --source synthetic --port 0 --ready-file site.ready
site=$(port_of site)

# Without the patient's consent, or the time that it allows, nothing is stored.
timeout 20 telepalp-record --connect "127.0.0.1:$site" --out "$all/ward3/none.mcap" --seconds 1 >none.log 2>&1 && fail "a session without consent is stored" none.log
grep -q "without the patient's consent" none.log || fail "the missing consent is not said" none.log
timeout 20 telepalp-record --connect "127.0.0.1:$site" --out "$all/ward3/none.mcap" --consent "form 1, until 2020-01-01" --seconds 1 >none.log 2>&1 && fail "a session whose consent is over is stored" none.log
grep -q "consent is over" none.log || fail "the consent that is over is not said" none.log

telepalp-record --connect "127.0.0.1:$site" --out file.mcap --seconds 12 >file.log 2>&1 & beside=$!
telepalp-record --connect "127.0.0.1:$site" --out "$all/ward3/a.mcap" --consent "form 1, until 2199-01-01" --keep-days 2 --seconds 12 >cluster.log 2>&1 & recording=$!
sleep 4
kill -KILL "${background[0]}"  # the server to which the recorder is connected
wait $recording || fail "recording in the cluster" cluster.log
wait $beside || fail "recording beside it" file.log
left="$(url 2),$(url 3)"
telepalp-record verify "$left/ward3/a.mcap" >verify.log 2>&1 || fail "the session in the cluster is damaged" verify.log
telepalp-record info "$left/ward3/a.mcap" >info.log 2>&1 || fail "the session in the cluster cannot be described" info.log
awk '$1 ~ /^\// && $7 > 0 {print; bad = 1} END {exit bad}' info.log || fail "messages were lost through the kill" info.log
grep -q "^/camera/depth" info.log || fail "the session in the cluster has no images" info.log
[ "$(awk '$1 == "/camera/depth" {print $3}' info.log)" -ge 300 ] || fail "the session in the cluster is short" info.log

# There and back, byte by byte.
telepalp-record copy "$left/ward3/a.mcap" --out a.mcap >copy.log 2>&1 || fail "copy to a file" copy.log
telepalp-record copy a.mcap --out "$left/ward3/b.mcap" --keep-days 1 >copy.log 2>&1 || fail "copy to the cluster" copy.log
telepalp-record copy "$left/ward3/b.mcap" --out b.mcap >copy.log 2>&1 || fail "copy back" copy.log
cmp a.mcap b.mcap || fail "the copy differs"
telepalp-record copy file.mcap --out "$left/ward3/c.mcap" --keep-days 1 >copy.log 2>&1 && fail "a file without consent is stored" copy.log

# Played from the middle, through a server anywhere.
start player telepalp-server --source "session:$left/ward3/a.mcap,from_s=6" --port 0 --http-port 0 --ready-file player.ready
player=$(port_of player)
telepalp-view --connect "127.0.0.1:$player" --snapshot played.png --patience 20 >view.log 2>&1 || fail "no picture of the played session" view.log
[ -s played.png ] || fail "no picture of the played session" view.log
telepalp-export "$left/ward3/a.mcap" --csv /camera/status --out status.csv >export.log 2>&1 || fail "export from the cluster" export.log

# Removed when the consent is withdrawn.
telepalp-record forget "$left/ward3/b.mcap" >forget.log 2>&1 || fail "forget without --delete" forget.log
grep -q "would be removed" forget.log || fail "forget does not say what it would remove" forget.log
telepalp-record forget "$left/ward3/b.mcap" --delete >forget.log 2>&1 || fail "forget" forget.log
telepalp-record info "$left/ward3/b.mcap" >gone.log 2>&1 && fail "a removed session is still there" gone.log
[ "$failures" = 0 ] && echo "cluster sessions: $(awk '$1 == "/camera/depth" {print $3 " images, longest gap " $6 " s, " $7 " lost"}' info.log), through the kill of a server"
exit $((failures > 0))
