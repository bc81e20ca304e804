#!/usr/bin/env bash
# Follows docs/two-sites.md word by word, between two network namespaces with a third one between them, in which
# telepalp-link delays and reorders; the office has no network. two_sites_test.sh SOURCE_DIR BIN_DIR ends with 77 where
# namespaces are not permitted.
set -uo pipefail
source_dir=$1 bin=$2
page=$source_dir/docs/two-sites.md
export PATH=$bin:$PATH
patient=tp_patient_$$ doctor=tp_doctor_$$ office=tp_office_$$ net=tp_net_$$
middle=$net spaces=("$patient" "$doctor" "$office" "$net")
# shellcheck source=tests/end_to_end/followed_page.sh
. "$(dirname "$0")/followed_page.sh"
# Each site has its own passphrase: a program that opened another one's key would end the test.
for site in patient doctor office; do
  mkdir "$work/$site"
  (umask 077; echo "the passphrase of the $site" >"$work/$site.passphrase")
done
ip netns add "$office" && ip -n "$office" link set lo up

# The doctor's site sees the server at 10.0.0.5: a router there forwards to the patient's site.
join "$patient" 10.0.1.5 10.0.1.1 pat
join "$doctor" 10.0.0.9 10.0.0.5 doc

space_of() { case $1 in patient) echo "$patient" ;; doctor) echo "$doctor" ;; office) echo "$office" ;; esac; }
with_passphrase() { # SITE COMMAND…
  local file=$work/$1.passphrase
  shift
  TELEPALP_PASSPHRASE_FILE=$file TELEPALP_NEW_PASSPHRASE_FILE=$file "$@"
}
start() { # SITE NAME COMMAND…
  local site=$1 name=$2
  shift 2
  with_passphrase "$site" start_in "$work/$site" "$(space_of "$site")" "$work/$name.log" "$@"
}
carry() { # FROM TO FILE
  mkdir -p "$work/$2/$(dirname "$3")" && cp "$work/$1/$3" "$work/$2/$3"
}

for port in 7400 8765; do
  ip netns exec "$net" telepalp-link --listen 10.0.0.5:$port --connect 10.0.1.5:$port --profile lte --seed 1 --quiet >"$work/link_$port.log" 2>&1 &
  background+=($!)
done

ran=0
while IFS=$'\t' read -r -u 3 kind line; do
  ran=$((ran + 1))
  echo "two sites: $kind: $line"
  case $kind in
    "carry "*)
      # shellcheck disable=SC2086
      carry ${kind#carry } "$line" || fail "$line cannot be carried"
      grep -q 'PRIVATE KEY' "$work/${kind##* }/$line" && fail "$line carries a private key" ;;
    "patient background")
      # shellcheck disable=SC2086
      start patient server $line
      wait_for "the server, with an address to give away" "$work/server.log" "viewer at https://10.0.0.5:8765/" ;;
    "doctor background")
      # shellcheck disable=SC2086
      start doctor station $line
      wait_for "the station" "$work/station.log" "link connected"
      wait_for "the station's datagrams" "$work/station.log" "the images come by sealed datagrams" ;;
    patient | doctor | office)
      # shellcheck disable=SC2086
      (cd "$work/$kind" && with_passphrase "$kind" timeout 60 ip netns exec "$(space_of "$kind")" $line) >"$work/step.log" 2>&1 </dev/null || fail "$line" "$work/step.log"
      case $line in
        curl*) grep -qx ok "$work/step.log" || fail "$line does not print ok" "$work/step.log" ;;
        *"record info"*) grep -q '/camera/depth' "$work/step.log" || fail "the session holds no depth" "$work/step.log" ;;
        *audit-verify*) grep -q 'none altered' "$work/step.log" || fail "$line" "$work/step.log" ;;
      esac ;;
    *) fail "the page has a block of the kind '$kind'" ;;
  esac
done 3< <(blocks)
[ "$ran" -ge 21 ] || fail "only $ran steps were found in the page"

# What the page promises.
for site in patient doctor; do [ -e "$work/$site/keys/authority.key" ] && fail "the authority's key is at the $site's"; done
grep -q 'BEGIN ENCRYPTED PRIVATE KEY' "$work/doctor/keys/anna.key" || fail "no passphrase protects the doctor's key"
locked=$(cd "$work/doctor" && timeout 30 ip netns exec "$doctor" telepalp-record --connect 10.0.0.5 --key keys/anna.key --consent test --out locked.mcap --seconds 2 2>&1 </dev/null) && fail "a key is used without its passphrase"
grep -q 'passphrase' <<<"$locked" || fail "a missing passphrase is not told: $locked"
bank=$(cd "$work/office" && with_passphrase office telepalp-keys server --name bank --host bank.example 2>&1) && fail "the authority signs for a bank"
grep -q 'limited to 10.0.0.5' <<<"$bank" || fail "the authority's limits are not told: $bank"
wait_for "the revoked station ends" "$work/station.log" "is revoked"
for event in took-touch records; do
  grep -q "event=$event who=doctor anna" "$work/patient/keys/audit.log" || fail "the audit log does not name $event" "$work/patient/keys/audit.log"
done
stolen=$(cd "$work/doctor" && with_passphrase doctor timeout 30 ip netns exec "$doctor" telepalp-record --connect 10.0.0.5 --key keys/anna.key --consent test --out stolen.mcap --seconds 2 2>&1) && fail "a revoked key still records"
grep -q 'revoked' <<<"$stolen" || fail "a revoked key is not told so: $stolen"
plain=$(cd "$work/doctor" && timeout 30 ip netns exec "$doctor" telepalp-record --connect 10.0.0.5 --out plain.mcap --seconds 2 2>&1) && fail "no key, and yet it records"
grep -q 'no key is given' <<<"$plain" || fail "without a key it is not told so: $plain"
[ "$failures" = 0 ] && echo "two sites: $ran steps of the page, over the lte profile"
exit $((failures > 0))
