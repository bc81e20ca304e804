#!/usr/bin/env bash
# Recordings encrypted with a site's key: recorded, played, exported, reported, repaired, given another key, and given
# away in a copy that anybody reads: sealed_recording_test.sh BIN.
set -uo pipefail
export PATH=$1:$PATH
work=$(mktemp -d)
background=()
trap '[ ${#background[@]} = 0 ] || kill "${background[@]}" 2>/dev/null; wait; rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0
fail() { echo "FAILED: $1" >&2; [ -z "${2:-}" ] || tail -n 20 "$2" >&2; failures=$((failures + 1)); }
port_of() { for _ in $(seq 100); do [ -s "$1.ready" ] && break; sleep 0.1; done; sed -n 's/^port=//p' "$1.ready"; }

telepalp-keys site-key --name ward3 --dir keys >keys.log 2>&1 || fail "site-key" keys.log
telepalp-keys site-key --name ward3 --dir keys >again.log 2>&1 && fail "a site's key is overwritten" again.log
[ "$(stat -c %a keys/ward3-site.key)" = 600 ] || fail "others may read the site's key"
grep -q PRIVATE keys/ward3-site.pub && fail "the public part holds the private one"

telepalp-server --source synthetic --port 0 --ready-file site.ready >site.log 2>&1 &
background+=($!)
site=$(port_of site)
# The recorder needs the public part alone, and cannot read what it wrote.
TELEPALP_SITE_KEYS=keys/ward3-site.pub telepalp-record --connect "127.0.0.1:$site" --out a.mcap --seconds 4 >record.log 2>&1 || fail "an encrypted recording" record.log
[ "$(head -c 8 a.mcap)" = TPSEAL01 ] || fail "the recording is not encrypted"
grep -q "camera" a.mcap && fail "the recording shows its topics"
TELEPALP_SITE_KEYS=keys/ward3-site.pub telepalp-record info a.mcap >public.log 2>&1 && fail "the public part decrypts" public.log
telepalp-record info a.mcap >none.log 2>&1 && fail "it is read without a key" none.log
grep -q "fix: name the private part" none.log || fail "the missing key is not said" none.log

export TELEPALP_SITE_KEYS=keys/ward3-site.key
telepalp-record verify a.mcap >verify.log 2>&1 || fail "verify" verify.log
telepalp-record copy a.mcap --plain --out plain.mcap >copy.log 2>&1 || fail "a copy that is not encrypted" copy.log
[ "$(head -c 1 plain.mcap | xxd -p)" = 89 ] || fail "the plain copy is encrypted"
telepalp-record copy plain.mcap --out again.mcap >copy.log 2>&1 || fail "an encrypted copy" copy.log
telepalp-record copy again.mcap --plain --out back.mcap >copy.log 2>&1 || fail "back" copy.log
cmp plain.mcap back.mcap || fail "the copies differ"
telepalp-export a.mcap --csv /camera/status --out status.csv >export.log 2>&1 || fail "export" export.log
telepalp-report a.mcap --out report >report.log 2>&1 || fail "report" report.log
telepalp-replay a.mcap --seconds 2 --out replay >replay.log 2>&1 || fail "replay" replay.log
telepalp-server --source session:a.mcap,from_s=1 --port 0 --http-port 0 --ready-file player.ready >player.log 2>&1 &
background+=($!)
telepalp-view --connect "127.0.0.1:$(port_of player)" --snapshot played.png --patience 20 >view.log 2>&1 || fail "no picture of the encrypted session" view.log

# A note on it is encrypted, too, and is read by whoever reads the session.
page=http://127.0.0.1:$(sed -n 's/^http_port=//p' player.ready)
note='a mass under the ninth rib'
curl -sf -m 10 -d "{\"at_s\": 1.5, \"text\": \"$note\"}" "$page/playback/notes" >noted.json || fail "a note" player.log
grep -q "$note" noted.json || fail "the note is not listed" noted.json
[ "$(head -c 8 a.mcap.notes.json)" = TPSEAL01 ] || fail "the notes are not encrypted"
grep -qa "ninth" a.mcap.notes.json && fail "the notes can be read without a key"
telepalp-report a.mcap --out noted >report.log 2>&1 || fail "report with notes" report.log
grep -q "$note" noted/report.html || fail "the report does not list the note"
grep -q "keep noted on an encrypted disk" report.log || fail "a report that is not encrypted is not said" report.log
telepalp-record copy a.mcap --plain --out plain_noted.mcap >copy.log 2>&1 || fail "a plain copy with notes" copy.log
grep -q "and the notes on it" copy.log || fail "the copy says nothing of the notes" copy.log
grep -q "$note" plain_noted.mcap.notes.json || fail "the plain copy's notes are not plain" plain_noted.mcap.notes.json
telepalp-record copy plain_noted.mcap --out noted_again.mcap >copy.log 2>&1 || fail "an encrypted copy with notes" copy.log
[ "$(head -c 8 noted_again.mcap.notes.json)" = TPSEAL01 ] || fail "the encrypted copy's notes are plain"
echo '{}' >taken.mcap.notes.json
telepalp-record copy a.mcap --out taken.mcap >taken.log 2>&1 && fail "notes of another session become the copy's" taken.log
[ ! -e taken.mcap ] || fail "a refused copy is there"

# A copy that names nobody is given away, so it is not encrypted, and has no notes.
telepalp-export a.mcap --deidentify given.mcap --out given.txt >given.log 2>&1 || fail "deidentify" given.log
grep -q "1 note on the session" given.txt || fail "the notes are not told" given.txt
[ ! -e given.mcap.notes.json ] || fail "the copy to give away has notes"
env -u TELEPALP_SITE_KEYS telepalp-record info given.mcap >given_info.log 2>&1 || fail "the copy to give away is encrypted" given_info.log

# Damage is said, and the rest is read.
cp a.mcap damaged.mcap
printf 'x' | dd of=damaged.mcap bs=1 seek=$(($(stat -c %s a.mcap) / 2)) conv=notrunc 2>/dev/null
telepalp-record verify damaged.mcap >damaged.log 2>&1 && fail "a damaged block is not noticed" damaged.log
grep -q "damage: " damaged.log || fail "the damage is not said" damaged.log
telepalp-record repair damaged.mcap --out repaired.mcap >repair.log 2>&1 || fail "repair of a damaged session" repair.log
head -c $(($(stat -c %s a.mcap) * 2 / 3)) a.mcap >cut.mcap
telepalp-record verify cut.mcap >cut.log 2>&1 && fail "a session that is cut off is not noticed" cut.log
telepalp-record repair cut.mcap --out cut_repaired.mcap >repair.log 2>&1 || fail "repair of a session that is cut off" repair.log
telepalp-record verify cut_repaired.mcap >verify.log 2>&1 || fail "the repaired session" verify.log
[ "$(head -c 8 cut_repaired.mcap)" = TPSEAL01 ] || fail "the repaired session is not encrypted"

# A recorder that is killed leaves what it wrote.
telepalp-record --connect "127.0.0.1:$site" --out killed.mcap >killed.log 2>&1 &
killed=$!
sleep 4
kill -KILL $killed; wait $killed 2>/dev/null
telepalp-record repair killed.mcap >repair.log 2>&1 || fail "a recording whose recorder was killed" repair.log
telepalp-record verify killed.mcap >verify.log 2>&1 || fail "the finished recording" verify.log

# A new key: only the header changes, and the old key no longer decrypts.
telepalp-keys site-key --name next --dir keys >keys.log 2>&1 || fail "the next key" keys.log
tail -c +513 a.mcap | sha256sum >before
TELEPALP_SITE_KEYS=keys/next-site.pub:keys/ward3-site.key telepalp-record reseal a.mcap >reseal.log 2>&1 || fail "reseal" reseal.log
tail -c +513 a.mcap | sha256sum | cmp - before || fail "reseal changed more than the header"
TELEPALP_SITE_KEYS=keys/next-site.key telepalp-report a.mcap --out resealed >report.log 2>&1 || fail "report with the new key" report.log
grep -q "$note" resealed/report.html || fail "the new key does not decrypt the notes"
cp plain_noted.mcap.notes.json a.mcap.notes.json  # as an older version left them
TELEPALP_SITE_KEYS=keys/next-site.pub telepalp-record reseal a.mcap >reseal.log 2>&1 || fail "reseal of plain notes" reseal.log
[ "$(head -c 8 a.mcap.notes.json)" = TPSEAL01 ] || fail "reseal leaves the notes plain"
printf x | dd of=a.mcap.notes.json bs=1 seek=600 conv=notrunc 2>/dev/null
TELEPALP_SITE_KEYS=keys/next-site.key telepalp-report a.mcap --out torn >torn.log 2>&1 && fail "damaged notes are not noticed" torn.log
grep -q "a.mcap.notes.json: was altered" torn.log || fail "damaged notes are not named" torn.log
telepalp-record info a.mcap >old.log 2>&1 && fail "the old key still decrypts" old.log
TELEPALP_SITE_KEYS=keys/next-site.key telepalp-record verify a.mcap >new.log 2>&1 || fail "the new key does not decrypt" new.log
TELEPALP_SITE_KEYS=keys/next-site.key telepalp-record reseal plain.mcap >plain.log 2>&1 && fail "a plain session is given a key" plain.log
grep -q "is not encrypted" plain.log || fail "a plain session is not said" plain.log

# Who deletes by retention needs the key, and says so.
mkdir folder; cp killed.mcap folder/
env -u TELEPALP_SITE_KEYS telepalp-record expire folder --keep-days 1 >expire.log 2>&1
grep -q "is encrypted" expire.log || fail "expire without a key does not say so" expire.log
[ "$failures" = 0 ] && echo "encrypted recordings: recorded, played, exported, repaired, and given a new key"
exit $((failures > 0))
