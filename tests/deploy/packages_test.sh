#!/usr/bin/env bash
# Makes the Debian packages and reads them: no file is in two of them, together they hold what an installation holds, and
# a thin client needs neither PCL nor a camera's driver: packages_test.sh CPACK BUILD
set -euo pipefail
cpack=$1 build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED: $1" >&2; exit 1; }
for tool in dpkg-deb dpkg-shlibdeps file; do command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }; done

"$cpack" --config "$build/CPackConfig.cmake" -B "$work/made" >"$work/log" 2>&1 || { tail -n 20 "$work/log" >&2; fail "cpack"; }
package() { ls "$work/made/$1"_*.deb; }
field() { dpkg-deb -f "$(package "$1")" "$2"; }
files() { dpkg-deb -c "$(package "$1")" | awk '!/\/$/ {print $6}'; }

names=(telepalp telepalp-clients telepalp-data telepalp-server telepalp-station telepalp-tools)
[ "$(ls "$work/made"/*.deb | wc -l)" = ${#names[@]} ] || fail "other packages than expected: $(ls "$work/made")"
for name in "${names[@]}"; do files "$name"; done | sort >"$work/files"
[ -z "$(uniq -d "$work/files")" ] || fail "files in two packages: $(uniq -d "$work/files" | xargs)"

holds() { # PACKAGE PROGRAM...
  local name=$1; shift
  for program in "$@"; do
    files "$name" | grep -qx "./usr/bin/telepalp-$program" || fail "$name does not hold telepalp-$program"
    files "$name" | grep -q "/man1/telepalp-$program.1" || fail "$name has no man page of telepalp-$program"
  done
  [ "$(files "$name" | grep -c '^./usr/bin/')" = $# ] || fail "$name holds other programs, too"
}
holds telepalp-clients view record report export replay link mixed
holds telepalp-server server keys meet
holds telepalp-station station
holds telepalp-tools codec probe study worker
holds telepalp demo
files telepalp-tools | grep -q 'study/designer/page/index.html' || fail "the study has no designer's page"
files telepalp-tools | grep -q 'study/protocol/page/index.html' || fail "the study has no page of the protocol"
files telepalp-server | grep -q 'telepalp/viewer/index.html' || fail "the server has no web page"

needs() { field "$1" Depends | tr ',' '\n' | grep -qE "^ *$2"; }
for name in telepalp-clients telepalp-tools; do
  for banned in libpcl libopenni; do needs "$name" "$banned" && fail "$name needs $banned: $(field "$name" Depends)"; done
done
needs telepalp-clients libprotobuf || fail "the libraries of telepalp-clients are not named: $(field telepalp-clients Depends)"
needs telepalp-tools libnlopt0 || fail "telepalp-tools does not name the library of its search: $(field telepalp-tools Depends)"
needs telepalp-clients libnlopt && fail "a thin client needs the library of the search"
needs telepalp-station libpcl || fail "the station, which shows PCL's indexes, does not need PCL: is the check above vain?"
for part in clients server station tools; do
  needs "telepalp-$part" telepalp-data || fail "telepalp-$part does without scenes and demo data"
  needs telepalp "telepalp-$part" || fail "telepalp does without telepalp-$part"
done

dpkg-deb -e "$(package telepalp-server)" "$work/control"
grep -q 'stop telepalp-server.service' "$work/control/prerm" || fail "the server's package does not stop its service"
! grep -q 'telepalp-station.service' "$work/control/prerm" || fail "the server's package stops the station"
files telepalp-station | grep -qx ./etc/security/limits.d/telepalp.conf || fail "the station's package has no real-time limits"
dpkg-deb -e "$(package telepalp-station)" "$work/station"
grep -qx /etc/security/limits.d/telepalp.conf "$work/station/conffiles" || fail "an upgrade would replace the site's limits"
# Up to version 0.1, one package held all files. An upgrade from it moves them to the new packages, and leaves it none
# of their files. Unpacking is where dpkg refuses files of another package.
old=$work/old root=$work/root
mkdir -p "$old/DEBIAN" "$root/var/lib/dpkg/"{info,updates,triggers}
touch "$root/var/lib/dpkg/status" "$root/var/lib/dpkg/available"
while read -r file; do install -D /dev/null "$old/$file"; done <"$work/files"
install -D /dev/null "$old/usr/share/telepalp/gone"
printf '%s\n' 'Package: telepalp' 'Version: 0.1.0' 'Architecture: amd64' 'Maintainer: test <test@localhost>' 'Description: all in one' >"$old/DEBIAN/control"
dpkg-deb --root-owner-group -b "$old" "$work/old.deb" >/dev/null
unpack() { dpkg --root="$root" --force-not-root --force-depends --force-breaks --auto-deconfigure --log="$work/dpkg.log" --unpack "$@" >"$work/unpacked" 2>&1 || { cat "$work/unpacked" >&2; fail "dpkg refuses an upgrade from version 0.1"; }; }
unpack "$work/old.deb"
[ -e "$root/usr/share/telepalp/gone" ] || fail "the old package was not unpacked"
unpack "$work/made"/*.deb
[ ! -e "$root/usr/share/telepalp/gone" ] || fail "an upgrade leaves files of version 0.1"
owner() { dpkg --root="$root" -S "$1" 2>/dev/null | cut -d: -f1; }
for owned in server:/usr/bin/telepalp-server clients:/usr/bin/telepalp-view station:/usr/bin/telepalp-station; do
  [ "$(owner "${owned#*:}")" = "telepalp-${owned%%:*}" ] || fail "after an upgrade, ${owned#*:} belongs to '$(owner "${owned#*:}")'"
done
echo "packages: ${names[*]}; an upgrade from one package moves their files"
