#!/usr/bin/env bash
# Holds every program, and every command that has a help of its own, to what a user may expect of it: `-h` prints what
# --help prints, which fits a terminal of 80 columns and 40 lines (but for the line to paste) and ends with an example;
# --version tells version, commit and formats; where neither can be written, as on a full disk, the exit code is 1; an
# option given twice, or with an empty value, ends with 2.
# usage: help_test.sh SOURCE_DIR BIN_DIR
set -uo pipefail
source_dir=$1 bin=$2
failures=0
failed() { echo "FAILED: $*"; failures=$((failures + 1)); }

# The commands of a program that have a help of their own, from its help.
commands_of() { "$bin/$1" --help | awk '/^commands \(/ {inside = 1; next} /^$/ {inside = 0} inside && /^  [a-z]/ {print $1}'; }

check() { # PROGRAM [COMMAND]
  local help
  help=$("$bin/$1" ${2:+"$2"} --help) || failed "$* --help ends with $?"
  [ "$("$bin/$1" ${2:+"$2"} -h)" = "$help" ] || failed "$* -h is not its --help"
  case $(tail -n 1 <<<"$help") in "example: $1"*) ;; *) failed "$* --help does not end with an example" ;; esac
  [ "$(wc -l <<<"$help")" -le 40 ] || failed "$* --help has $(wc -l <<<"$help") lines"
  grep -v '^example: ' <<<"$help" | awk -v who="$*" 'BEGIN {bad = 0} length($0) > 82 {bad = 1; print who ": too wide: " $0} END {exit bad}' ||
    failed "$* --help is wider than 80 columns"
  for part in "$1${2:+ $2}: " 'usage: ' 'options:' '  -h, --help' '  --version'; do
    grep -qF -- "$part" <<<"$help" || failed "$* --help lacks '$part'"
  done
  "$bin/$1" ${2:+"$2"} --version | tr '\n' ' ' |
    grep -qE "^$1 [0-9.]+, commit ([0-9a-f]{7,}(-modified)?|unknown) wire protocol [0-9]+, depth codec [0-9]+, MCAP [0-9]+ $" ||
    failed "$* --version tells something else"
  local asked said
  for asked in --version --help; do
    said=$("$bin/$1" ${2:+"$2"} $asked 2>&1 >/dev/full)
    [ $? = 1 ] && grep -q 'error: standard output: the output could not be written: No space left' <<<"$said" ||
      failed "$* $asked to a full disk ends well, or says: $said"
  done
  local option
  option=$(sed -n 's/^  \(--[a-z-]* [A-Z][^ ]*\).*/\1/p' <<<"$help" | head -n 1)
  [ -n "$option" ] || return 0
  # shellcheck disable=SC2086
  grep -q 'is given twice' <<<"$("$bin/$1" ${2:+"$2"} $option $option 2>&1)" || failed "$* takes ${option% *} twice"
  "$bin/$1" ${2:+"$2"} "${option% *}" '' 2>/dev/null >&2
  [ $? = 2 ] || failed "$* takes an empty ${option% *}"
}

programs=(telepalp-server telepalp-meet telepalp-station telepalp-record telepalp-report telepalp-view telepalp-export telepalp-codec telepalp-probe telepalp-keys telepalp-link telepalp-replay telepalp-worker telepalp-study telepalp-mixed telepalp-bench)
for program in "${programs[@]}"; do
  check "$program"
  for command in $(commands_of "$program"); do check "$program" "$command"; done
done
"$bin/telepalp-station" --help | grep -qE '^  rearm ' || failed "the station's help does not list its commands"

demo=$("$source_dir/deploy/demo" --help) || failed "deploy/demo --help ends with $?"
[ "$("$source_dir/deploy/demo" -h)" = "$demo" ] || failed "deploy/demo -h is not its --help"
awk 'BEGIN {bad = 0} length($0) > 80 {bad = 1; print "deploy/demo: too wide: " $0} END {exit bad}' <<<"$demo" ||
  failed "deploy/demo --help is wider than 80 columns"
case $(tail -n 1 <<<"$demo") in "example: deploy/demo"*) ;; *) failed "deploy/demo --help does not end with an example" ;; esac

grep -q 'is given twice' <<<"$("$source_dir/deploy/demo" --seconds 2 --seconds 3 2>&1)" || failed "deploy/demo takes --seconds twice"

[ "$(TELEPALP_BIN=$bin "$source_dir/deploy/demo" --version)" = "$("$bin/telepalp-server" --version | sed 's#telepalp-server#deploy/demo#')" ] ||
  failed "deploy/demo --version tells another version than its programs"
grep -q -- '--version' <<<"$demo" || failed "deploy/demo --help lacks --version"

# One place holds the default ports; scripts and documents agree with it.
port() { sed -n "s/.*$1 = \"\([0-9]*\)\".*/\1/p" "$source_dir/support/program/default_ports.h"; }
grep -q "http_port:=$(port kViewerPort)}" "$source_dir/deploy/demo" || failed "deploy/demo has another port for browsers"
grep -qF "[$(port kViewerPort), headless 0]" <<<"$demo" || failed "deploy/demo --help tells another port for browsers"
grep -qF -- "--port $(port kServerPort) --http-port $(port kViewerPort)" "$source_dir/README.md" || failed "README.md names other ports"
for program in telepalp-station telepalp-record telepalp-view; do
  "$bin/$program" --help | grep -qF "[127.0.0.1:$(port kServerPort)]" || failed "$program connects to another port than the server's"
done
"$bin/telepalp-server" --help | grep -E '^  --port ' | grep -qF "[$(port kServerPort)]" || failed "the server listens on another port"

echo "help: $failures failures"
[ "$failures" = 0 ]
