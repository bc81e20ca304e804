#!/usr/bin/env bash
# meeting_point_test.sh SOURCE_DIR BIN_DIR: runs the commands of docs/meeting-point.md as they stand. The patient's and
# the doctor's network reach the meeting point, but not each other. Ends with 77 where namespaces are not permitted.
set -uo pipefail
source_dir=$1 bin=$2
page=$source_dir/docs/meeting-point.md
export PATH=$bin:$PATH
patient=tp_mpatient_$$ doctor=tp_mdoctor_$$ meet=tp_mmeet_$$
middle=$meet spaces=("$patient" "$doctor" "$meet")
# shellcheck source=tests/end_to_end/followed_page.sh
. "$(dirname "$0")/followed_page.sh"
mkdir "$work/patient" "$work/doctor" "$work/meet"

# The meeting point has a leg in each network and forwards nothing between them.
join_by_name() { # SPACE ADDRESS MEET_ADDRESS NAME
  join "$@"
  mkdir -p "/etc/netns/$1" && printf '127.0.0.1 localhost\n%s meet.example ward3.meet.example\n' "$3" >"/etc/netns/$1/hosts"
}
join_by_name "$patient" 10.0.1.5 10.0.1.1 mpat
join_by_name "$doctor" 10.0.0.9 10.0.0.1 mdoc
ip -n "$meet" link set lo up
ip netns exec "$meet" sh -c 'echo 0 >/proc/sys/net/ipv4/ip_forward'

space_of() { case $1 in patient) echo "$patient" ;; doctor) echo "$doctor" ;; meet) echo "$meet" ;; esac; }
start() { # SITE COMMAND…
  local site=$1
  shift
  start_in "$work/$site" "$(space_of "$site")" "$work/$site.log" "$@"
}

ran=0
while IFS=$'\t' read -r -u 3 kind line; do
  ran=$((ran + 1))
  echo "meeting point: $kind: $line"
  case $kind in
    "carry to "*) cp "$work/patient/$line" "$work/${kind#carry to }/" || fail "$line cannot be carried" ;;
    "meet background")
      # shellcheck disable=SC2086
      start meet $line
      wait_for "the meeting point" "$work/meet.log" "listening on" ;;
    "patient background")
      # shellcheck disable=SC2086
      start patient $line
      wait_for "the server" "$work/patient.log" "joined the meeting point meet.example" ;;
    "doctor background")
      # shellcheck disable=SC2086
      start doctor $line
      recorder=${background[-1]}
      wait_for "the recording" "$work/doctor.log" "recording" ;;
    patient | doctor)
      case $line in telepalp-report*) wait "$recorder" || fail "the recording" "$work/doctor.log" ;; esac
      # shellcheck disable=SC2086
      (cd "$work/$kind" && timeout 60 ip netns exec "$(space_of "$kind")" $line) >"$work/step.log" 2>&1 </dev/null || fail "$line" "$work/step.log"
      case $line in
        curl*) grep -qx ok "$work/step.log" || fail "$line does not print ok" "$work/step.log" ;;
        *"record info"*) grep -q '/camera/depth' "$work/step.log" || fail "the session holds no depth" "$work/step.log" ;;
        telepalp-report*) grep -q 'Images and touch went over TCP' "$work/doctor/touch/report.html" || fail "the report does not name the way" "$work/step.log" ;;
        *snapshot*) [ -s "$work/doctor/view.png" ] || fail "no picture" "$work/step.log" ;;
      esac ;;
    *) fail "the page has a block of the kind '$kind'" ;;
  esac
done 3< <(blocks)
[ "$ran" -ge 15 ] || fail "only $ran steps were found in the page"

# What the page promises.
ip netns exec "$doctor" timeout 3 bash -c 'exec 3<>/dev/tcp/10.0.1.5/7400' 2>/dev/null && fail "the two networks reach each other: nothing is proved"
grep -q "event=records who=doctor anna" "$work/patient/keys/audit.log" || fail "the site's audit does not name anna" "$work/patient/keys/audit.log"
grep -q 'event=joined who=doctor anna program="telepalp-view".*consent="signed-form"' "$work/patient/keys/audit.log" || fail "the audit has no consent of telepalp-view" "$work/patient/keys/audit.log"
unasked=$(cd "$work/doctor" && telepalp-view --connect ward3.meet.example@meet.example --key anna.key --snapshot no.png 2>&1)
[ $? = 2 ] && grep -q 'consent to your watching is not stated' <<<"$unasked" || fail "telepalp-view watches without the patient's consent: $unasked"
kill -KILL "${background[0]}" && wait "${background[0]}" 2>/dev/null
wait_for "the server notices" "$work/patient.log" "no connection with the meeting point"
: >"$work/patient.log"
start meet telepalp-meet --key meet.key
wait_for "the server comes back by itself" "$work/patient.log" "joined the meeting point"
wrong=$(cd "$work/doctor" && timeout 30 ip netns exec "$doctor" telepalp-record --connect ward4@meet.example --key anna.key --consent signed-form --out no.mcap --seconds 2 --patience 2 2>&1) && fail "a site that is not there was recorded"
grep -q 'unrecognized name' <<<"$wrong" || fail "a wrong name is not told: $wrong"
[ "$failures" = 0 ] && echo "meeting point: $ran steps of the page"
exit $((failures > 0))
