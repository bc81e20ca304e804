#!/usr/bin/env bash
# Runs every example that telepalp prints: the last line of each program's and command's --help, and each command in the
# fenced blocks of docs/*.md. They run as they stand, in an empty folder that holds the files they name, but for these
# rules, which the test prints when it uses one:
#   bounded  --seconds N becomes --seconds 2, and --operators 2 --penetrations 2 become 1 and 1: so that the test ends
#   ctrl-c   what runs until Ctrl-C gets one 3 s after its first words, and must end well
#   started  a benchmark (and a scene's bill, which is one) takes minutes and its figures depend on the machine: it must run
#            for 1.5 s, or end without an error
#   refused  what lacks something here must say so: telepalp-station rearm and hand-over (no fault, no keys), telepalp-record
#            reseal (not encrypted) and nats:// (no cluster), --device haply (no device)
#   differs  telepalp-replay diff must name the first message in which two sessions differ: the test has no two equal ones
#   exists   deploy/* but the demo installs or builds: the file must be there
# usage: examples_test.sh SOURCE_DIR BIN_DIR
set -uo pipefail
if [ -z "${EXAMPLES_ALONE:-}" ] && unshare --net --map-root-user true 2>/dev/null; then
  # Default ports are what is tested, and nobody else may use them meanwhile: a network of our own.
  exec env EXAMPLES_ALONE=1 unshare --net --map-root-user sh -c 'ip link set lo up && exec "$@"' sh "$0" "$@"
fi
source_dir=$1 bin=$2
export TELEPALP_BIN=$bin PATH=$bin:$PATH
work=$(mktemp -d)
background=()
leave() {
  for pid in "${background[@]}"; do kill -TERM "$pid" 2>/dev/null; wait "$pid"; done
  rm -rf "$work"
}
trap leave EXIT
mkdir "$work/here" "$work/home" "$work/run"
chmod 700 "$work/run"
export HOME=$work/home XDG_RUNTIME_DIR=$work/run
export TELEPALP_PASSPHRASE=once-upon-a-key TELEPALP_NEW_PASSPHRASE=once-upon-a-key # nobody is there to be asked
cd "$work/here" || exit 1
failures=0 ran=0
failed() { cat "$work/log"; echo "FAILED: $*"; failures=$((failures + 1)); }
say() { echo "examples: $*"; }

helps() { # each example of a --help
  local program command
  for program in telepalp-server telepalp-station telepalp-record telepalp-report telepalp-view telepalp-export telepalp-codec telepalp-probe telepalp-keys telepalp-link telepalp-replay telepalp-study telepalp-mixed telepalp-bench; do
    "$program" --help | sed -n 's/^example: //p'
    for command in $("$program" --help | awk '/^commands \(/ {inside = 1; next} /^$/ {inside = 0} inside && /^  [a-z]/ {print $1}'); do
      "$program" "$command" --help | sed -n 's/^example: //p'
    done
  done
  "$source_dir/deploy/demo" --help | sed -n 's/^example: //p'
}
documents() { # each command in a fenced block
  # docs/two-sites.md and meeting-point.md need several machines: two_sites_test.sh and meeting_point_test.sh follow them
  find "$source_dir"/docs -maxdepth 1 -name '*.md' ! -name two-sites.md ! -name meeting-point.md -print0 | sort -z |
    xargs -0 awk 'FNR == 1 {inside = 0} /^```/ {inside = !inside; next} inside' | sed 's/  *#.*$//' |
    grep -E '^(telepalp-|deploy/|build/release/bin/)'
}
mapfile -t examples < <({ helps; documents; } | awk '!seen[$0]++')

# The files that examples name.
ln -s "$source_dir/deploy" "$source_dir/tests" "$source_dir/haptic_station" .
mkdir -p docs build/release out recordings "$HOME/.local/state/telepalp"
ln -s "$bin" build/release/bin
cp "$source_dir/deploy/demo_data/calibration/pairs.csv" pairs.csv
cp "$source_dir/deploy/demo_data/oni/3dj_test.oni" recording.oni
cp "$source_dir/tests/data/pcd/person.pcd" torso.pcd
cp "$source_dir/tests/data/images_rgb_depth/depth/$(ls "$source_dir/tests/data/images_rgb_depth/depth" | head -n 1)" frame.png
awk '/^```textproto/ {inside = 1; next} /^```/ {inside = 0} inside' "$source_dir/docs/scenes.md" >my.scene.textproto
cat >camera.textproto <<'CAMERA'
depth { fx: 525 fy: 525 cx: 319.5 cy: 239.5 width: 640 height: 480 }
depth_unit_m: 0.001
CAMERA

until_ctrl_c() { # SECONDS COMMAND
  set -m # a process group of its own, so that it gets Ctrl-C as from a terminal
  bash -c "$2" >"$work/log" 2>&1 </dev/null &
  local pid=$!
  set +m
  for _ in $(seq 600); do [ -s "$work/log" ] && break; sleep 0.1; done
  sleep "$1"
  kill -INT -- "-$pid" 2>/dev/null
  wait "$pid"
}
bounded() { sed -E 's/--seconds [0-9]+/--seconds 2/; s/--operators 2 --penetrations 2/--operators 1 --penetrations 1/' <<<"$1"; }

refused() { # EXAMPLE SENTENCE: it must fail, and say the sentence
  say "refused: $1"
  timeout 20 bash -c "$1" >"$work/log" 2>&1 </dev/null && failed "$1 ended with 0"
  grep -q "$2" "$work/log" || failed "$1"
}
run() { # EXAMPLE
  local line=$1 code
  ran=$((ran + 1))
  : >"$work/log"
  line=${line//fault-….mcap/fault-example.mcap}
  local out
  out=$(sed -nE 's/.*--out ([^ ]+\.mcap).*/\1/p' <<<"$line")
  [ -z "$out" ] || rm -f "$out" "$out.partial" # of an example before this one
  cp "$work/cut_off.mcap" session.mcap.partial 2>/dev/null
  [[ $out == session.mcap ]] && rm session.mcap.partial
  case $line in
    deploy/demo*" --out out") rm -rf out ;; # of an example before this one
    deploy/demo*) ;;
    deploy/*)
      say "exists: $line"
      [ -x "${line%% *}" ] || failed "$line: no such file"
      return ;;
    telepalp-bench* | "telepalp-station scene bill"* | "telepalp-study search"*)
      say "started: $line"
      timeout 1.5 bash -c "$line" >"$work/log" 2>&1 </dev/null
      code=$?
      grep -q '^error:' "$work/log" && failed "$line"
      [ "$code" = 2 ] && failed "$line ended with 2"
      return ;;
    "telepalp-station rearm"*) refused "$line" '^error: there is no fault to re-arm from'; return ;;
    "telepalp-station hand-over"*) refused "$line" '^error: this server has no keys, so nobody holds the touch'; return ;;
    "telepalp-record reseal"*) refused "$line" '^error: session.mcap: is not encrypted'; return ;;
    "telepalp-record "*nats://*) refused "$line" 'No server available for connection'; return ;;
    *" --device haply "*) refused "$line" '^error: device .* is not ready'; return ;;
    "telepalp-replay diff"*)
      say "differs: $line"
      timeout 60 bash -c "$line" >"$work/log" 2>&1 </dev/null
      [ $? = 1 ] && grep -q '^message ' "$work/log" || failed "$line"
      return ;;
    *"| grep"*) line=${line%%|*} ;;
  esac
  if [ "$(bounded "$line")" != "$line" ]; then
    say "bounded: $line"
    timeout 300 bash -c "$(bounded "$line")" >"$work/log" 2>&1 </dev/null || failed "$line ended with $?"
  elif [[ $line == deploy/demo* || $line == "telepalp-study designer"* || $line == "telepalp-study protocol"* || ($line == telepalp-s* && $line == *--connect*) ]]; then
    say "ctrl-c: $line"
    until_ctrl_c 3 "$line" || failed "$line ended with $?"
  else
    say "$line"
    timeout 300 bash -c "$line" >"$work/log" 2>&1 </dev/null || failed "$line ended with $?"
  fi
}

in_background() { # READY-WORD COMMAND…: a peer that examples speak to
  "${@:2}" >"$work/peer.$1" 2>&1 &
  background+=($!)
  for _ in $(seq 150); do grep -q "$1" "$work/peer.$1" && return 0; sleep 0.1; done
  cat "$work/peer.$1"
  failed "no peer that says '$1'"
}

for example in "${examples[@]}"; do [[ $example == telepalp-server* ]] && run "$example"; done
in_background listening telepalp-server --source synthetic
in_background touchable telepalp-station # the one that `rearm` finds
telepalp-record --out session.mcap --seconds 2 >"$work/log" 2>&1 || failed "the recorder does not find the server by their defaults"
cp session.mcap out/session.mcap
cp session.mcap "$HOME/.local/state/telepalp/fault-example.mcap"
head -c -3000 session.mcap >"$work/cut_off.mcap"
telepalp-probe path --cloud torso.pcd --out path.csv 2>"$work/log" || failed "no path"
for example in "${examples[@]}"; do [[ $example == telepalp-server* ]] || run "$example"; done
say "$ran examples, $failures failures"
[ "$ran" -ge 25 ] && [ "$failures" = 0 ]
