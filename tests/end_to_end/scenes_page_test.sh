#!/usr/bin/env bash
# The scene that docs/scenes.md gives to begin with, as a reader saves it: it is read without a warning, drawn, meshed,
# and felt by the real station with a server and a patient. usage: scenes_page_test.sh SOURCE_DIR BIN_DIR
set -uo pipefail
source_dir=$1 bin=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0
failed() { cat "$work/log"; echo "FAILED: $*"; failures=$((failures + 1)); }

awk '/^```textproto/ {inside = 1; next} /^```/ {inside = 0} inside' "$source_dir/docs/scenes.md" >my.scene.textproto
grep -q haptic_from_camera my.scene.textproto || failed "the page has no scene"

"$bin/telepalp-station" scene check my.scene.textproto >log 2>warnings || failed "scene check"
[ -s warnings ] && { cat warnings >>log; failed "the page's scene is warned about"; }
grep -q 'effects: skin, ball' log || failed "scene check names other effects"
"$bin/telepalp-station" scene show my.scene.textproto --from feet --out my.png >log 2>&1 || failed "scene show"
"$bin/telepalp-station" scene mesh my.scene.textproto --layer ball --out ball.ply >log 2>&1 || failed "scene mesh"
grep -q 'closed, 1 part, Euler number 2, 7.2' log || failed "the mesh is not a ball of 12 mm radius"

TELEPALP_BIN=$bin "$source_dir/deploy/demo" --headless --seconds 10 --scene my.scene.textproto --out out >log 2>&1 </dev/null ||
  failed "deploy/demo"
grep -Eq '"name": ?"ball"' out/report.json || { cp out/report.json log; failed "the ball is not in the report's bill"; }
touched_s=$(sed -nE 's/.*"contact_s": ?([0-9.]+).*/\1/p' out/report.json | head -n 1)
awk -v s="${touched_s:-0}" 'BEGIN {exit !(s > 0.5)}' || failed "touched for ${touched_s:-0} s"
echo "scenes page: $failures failures"
[ "$failures" = 0 ]
