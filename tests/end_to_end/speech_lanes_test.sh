#!/usr/bin/env bash
# What the room says is recorded, encrypted and in a cluster, and a page that plays the session is told at once where
# somebody speaks; a copy without the recorder's word for it is surveyed: speech_lanes_test.sh BIN. Ends with 77 if
# nats-server is not installed.
set -uo pipefail
# shellcheck source=tests/end_to_end/around_nats.sh
. "$(dirname "$0")/around_nats.sh"
value_of() { for _ in $(seq 200); do [ -s "$1.ready" ] && break; sleep 0.1; done; sed -n "s/^$2=//p" "$1.ready"; }
base=$((20000 + ($$ + 31) % 20000))
start nats nats-server -a 127.0.0.1 -p "$base" -js -sd store
wait_for "NATS server" nats.log "Server is ready"
cluster="nats://127.0.0.1:$base"
telepalp-keys site-key --name ward3 --dir keys >keys.log 2>&1 || fail "site-key" keys.log
export TELEPALP_SITE_KEYS=keys/ward3-site.key

# The microphone of the room: a second of a tone that swells, a second of silence, again and again.
node -e 'const out = Buffer.alloc(2 * 48000 * 60);
  for (let i = 0; i < 48000 * 60; ++i)
    if (Math.floor(i / 48000) % 2 === 0)
      out.writeInt16LE(Math.round(9000 * Math.sin(2 * Math.PI * 200 * i / 48000) * Math.sin(2 * Math.PI * 4 * i / 48000) ** 2), 2 * i);
  require("fs").writeFileSync("said.raw", out)' || fail "a sound file"
cat >asoundrc <<EOF
pcm.nothing { type null }
pcm.room_in { type file slave.pcm nothing file /dev/null infile "$PWD/said.raw" format raw }
pcm.room { type asym capture.pcm room_in playback.pcm nothing }
EOF
ALSA_CONFIG_PATH=$PWD/asoundrc start site telepalp-server --source synthetic:torso,width=160 --port 0 --ready-file site.ready \
  --voice open:alsa:room
site=$(value_of site port)
wait_for "the open microphone" site.log "the microphone of the room is open"
telepalp-record --connect "127.0.0.1:$site" --out "$cluster/ward3/a.mcap" --consent "form 1, until 2199-01-01" \
  --voice-consent "form 1" --topics '*' --seconds 8 >record.log 2>&1 || fail "recording in the cluster" record.log
telepalp-record info "$cluster/ward3/a.mcap" >info.log 2>&1 || fail "info" info.log
grep -q "^/patient/voice" info.log || fail "the session has no speech" info.log

# Prints how often somebody speaks, and for how many seconds, as the page of a server is told that plays SESSION.
lanes_of() { # NAME SESSION
  start "$1" telepalp-server --source "session:$2,paused=yes" --port 0 --http-port 0 --ready-file "$1.ready"
  local port
  port=$(value_of "$1" http_port)
  node -e 'const until = Date.now() + 20000;
    (async () => {
      for (;;) {
        const {speech} = await (await fetch(`http://127.0.0.1:${process.argv[1]}/playback/events`)).json();
        if (speech.length > 0 || Date.now() > until)
          return console.log(speech.length, speech.reduce((sum, one) => sum + one.until_s - one.from_s, 0).toFixed(1), speech.every((one) => !one.doctor));
        await new Promise((done) => setTimeout(done, 100));
      }
    })()' "$port"
}
told=$(lanes_of player "$cluster/ward3/a.mcap")
awk -v told="$told" 'BEGIN {split(told, t, " "); exit !(t[1] >= 3 && t[1] <= 6 && t[2] >= 2.5 && t[2] <= 6 && t[3] == "true")}' ||
  fail "where the room speaks is told wrongly: $told" player.log

# A part of it has no word of the recorder's that holds.
telepalp-record copy "$cluster/ward3/a.mcap" --out a.mcap >copy.log 2>&1 || fail "copy" copy.log
[ "$(head -c 8 a.mcap | tr -d '\0' | grep -c MCAP)" = 0 ] || fail "the session is not encrypted"
telepalp-record cut a.mcap --out part.mcap --from 3s >cut.log 2>&1 || fail "cut" cut.log
part=$(lanes_of part part.mcap)
awk -v told="$part" 'BEGIN {split(told, t, " "); exit !(t[1] >= 1 && t[1] <= 4 && t[2] >= 1 && t[2] <= 4)}' ||
  fail "where the room speaks in a part is told wrongly: $part" part.log

telepalp-report a.mcap --out report >report.log 2>&1 || fail "report" report.log
grep -q "speech: the patient" report/report.html || fail "the report has no lane of speech" report.log
[ "$failures" = 0 ] && echo "speech lanes: times, seconds: $told; of a part: $part"
exit $((failures > 0))
