# Shared by the tests that run programs around a real NATS server. A test sources this file with the folder of the
# programs as its first argument, and then works in an empty folder. Ends with 77 if nats-server is not installed.
bin=$1
export PATH=$bin:$PATH:/usr/sbin
command -v nats-server >/dev/null || { echo "skipped: nats-server is not installed"; exit 77; }
work=$(mktemp -d)
background=()
trap '[ ${#background[@]} = 0 ] || kill "${background[@]}" 2>/dev/null; wait; rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0
fail() { # WHAT [LOG]
  echo "FAILED: $1" >&2
  [ -z "${2:-}" ] || tail -n 20 "$2" >&2
  failures=$((failures + 1))
}
wait_for() { # WHAT LOG TEXT [SECONDS]
  for _ in $(seq $((10 * ${4:-20}))); do grep -q "$3" "$2" 2>/dev/null && return; sleep 0.1; done
  fail "$1" "$2"
}
start() { # NAME COMMAND…: its output goes to NAME.log
  local name=$1
  shift
  "$@" >"$name.log" 2>&1 &
  background+=($!)
}
