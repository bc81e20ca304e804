#!/usr/bin/env bash
# Server, station and recorder with keys, over telepalp-link: images come by sealed datagrams through loss; where each
# datagram is damaged they come over TCP. usage: datagrams_test.sh SOURCE_DIR BIN_DIR
set -uo pipefail
export PATH=$2:$PATH
work=$(mktemp -d)
failures=0
background=()
fail() { echo "FAILED: $1"; [ -n "${2:-}" ] && tail -n 20 "$2"; failures=$((failures + 1)); }
leave() {
  for pid in "${background[@]}"; do kill -INT "$pid" 2>/dev/null; done
  for pid in "${background[@]}"; do wait "$pid" 2>/dev/null; done
  rm -rf "$work"
}
trap leave EXIT
mkdir "$work/run" && chmod 700 "$work/run"
export HOME=$work XDG_RUNTIME_DIR=$work/run
cd "$work" || exit 1

wait_for() { # WHAT FILE TEXT
  for _ in $(seq 300); do grep -q "$3" "$2" 2>/dev/null && return 0; sleep 0.1; done
  fail "$1: not within 30 s" "$2"
}
port_of() { # NAME: of a program that has started
  for _ in $(seq 300); do sed -n 's/^port=//p' "$1.ready" 2>/dev/null | grep . && return 0; sleep 0.1; done
}
start() { # NAME COMMAND…
  local name=$1
  shift
  "$@" >"$work/$name.log" 2>&1 &
  background+=($!)
}
images() { # FILE: prints how many depth images the recording has, and how many the server published meanwhile
  telepalp-record info "$1" | awk '$1 == "/camera/depth" {print $3, $3 + $NF}'
}

for command in "authority --host 127.0.0.1" "server --host 127.0.0.1" "client --name anna --role doctor" "client --name tom --role technician"; do
  # shellcheck disable=SC2086
  telepalp-keys $command >>"$work/keys.log" 2>&1 || fail "telepalp-keys $command" "$work/keys.log"
done
start server telepalp-server --source synthetic --port 0 --key keys/server.key --ready-file server.ready
port=$(port_of server)
[ -n "$port" ] || { fail "the server does not start" "$work/server.log"; exit 1; }

# A mobile network, and an ill one: a loss of 5 %, 50 ms of round trip.
start lte telepalp-link --listen 127.0.0.1:0 --connect "127.0.0.1:$port" --profile lte --seed 1 --quiet --ready-file lte.ready
start ill telepalp-link --listen 127.0.0.1:0 --connect "127.0.0.1:$port" --delay-ms 25 --loss-percent 5 --seed 1 --quiet --ready-file ill.ready
# A firewall: each datagram is damaged, and its tag wrong; TCP passes.
start blocked telepalp-link --listen 127.0.0.1:0 --connect "127.0.0.1:$port" --corrupt-percent 100 --quiet --ready-file blocked.ready

start station telepalp-station --connect "127.0.0.1:$(port_of lte)" --key keys/anna.key --realtime prefer
wait_for "the station's datagrams" "$work/station.log" "the images come by sealed datagrams"
wait_for "the station touches" "$work/station.log" "touchable; the control loop"
telepalp-record --connect "127.0.0.1:$(port_of ill)" --key keys/tom.key --consent test --out ill.mcap --seconds 6 >"$work/ill_record.log" 2>&1 || fail "recording over loss" "$work/ill_record.log"
grep -q "the images come by sealed datagrams" "$work/ill_record.log" || fail "the recorder gets no datagram" "$work/ill_record.log"
telepalp-record --connect "127.0.0.1:$(port_of blocked)" --key keys/tom.key --consent test --out blocked.mcap --seconds 4 >"$work/blocked_record.log" 2>&1 || fail "recording without UDP" "$work/blocked_record.log"
grep -q "no UDP datagram arrives: the images come over TCP" "$work/blocked_record.log" || fail "the recorder does not say that UDP is blocked" "$work/blocked_record.log"
grep -q "telepalp-record at .*: images go over TCP" <(sed 's/no UDP datagram arrives: //' "$work/server.log") || fail "the server does not say that UDP is blocked" "$work/server.log"

# What a technician asks before the first patient.
check() { telepalp-link check --key keys/anna.key "$@" >"$work/check.log" 2>&1; }
check --connect "127.0.0.1:$(port_of ill)" --consent test || fail "the check finds no session over a loss of 5 %" "$work/check.log"
grep -q '^UDP .*in both directions' "$work/check.log" || fail "the check finds no datagram" "$work/check.log"
grep -q '^images .* a second' "$work/check.log" || fail "the check sees no image" "$work/check.log"
check --connect "127.0.0.1:$(port_of blocked)" || fail "the check finds no session without UDP" "$work/check.log"
grep -q '^so .*open UDP port' "$work/check.log" || fail "the check does not say that UDP is blocked" "$work/check.log"
grep -q '^images .*--consent' "$work/check.log" || fail "the check sees images without a consent" "$work/check.log"
check --connect 127.0.0.1:9 && fail "the check finds a session where no server is" "$work/check.log"
grep -q '^so .*start telepalp-server' "$work/check.log" || fail "the check does not say that no server runs" "$work/check.log"

read -r over_loss of_all _ <<<"$(images ill.mcap) 0 0"
read -r without_udp of_all_tcp _ <<<"$(images blocked.mcap) 0 0"
# Without repair, 1 of 150 images would survive a loss of 5 %.
((over_loss >= 20 && 2 * over_loss >= of_all)) || fail "only $over_loss of $of_all images came through a loss of 5 %" "$work/ill_record.log"
((without_udp >= 20 && 2 * without_udp >= of_all_tcp)) || fail "only $without_udp of $of_all_tcp images came over TCP" "$work/blocked_record.log"
grep -q "link lost" "$work/station.log" && fail "the station lost its connection" "$work/station.log"
[ "$failures" = 0 ] && echo "datagrams: $over_loss of $of_all images through a loss of 5 %, $without_udp of $of_all_tcp with UDP blocked"
exit $((failures > 0))
