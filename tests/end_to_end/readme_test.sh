#!/usr/bin/env bash
# Runs the README's commands as they stand in its fenced blocks. What runs until Ctrl-C is given 6 s and then a Ctrl-C;
# what needs a camera must say so; `deploy/test` is what runs this. usage: readme_test.sh SOURCE_DIR BIN_DIR
set -uo pipefail
cd "$1"
export TELEPALP_BIN=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
ran=0

say() { echo "readme: $*"; }
failed() { say "FAILED: $*"; failures=$((failures + 1)); }

# The commands, without their comments. Written paths stay; only the place for output and programs are moved, so that
# a test leaves nothing behind in the tree.
mapfile -t commands < <(awk '/^```/ {inside = !inside; next} inside' README.md | sed 's/ *#.*$//' | grep -v '^$')
placed() { sed -e "s#build/release/bin#$TELEPALP_BIN#g" -e "s#--out out#--out $work/out#" -e "s# session\.mcap# $work/session.mcap#g" -e "s#--out report#--out $work/report#" <<<"$1"; }

until_ctrl_c() {  # SECONDS COMMAND: must end well at Ctrl-C
  # Job control gives the command a process group of its own, so that it gets Ctrl-C as from a terminal.
  set -m
  bash -c "$2" >"$work/log" 2>&1 </dev/null &
  local pid=$!
  set +m
  sleep "$1"
  kill -INT -- "-$pid" 2>/dev/null
  wait "$pid"
}

background=()
for command in "${commands[@]}"; do
  placed=$(placed "$command")
  ran=$((ran + 1))
  say "$command"
  case $command in
    deploy/test* | deploy/package*) ran=$((ran - 1)) ;;  # this is run by the one; Installation tests what the other packs
    *openni2*)
      if timeout 30 bash -c "$placed --headless --seconds 2 --out $work/camera" >"$work/log" 2>&1; then
        say "a camera is there"
      else
        grep -q 'fix:' "$work/log" || { cat "$work/log"; failed "$command"; }
      fi ;;
    *--headless* | *telepalp-record* | *telepalp-report*)
      timeout 60 bash -c "$placed" >"$work/log" 2>&1 </dev/null || { cat "$work/log"; failed "$command"; } ;;
    deploy/demo*) until_ctrl_c 6 "$placed" || { cat "$work/log"; failed "$command"; } ;;
    *)
      set -m
      bash -c "exec $placed" >"$work/log.$ran" 2>&1 </dev/null &
      background+=($!)
      set +m
      sleep 2 ;;
  esac
done
for ((i = ${#background[@]} - 1; i >= 0; i--)); do
  kill -INT "${background[i]}" 2>/dev/null || { cat "$work"/log.*; failed "a program of the README ended early"; }
  wait "${background[i]}" || { cat "$work"/log.*; failed "a program of the README did not end well at Ctrl-C"; }
done
for file in out/report.html out/report.json out/view.png out/session.mcap report/report.html; do
  [ -s "$work/$file" ] || failed "no $file"
done
say "$ran commands, $failures failures"
[ "$ran" -ge 8 ] && [ "$failures" = 0 ]
