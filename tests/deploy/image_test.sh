#!/usr/bin/env bash
# An image of the packages in build/ has a root in which the server starts, as the image's user and with nothing else of
# this computer: image_test.sh SOURCES. It needs root, the packages of deploy/package, and Debian's archive.
set -euo pipefail
sources=$1
fail() { echo "FAILED: $1" >&2; [ -z "${2:-}" ] || tail -n 20 "$2" >&2; exit 1; }
skip() { echo "skipped: $1"; exit 77; }
[ "$(id -u)" = 0 ] || skip "only root makes a Debian root"
for tool in umoci mmdebstrap jq unshare; do command -v $tool >/dev/null || skip "$tool is not installed"; done
ls "$sources"/build/telepalp-server_*.deb >/dev/null 2>&1 || skip "there are no packages: deploy/package"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$sources/deploy/image" --out "$work/image" >"$work/made" 2>"$work/log" || fail "deploy/image" "$work/log"
tag=$(cat "$work/made")
version=$(dpkg-deb -f "$sources"/build/telepalp-server_*.deb Version)
[ "$tag" = "$work/image:$version" ] || fail "the image has another name: $tag"
"$sources/deploy/image" --out "$work/image" >/dev/null 2>"$work/again" && fail "an image is overwritten"
"$sources/deploy/image" --out "$work/other" --sources /dev/null >/dev/null 2>"$work/none" && fail "no sources are not noticed"
grep -q "fix: give a file that does by --sources" "$work/none" || fail "no sources are not said" "$work/none"

blob() { echo "$work/image/blobs/${1/://}"; }
manifest=$(blob "$(jq -r '.manifests[0].digest' "$work/image/index.json")")
config=$(blob "$(jq -r '.config.digest' "$manifest")")
[ "$(jq -r '.config.Entrypoint[0] + " " + .config.User' "$config")" = "/usr/bin/telepalp-server 64123:64123" ] || fail "what the image starts" "$config"
[ "$(jq -r '[.history[].created] | unique | length' "$config")" = 1 ] || fail "the image tells when it was made" "$config"

umoci unpack --image "$tag" "$work/unpacked" >"$work/log" 2>&1 || fail "umoci unpack" "$work/log"
root=$work/unpacked/rootfs
[ -s "$root/usr/share/doc/libssl3/copyright" ] || fail "the licences are gone"
find "$root/tmp" "$root/var/cache/apt/archives" -name '*.deb' | grep -q . && fail "packages are left in the image"
inside() { # COMMAND...: as the image's user, without a network
  unshare --mount --pid --net --fork bash -c 'ip link set lo up 2>/dev/null; mount -t proc proc "$1/proc"; cd /; exec chroot --userspec=64123:64123 "$@"' _ "$root" "$@"
}
inside /usr/bin/telepalp-server --version >"$work/version" 2>&1 || fail "--version" "$work/version"
grep -q "$version" "$work/version" || fail "another version" "$work/version"
inside /usr/bin/telepalp-server --source synthetic --port 0 --http-port 0 --check >"$work/check" 2>&1 || fail "--check" "$work/check"
timeout 60 bash -c "$(declare -f inside); root=$root; inside /usr/bin/telepalp-server --source synthetic --port 0 --http-port 0 --seconds 3" >"$work/run" 2>&1 ||
  fail "the server with the synthetic patient and the page" "$work/run"
inside /bin/sh -c ': >/var/lib/telepalp/audit.log' || fail "the image's user may not write its folder"
inside /bin/sh -c ': >/etc/x' 2>/dev/null && fail "the image's user may write elsewhere"

# The meeting point's image holds its relay, too, which takes the configuration that the package ships.
"$sources/deploy/image" --of edge --out "$work/edge" >/dev/null 2>"$work/none" && fail "an unknown image is made"
tag=$("$sources/deploy/image" --of meet --out "$work/meet" 2>"$work/log") || fail "deploy/image --of meet" "$work/log"
umoci unpack --image "$tag" "$work/meet_unpacked" >"$work/log" 2>&1 || fail "umoci unpack" "$work/log"
root=$work/meet_unpacked/rootfs
inside /usr/bin/telepalp-meet --version >"$work/meet_version" 2>&1 || fail "telepalp-meet --version" "$work/meet_version"
inside /bin/sh -c 'cat /usr/share/telepalp/telepalp-relay.conf >/var/lib/telepalp/relay.conf && echo static-auth-secret=test >>/var/lib/telepalp/relay.conf' || fail "the relay's configuration"
timeout 20 bash -c "$(declare -f inside); root=$root; inside /usr/bin/timeout 3 /usr/bin/turnserver -c /var/lib/telepalp/relay.conf --log-file stdout --pidfile /var/lib/telepalp/pid" >"$work/relay" 2>&1 || true
grep -q "listener opened on" "$work/relay" || fail "the relay does not listen" "$work/relay"
root=$work/unpacked/rootfs
echo "image: $(du -sm "$root" | cut -f1) MB, starts $(cat "$work/version")"
