#!/usr/bin/env bash
# relayed_touch_test.sh SOURCE_DIR BIN: follows the touch session of docs/meeting-point.md where the routers of both sites
# let datagrams pass over the relay alone, by UDP and by TCP, and reads its report. Ends with 77 where namespaces,
# nftables or coturn are missing.
set -uo pipefail
source_dir=$1 bin=$2
export PATH=$bin:$PATH
# shellcheck source=tests/end_to_end/nat_sites.sh
. "$(dirname "$0")/nat_sites.sh"
page=$work/touch.md
awk '/^## / {inside = /A touch session/} inside' "$source_dir/docs/meeting-point.md" >"$page"
make_keys
begin_relay
begin_meet
mkdir "$work/doctor" && cp "$work/keys/anna.key" "$work/keys/authority.crt" "$work/doctor"

figure() { sed -n "s/^ *\"$1\": \([-0-9.e]*\),*$/\1/p" "$work/doctor/touch/report.json" | head -n 1; }
of_state() { sed -n "/^ *\"$1\": {/,/}/s/^ *\"$2\": \([-0-9.e]*\),*$/\1/p" "$work/doctor/touch/report.json"; }
at_least() { awk -v value="${1:-none}" -v least="$2" 'BEGIN {exit !(value + 0 >= least && value != "none")}'; }

touch_over() { # WAY
  local ran=0 recorder=
  rm -rf "$work/doctor/touch" "$work/doctor/touch.mcap"
  while IFS=$'\t' read -r -u 3 kind line; do
    ran=$((ran + 1))
    echo "relayed touch: $kind: $line"
    case $kind in
      "doctor background")
        # shellcheck disable=SC2086
        start_in "$work/doctor" "$doctor" "$work/record.log" $line
        recorder=${background[-1]}
        wait_for "the recording" "$work/record.log" "recording" ;;
      doctor)
        case $line in telepalp-report*) wait "$recorder" || fail "the recording" "$work/record.log" ;; esac
        # shellcheck disable=SC2086
        (cd "$work/doctor" && timeout 60 ip netns exec "$doctor" $line) >"$work/step.log" 2>&1 </dev/null || fail "$line" "$work/step.log" ;;
      *) fail "the page has a block of the kind '$kind'" ;;
    esac
  done 3< <(blocks)
  [ "$ran" = 3 ] || fail "$ran steps instead of 3 were found in the page"
  local said
  said=$(grep -o 'In [0-9.]* s the doctor touched[^<]*' "$work/doctor/touch/report.html" | head -n 1)
  echo "relayed touch: $said"
  grep -q "Images and touch went by datagrams over a relay ($1), round trip [0-9]* ms\|Images and touch went by datagrams over a relay ($1), round trip below 1 ms" <<<"$said" || fail "the report does not name the relay ($1): $said"
  grep -q "the images come by sealed datagrams, over a relay ($1)" "$work/doctor/touch/report.html" || fail "the events do not name the relay ($1)"
  at_least "$(figure contact_s)" 2 || fail "in contact for $(figure contact_s) s"
  at_least "$(figure max_in_contact)" 0.2 || fail "a force of $(figure max_in_contact) N"
  at_least "$(figure ticks)" 25000 || fail "$(figure ticks) ticks"
  [ "$(of_state faulted entries)" = 0 ] || fail "$(of_state faulted entries) faults"
  # Before its first image, a station has let go; it must not do so again.
  at_least 1 "$(of_state released entries)" || fail "the hand was released $(of_state released entries) times"
}
for kind in symmetric tcp-443; do
  router doctor "$kind"
  server_behind "$kind"
  case $kind in symmetric) touch_over UDP ;; *) touch_over TCP ;; esac
done
exit $((failures > 0))
