#!/usr/bin/env bash
# A sweep by workers through a real NATS server writes the same bytes as without them, although one worker is killed,
# another one is stopped, and the sweep is interrupted and resumed: workers_test.sh BIN. Ends with 77 if nats-server is
# not installed.
set -uo pipefail
# shellcheck source=tests/end_to_end/around_nats.sh
. "$(dirname "$0")/around_nats.sh"
worker() { start "$1" telepalp-worker --connect "$cluster" --name "$1" --cache cache; }
cells() { find "$1/cells" -name '*.json' 2>/dev/null | wc -l; }
wait_for_cells() { for _ in $(seq 1200); do [ "$(cells "$1")" -ge "$2" ] && return; sleep 0.05; done; fail "$1 has no $2 finished runs"; }
same() { diff -r "$1" "$2" >diff.log || fail "$1 and $2 differ" diff.log; }

nats=$((20000 + ($$ + 3) % 20000))
cluster="nats://127.0.0.1:$nats"
sweep=(telepalp-replay "synthetic:torso,motion=irregular,width=160" --seconds 2 --assert "frames>10" --sweep delay=0:10:50 loss=0,10%)

# Programs started before the cluster, and with wrong options, say how to fix it.
timeout 30 "${sweep[@]}" --out none --workers "$cluster" >early.log 2>&1
[ $? = 2 ] && grep -q 'fix: start the NATS server' early.log || fail "a sweep without a cluster does not say so" early.log
timeout 30 telepalp-worker --connect "$cluster" >early.log 2>&1
[ $? = 1 ] && grep -q 'fix: start the NATS server' early.log || fail "a worker without a cluster does not say so" early.log
for wrong in "telepalp-worker" "telepalp-worker --connect http://x" "telepalp-worker --connect $cluster --cache-GB 0" \
  "telepalp-replay synthetic --workers $cluster" "telepalp-replay synthetic --sweep delay=0 --workers somewhere"; do
  $wrong >wrong.log 2>&1
  [ $? = 2 ] && grep -q 'fix: ' wrong.log || fail "'$wrong' is taken, or not explained" wrong.log
done
start plain nats-server -a 127.0.0.1 -p $nats
wait_for "the NATS server" plain.log "Server is ready" 60
timeout 30 "${sweep[@]}" --out none --workers "$cluster" >early.log 2>&1
[ $? = 2 ] && grep -q 'fix: start the NATS server with JetStream' early.log || fail "a cluster without JetStream is not said" early.log
kill "${background[0]}"; wait "${background[0]}" 2>/dev/null; background=()
printf 'listen: 127.0.0.1:%s\nauthorization { user: anna, password: secret }\njetstream { store_dir: "%s/locked_store" }\n' $nats "$work" >locked.conf
start locked nats-server -c locked.conf
wait_for "the locked NATS server" locked.log "Server is ready" 60
timeout 30 telepalp-worker --connect "nats://anna:wrong@127.0.0.1:$nats" >early.log 2>&1
[ $? = 1 ] && grep -q 'fix: .*credentials' early.log || fail "wrong credentials are not said" early.log
! grep -q wrong early.log || fail "a password is in the log" early.log
start stopped_sweep "${sweep[@]}" --out stopped --workers "nats://anna:secret@127.0.0.1:$nats"
stopped_sweep=$!
wait_for "the sweep waits for workers" stopped_sweep.log "no worker of this version is there" 60
kill -INT $stopped_sweep; wait $stopped_sweep
grep -q "workers nats://127.0.0.1:$nats" stopped_sweep.log || fail "a stopped sweep does not show how to resume" stopped_sweep.log
grep -q 'add USER:PASSWORD@' stopped_sweep.log || fail "a stopped sweep does not ask for its password again" stopped_sweep.log
! grep -q secret stopped_sweep.log || fail "a password is in the sweep's log" stopped_sweep.log
kill "${background[0]}"; wait "${background[0]}" 2>/dev/null; background=()

"${sweep[@]}" --out alone >alone.log 2>&1 || fail "the sweep without workers" alone.log
start nats nats-server -js -sd "$work/store" -a 127.0.0.1 -p $nats
wait_for "the NATS server with JetStream" nats.log "Server is ready" 60

# One worker is killed, another one is asked to end: a third worker makes their runs.
start shared "${sweep[@]}" --out shared --workers "$cluster"
shared=$!
wait_for "the sweep says that nobody works" shared.log "no worker of this version is there. fix: start telepalp-worker" 60
worker killed; killed=$!
wait_for_cells shared 2
kill -KILL $killed
worker stopped; stopped=$!
wait_for_cells shared 4
kill -INT $stopped
for _ in $(seq 50); do kill -0 $stopped 2>/dev/null || break; sleep 0.1; done
kill -0 $stopped 2>/dev/null && fail "a worker does not end within 5 s of Ctrl-C" stopped.log
grep -q 'ends: [0-9]* runs* finished, [0-9]* given back, 0 removed' stopped.log || fail "a stopped worker does not say what it did" stopped.log
worker last
wait $shared || fail "the shared sweep" shared.log
grep -q '12 runs by 3 workers in ' shared.log || fail "the sweep does not say who made it" shared.log
same alone shared
# shellcheck disable=SC2143
[ "$(grep -c 'is given back' stopped.log)" -le 1 ] || fail "a stopped worker gives back more than its run" stopped.log

# The sweep is interrupted, and its worker continues: the same command takes the worker's results.
start broken "${sweep[@]}" --seed 2 --out broken --workers "$cluster"
broken=$!
wait_for_cells broken 2
kill -INT $broken; wait $broken
[ $? = 1 ] || fail "an interrupted sweep does not end with 1" broken.log
grep -q 'of 12 runs of the sweep are finished, and kept in' broken.log || fail "an interrupted sweep does not say what it keeps" broken.log
grep -q 'workers go on with [0-9]* runs' broken.log || fail "an interrupted sweep does not say that workers go on" broken.log
kept=$(cells broken)
sleep 3
"${sweep[@]}" --seed 2 --out broken --workers "$cluster" >resumed.log 2>&1 || fail "the resumed sweep" resumed.log
grep -q "$kept of 12 runs of the sweep were finished before" resumed.log || fail "the resumed sweep begins anew" resumed.log
grep -qE 'runs? (was|were) finished by workers before' resumed.log || fail "the resumed sweep does not take what workers made meanwhile" resumed.log
"${sweep[@]}" --seed 2 --out whole >whole.log 2>&1 || fail "the second sweep without workers" whole.log
same whole broken

[ "$failures" = 0 ] && echo "workers: $(grep -o '12 runs by .*' shared.log), with one killed and one stopped; resumed; same bytes"
exit $((failures > 0))
