#!/bin/sh
# symbol_gate.sh ARCHIVE…: fails when an archive of the real-time part refers to anything that allocates, locks, throws,
# prints, or calls the system.
set -eu
banned='operator (new|delete)|\b(malloc|calloc|realloc|free|posix_memalign|aligned_alloc)\b|mutex|pthread_|__cxa_(throw|allocate|guard)|std::__throw|printf|\b(read|write|open|ioctl|usleep|nanosleep|clock_gettime)\b|std::basic_(string|ostream|istream)'
status=0
for archive in "$@"; do
  symbols=$(nm -uC "$archive")
  [ -n "$symbols" ] || { echo "$archive: no symbols: not an archive?" >&2; exit 1; }
  if printf '%s\n' "$symbols" | grep -E "$banned"; then
    echo "$archive: refers to the symbols above" >&2
    status=1
  fi
done
exit $status
