# What the tests share that follow a page of docs/ word by word in network namespaces. A test sets `page`, `middle` (the
# namespace between the sites) and `spaces` (all of them), and then sources this file. It ends with 77 where namespaces
# are not permitted.
work=$(mktemp -d)
failures=0
background=()
fail() { echo "FAILED: $1"; [ -n "${2:-}" ] && tail -n 20 "$2"; failures=$((failures + 1)); }
leave() {
  for pid in "${background[@]}"; do kill -INT "$pid" 2>/dev/null; done
  for pid in "${background[@]}"; do wait "$pid" 2>/dev/null; done
  for space in "${spaces[@]}"; do ip netns delete "$space" 2>/dev/null; rm -rf "/etc/netns/${space:?}"; done
  rm -rf "$work"
}
trap leave EXIT
if ! command -v ip >/dev/null || ! ip netns add "$middle" 2>/dev/null; then
  echo "skipped: network namespaces are not permitted here"
  exit 77
fi
mkdir "$work/run"
chmod 700 "$work/run"
export HOME=$work XDG_RUNTIME_DIR=$work/run

join() { # SPACE ADDRESS ADDRESS_IN_THE_MIDDLE NAME
  ip netns add "$1" && ip link add "$4a" netns "$1" type veth peer name "$4b" netns "$middle" &&
    ip -n "$1" addr add "$2/24" dev "$4a" && ip -n "$middle" addr add "$3/24" dev "$4b" &&
    ip -n "$1" link set "$4a" up && ip -n "$middle" link set "$4b" up && ip -n "$1" link set lo up && return 0
  echo "skipped: no veth here"
  exit 77
}
blocks() { # each command of the page's blocks, in order: the block's kind, a tab, the command
  awk '/^```/ {inside = !inside; kind = substr($0, 4); next} inside {print kind "\t" $0}' "$page"
}
start_in() { # FOLDER SPACE LOG COMMAND…
  local folder=$1 space=$2 log=$3
  shift 3
  (cd "$folder" && exec ip netns exec "$space" "$@") >"$log" 2>&1 &
  background+=($!)
}
wait_for() { # WHAT FILE TEXT
  for _ in $(seq 300); do grep -q "$3" "$2" 2>/dev/null && return 0; sleep 0.1; done
  fail "$1: not within 30 s" "$2"
}
