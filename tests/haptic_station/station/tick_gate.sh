#!/bin/sh
# tick_gate.sh ARCHIVE FUNCTION…: fails when a FUNCTION of the haptic thread (a demangled name without arguments) is not
# in ARCHIVE, or calls anything that allocates, locks or throws. For archives that also hold what other threads run; the
# archives of the real-time part are read as a whole, by control/symbol_gate.sh.
set -eu
archive=$1
shift
banned='operator (new|delete)|malloc|calloc|realloc|<free|mutex|pthread_|__cxa_(throw|allocate|guard)|std::__throw|printf|condition_variable'
listing=$(mktemp)
trap 'rm -f "$listing"' EXIT
objdump -drC --no-show-raw-insn "$archive" > "$listing"
status=0
for function in "$@"; do
  # A function's own lines, from its label to the next empty line; what it inlines is among them.
  body=$(awk -v want="<$function(" 'index($0, want) && /:$/ {on = 1; next} /^$/ {on = 0} on' "$listing")
  [ -n "$body" ] || { echo "$archive: holds no $function" >&2; status=1; continue; }
  if printf '%s\n' "$body" | grep -E 'R_X86_64_(PLT32|GOTPCREL|PC32)|call' | grep -E "$banned"; then
    echo "$function: calls what is above" >&2
    status=1
  fi
done
exit $status
