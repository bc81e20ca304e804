#!/usr/bin/env bash
# paths_runs.sh SOURCE_DIR BIN: measures each pair of routers of seven kinds, and what a change of the network costs.
# Prints, between tabs: pair PATIENT DOCTOR BEST JOINED_S FIRST_S BEST_S, and change WHAT GAP_S CONNECTIONS WAY.
set -uo pipefail
source_dir=$1 bin=$2
# shellcheck source=tests/end_to_end/nat_sites.sh
. "$(dirname "$0")/../../end_to_end/nat_sites.sh"
kinds='open independent address port symmetric no-udp tcp-443'
site=ward3.meet.example@meet.example
make_keys
begin_relay
begin_meet

best() { # PATIENT DOCTOR: the best way that this pair of routers allows (RFC 4787, RFC 5128 §3.4)
  case "$1 $2" in
    *no-udp* | *tcp-443*) echo 'over a relay (TCP)' ;;
    'port symmetric' | 'symmetric port' | 'symmetric symmetric') echo 'over a relay (UDP)' ;;
    *) echo 'directly' ;;
  esac
}
probe() { (cd "$work" && timeout 60 ip netns exec "$doctor" "$bin/telepalp-path-probe" "$site" keys/anna.key "$@" 2>"$work/probe.log"); }

for at_patient in $kinds; do
  server_behind "$at_patient"
  for at_doctor in $kinds; do
    router doctor "$at_doctor"
    wanted=$(best "$at_patient" "$at_doctor")
    read -r joined first reached _ < <(probe 20 "$wanted")
    printf 'pair\t%s\t%s\t%s\t%s\t%s\t%s\n' "$at_patient" "$at_doctor" "$wanted" "${joined:--}" "${first:--}" "${reached:--}"
  done
done

change() { # WHAT COMMAND…: COMMAND changes the network after 3 s
  local what=$1 gap connections way
  shift
  probe 9 >"$work/probe.out" &
  local running=$!
  wait_for "a way" "$work/probe.log" "the images come by sealed datagrams" >&2
  sleep 2
  "$@" >&2
  wait "$running"
  read -r _ _ _ gap connections way <"$work/probe.out"
  printf 'change\t%s\t%s\t%s\t%s\n' "$what" "$gap" "$connections" "$way"
}
server_behind port
for round in 1 2 3 4; do
  for site_of in doctor patient; do
    router patient port
    router doctor port
    change "UDP cut at the $site_of" router "$site_of" no-udp
    router "$site_of" port
    change "other address of the $site_of" move "$site_of" $((10 + round))
    change "other router of the $site_of" router "$site_of" symmetric
  done
done
server_behind symmetric
router doctor port
for round in 1 2 3 4; do change "other address of the patient's router" renumber patient $((20 + round)); done
router doctor symmetric
for round in 1 2 3 4; do change "other address of the doctor's router" renumber doctor $((20 + round)); done
exit $((failures > 0))
