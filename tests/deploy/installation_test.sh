#!/usr/bin/env bash
# Installs into a folder of its own, checks what is there, and runs it from / : installation_test.sh CMAKE BUILD SOURCE
set -euo pipefail
cmake=$1 build=$2 source=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED: $1" >&2; exit 1; }

prefix=$work/prefix
"$cmake" --install "$build" --prefix "$prefix" >"$work/log" 2>&1 || { cat "$work/log" >&2; fail "cmake --install"; }

programs="server station record report view export codec probe keys link replay worker mixed meet study demo"
for program in $programs; do
  [ -x "$prefix/bin/telepalp-$program" ] || fail "telepalp-$program is not installed"
  [ -s "$prefix/share/man/man1/telepalp-$program.1" ] || fail "telepalp-$program has no man page"
  grep -q " telepalp-$program\$" "$prefix/share/bash-completion/completions/telepalp-$program" ||
    fail "telepalp-$program has no completion"
done
[ "$(ls "$prefix/bin" | wc -l)" = "$(wc -w <<<"$programs")" ] || fail "programs that are not users' are installed: $(ls "$prefix/bin")"
for unit in server station; do
  grep -q '^ProtectSystem=strict' "$prefix/lib/systemd/system/telepalp-$unit.service" || fail "no hardened unit for the $unit"
done
[ -s "$prefix/lib/sysusers.d/telepalp.conf" ] || fail "no sysusers entry"
limits=$prefix/etc/security/limits.d/telepalp.conf
grep -q '^@telepalp-realtime - rtprio [0-9]' "$limits" && grep -q '^@telepalp-realtime - memlock unlimited' "$limits" &&
  grep -q '^g telepalp-realtime ' "$prefix/lib/sysusers.d/telepalp.conf" || fail "no group with real-time limits"
grep -q '^LimitRTPRIO=' "$prefix/lib/systemd/system/telepalp-station.service" &&
  grep -q '^LimitMEMLOCK=infinity' "$prefix/lib/systemd/system/telepalp-station.service" || fail "the station's unit has no real-time limits"
"$cmake" --install "$build" --prefix "$work/root/usr" >"$work/log" 2>&1 || { cat "$work/log" >&2; fail "cmake --install to usr"; }
[ -s "$work/root/etc/security/limits.d/telepalp.conf" ] || fail "a package would put the limits elsewhere than in /etc"
[ "$("$prefix/bin/telepalp-demo" --version)" = "$("$prefix/bin/telepalp-server" --version | sed 's/telepalp-server/telepalp-demo/')" ] ||
  fail "telepalp-demo --version tells another version than its programs"
if grep -rlF -e "$source" -e "$build" "$prefix" >"$work/leaks"; then
  fail "paths of the build are in: $(cat "$work/leaks")"
fi

# Data is found by prefix alone: another working directory, no repository's variable.
cd /
unset TELEPALP_HOME
"$prefix/bin/telepalp-station" --check >"$work/check" 2>&1 || { cat "$work/check" >&2; fail "the station's default scene"; }
timeout 30 "$prefix/bin/telepalp-server" --source synthetic --port 0 --http-port 0 --seconds 1 >"$work/server" 2>&1 ||
  { cat "$work/server" >&2; fail "the server with the synthetic patient and the viewer"; }
echo "installation: all programs, man pages, completion, units, limits, data: found from /"
