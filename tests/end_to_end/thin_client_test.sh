#!/usr/bin/env bash
# A thin client needs neither PCL nor a camera's driver: no such library is linked, directly or through another.
# usage: thin_client_test.sh PROGRAM...
set -uo pipefail
failures=0
for program in "$@"; do
  libraries=$(ldd "$program") || { echo "FAILED: ldd $program"; exit 1; }
  grep -q libprotobuf <<<"$libraries" || { echo "FAILED: $program links no Protobuf: is it ours?"; failures=$((failures + 1)); }
  if grep -iE 'pcl|openni|libvtk' <<<"$libraries"; then
    echo "FAILED: $program is not thin"
    failures=$((failures + 1))
  fi
done
[ "$failures" = 0 ]
