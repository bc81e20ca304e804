#!/usr/bin/env bash
# Two networks with the kernel's queue of 20 Mbit/s between them, and shared_line_test.mjs in the patient's one:
# shared_line_test.sh NODE BIN_DIR VIEWER_DIR [PICTURES]. Ends with 77 where network namespaces are not permitted.
set -euo pipefail
if [ -z "${LINE_OF_OUR_OWN:-}" ]; then
  unshare --net --map-root-user true 2>/dev/null || exit 77
  exec env LINE_OF_OUR_OWN=1 unshare --net --map-root-user "$0" "$@"
fi
node=$1
shift
unshare --net sleep 300 &
doctor=$!
trap 'kill "$doctor"' EXIT
until [ "$(readlink "/proc/$doctor/ns/net")" != "$(readlink /proc/$$/ns/net)" ]; do sleep 0.02; done
ip link add line type veth peer name line netns "$doctor"
in_space() { if [ "$1" = doctor ]; then nsenter -t "$doctor" -n "${@:2}"; else "${@:2}"; fi; }
for side in patient doctor; do
  in_space "$side" ip link set lo up
  in_space "$side" ip addr add "10.9.0.$([ "$side" = patient ] && echo 1 || echo 2)/24" dev line
  in_space "$side" ip link set line up
  in_space "$side" tc qdisc add dev line root tbf rate 20mbit burst 32kb limit 500000 2>/dev/null || exit 77
done
"$node" --test-reporter=spec "$(dirname "$0")/shared_line_test.mjs" "$doctor" "$@"
