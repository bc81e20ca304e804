#!/usr/bin/env bash
# What watches a server: a real Prometheus takes the files of deploy/monitoring, reads a running server, and answers each
# query of the dashboard with a figure; each alert fires on what it is for, and names a section of the runbook.
# usage: monitoring_test.sh SOURCE BIN. Ends with 77 without Prometheus.
set -euo pipefail
source_dir=$1 bin=$2
work=$(mktemp -d)
background=()
trap '[ ${#background[@]} = 0 ] || kill "${background[@]}" 2>/dev/null || true; wait; rm -rf "$work"' EXIT
fail() { echo "FAILED: $1" >&2; exit 1; }
for tool in prometheus promtool curl node; do command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }; done

cp "$source_dir"/deploy/monitoring/* "$source_dir/tests/deploy/alerts.test.yml" "$work"
cd "$work"
promtool check config prometheus.yml >"$work/checked" 2>&1 || { cat "$work/checked" >&2; fail "prometheus.yml"; }
promtool test rules alerts.test.yml >"$work/checked" 2>&1 || { cat "$work/checked" >&2; fail "an alert"; }

sections=$(sed -n 's/^### //p' "$source_dir/docs/operations.md" | tr '[:upper:] ' '[:lower:]-')
grep -o 'operations.md#[a-z-]*' telepalp.alerts.yml | cut -d'#' -f2 | while read -r section; do
  grep -qx -- "$section" <<<"$sections" || fail "an alert names the section '$section', which the runbook has not"
done

"$bin/telepalp-server" --source synthetic --port 0 --http-port 0 --health-port 0 --ready-file ready >server.log 2>&1 &
background+=($!)
for _ in $(seq 100); do [ -s ready ] && break; sleep 0.1; done
value() { sed -n "s/^$1=//p" ready; }
[ -n "$(value health_port)" ] || { cat server.log >&2; fail "the server does not start"; }
"$bin/telepalp-station" --connect "127.0.0.1:$(value port)" --control none --realtime prefer >station.log 2>&1 &
background+=($!)

curl --silent "http://127.0.0.1:$(value health_port)/metrics" | promtool check metrics >"$work/checked" 2>&1 || { cat "$work/checked" >&2; fail "promtool finds faults in /metrics"; }

port=$((20000 + $$ % 20000))
sed -i "s/127.0.0.1:8766/127.0.0.1:$(value health_port)/; s/15s/1s/" prometheus.yml
prometheus --config.file=prometheus.yml --storage.tsdb.path=data --web.listen-address="127.0.0.1:$port" >prometheus.log 2>&1 &
background+=($!)
cat >ask.mjs <<'JS'
import {readFileSync} from 'node:fs';
const [port] = process.argv.slice(2);
const queries = JSON.parse(readFileSync('telepalp.dashboard.json', 'utf8')).panels.flatMap(({title, targets}) => targets.map(({expr}) => ({title, expr})));
const answer = async (expr) => {
  const url = `http://127.0.0.1:${port}/api/v1/query?query=${encodeURIComponent(expr.replaceAll('$instance', '.*'))}`;
  const {status, error, data} = await (await fetch(url)).json();
  if (status !== 'success') throw new Error(`${expr}: ${error}`);
  return data.result.map(({value}) => Number(value[1])).filter(Number.isFinite);
};
let open = queries, figures = new Map();
for (const end = Date.now() + 60_000; open.length > 0 && Date.now() < end; await new Promise((later) => setTimeout(later, 1000))) {
  const left = [];
  for (const query of open) {
    const found = await answer(query.expr).catch((why) => { if (why.cause) return []; throw why; });
    if (found.length > 0) figures.set(query.expr, [query.title, found]); else left.push(query);
  }
  open = left;
}
for (const [title, found] of figures.values()) console.log(`${title}: ${found.map((value) => value.toPrecision(4)).join(' ')}`);
if (open.length > 0) { console.error(`no answer: ${open.map(({title, expr}) => `${title}: ${expr}`).join('; ')}`); process.exit(1); }
const images = await answer('max(rate(telepalp_published_messages_total{topic="/camera/depth"}[5s]))');
if (!(images[0] > 5)) { console.error(`images a second: ${images}`); process.exit(1); }
JS
node ask.mjs "$port" || { tail -n 5 prometheus.log server.log station.log >&2; fail "a query of the dashboard has no answer"; }
echo "monitoring: each query of the dashboard has a figure, and each alert fires"
