# Two sites behind routers of seven kinds, and a network between them with the meeting point and a real relay (coturn).
# A script sets `source_dir` and `bin` and sources this file. It ends with 77 where namespaces, nftables or coturn are missing.
for program in nft turnserver; do
  command -v "$program" >/dev/null || { echo "skipped: $program is not installed"; exit 77; }
done
patient=tp_ppat_$$ patient_router=tp_pprt_$$ doctor=tp_pdoc_$$ doctor_router=tp_pdrt_$$ net=tp_pnet_$$
middle=$net spaces=("$patient" "$patient_router" "$doctor" "$doctor_router" "$net")
# shellcheck source=tests/end_to_end/followed_page.sh
. "$(dirname "${BASH_SOURCE[0]}")/followed_page.sh"
ip netns exec "$net" nft list ruleset >/dev/null 2>&1 || { echo "skipped: the kernel has no nftables here"; exit 77; }

join_site() { # SITE ROUTER SITE_NETWORK WAN_NETWORK NAME
  ip netns add "$2" && ip netns add "$1" && ip link add "$5a" netns "$1" type veth peer name lan netns "$2" &&
    ip link add wan netns "$2" type veth peer name "$5n" netns "$net" || { echo "skipped: no veth here"; exit 77; }
  ip -n "$1" addr add "$3.2/24" dev "$5a" && ip -n "$2" addr add "$3.1/24" dev lan
  ip -n "$2" addr add "$4.2/24" dev wan && ip -n "$net" addr add "$4.1/24" dev "$5n"
  ip -n "$1" link set lo up && ip -n "$1" link set "$5a" up && ip -n "$2" link set lo up && ip -n "$2" link set lan up
  ip -n "$2" link set wan up && ip -n "$net" link set "$5n" up
  ip -n "$1" route add default via "$3.1" && ip -n "$2" route add default via "$4.1"
  ip netns exec "$2" sh -c 'echo 1 >/proc/sys/net/ipv4/ip_forward'
  mkdir -p "/etc/netns/$1" && printf '127.0.0.1 localhost\n192.0.2.1 meet.example ward3.meet.example\n' >"/etc/netns/$1/hosts"
}
join_site "$patient" "$patient_router" 10.1.0 203.0.113 ppa
join_site "$doctor" "$doctor_router" 10.2.0 198.51.100 pdo
ip -n "$net" link set lo up && ip -n "$net" addr add 192.0.2.1/32 dev lo
ip netns exec "$net" sh -c 'echo 1 >/proc/sys/net/ipv4/ip_forward'

# What a router of each kind does. The kernel keeps a mapping's port (RFC 4787: endpoint-independent mapping) unless it
# is told to draw one; datagrams that nobody inside has asked for are dropped unless a rule lets them in.
router() { # patient|doctor KIND
  local space site wan
  if [ "$1" = patient ]; then space=$patient_router site=10.1.0.2 wan=203.0.113.2 lan=10.1.0.0/24
  else space=$doctor_router site=10.2.0.2 wan=198.51.100.2 lan=10.2.0.0/24; fi
  ip -n "$net" route del "$lan" 2>/dev/null
  local inside='' into='' out="snat to $wan" let=''
  case $2 in
    open) out=''; ip -n "$net" route add "$lan" via "$wan" ;;
    independent) into="iifname wan udp dport 1024-65535 dnat to $site" ;;
    address) inside='update @met { ip daddr timeout 120s }' into="iifname wan ip saddr @met udp dport 1024-65535 dnat to $site" ;;
    port) ;;
    symmetric) out='masquerade fully-random' ;;
    no-udp) let='meta l4proto udp drop' ;;
    half-open) let='iifname lan meta l4proto udp drop' ;;  # UDP comes in and does not go out
    tcp-443) let='ct state established accept; iifname lan tcp dport 443 accept; drop' ;;
    *) fail "no router of the kind $2"; return ;;
  esac
  ip netns exec "$space" nft -f - <<RULES || fail "the rules of a router of the kind $2"
flush ruleset
table ip site {
  set met { type ipv4_addr; flags dynamic, timeout; }
  chain before { type nat hook prerouting priority -100; $into; }
  chain through { type filter hook forward priority 0; ${inside:+iifname lan meta l4proto udp $inside;} $let; }
  chain own { type filter hook input priority 0; ${out:+iifname wan meta l4proto udp drop;} }
  chain after { type nat hook postrouting priority 100; ${out:+oifname wan $out;} }
}
RULES
}

move() { # patient|doctor NUMBER: the site's computer gets another address, 10.1.0.NUMBER or 10.2.0.NUMBER
  local space=$doctor network=10.2.0 card=pdoa
  [ "$1" = doctor ] || space=$patient network=10.1.0 card=ppaa
  ip -n "$space" addr flush dev "$card" && ip -n "$space" addr add "$network.$2/24" dev "$card" &&
    ip -n "$space" route add default via "$network.1"
}

renumber() { # patient|doctor NUMBER: the provider gives the site's router another address, and the router forgets all mappings
  local space=$doctor_router network=198.51.100
  [ "$1" = doctor ] || space=$patient_router network=203.0.113
  ip -n "$space" addr flush dev wan && ip -n "$space" addr add "$network.$2/24" dev wan &&
    ip -n "$space" route add default via "$network.1"
}

begin_relay() {
  openssl rand -hex 32 >"$work/relay.secret"
  cp "$source_dir/deploy/service/telepalp-relay.conf" "$work/relay.conf"
  echo "static-auth-secret=$(cat "$work/relay.secret")" >>"$work/relay.conf"
  start_in "$work" "$net" "$work/relay.log" turnserver -c "$work/relay.conf" --listening-ip=192.0.2.1 \
    --relay-ip=192.0.2.1 --log-file=stdout --simple-log --pidfile="$work/relay.pid" --userdb="$work/relay.db"
}
begin_meet() {
  start_in "$work" "$net" "$work/meet.log" "$bin/telepalp-meet" --key keys/meet.key --relay 192.0.2.1 --relay-secret relay.secret
  wait_for "the meeting point" "$work/meet.log" "listening on"
  meet_pid=${background[-1]}
}
meet_again() { # with the relay's secret as it is now
  kill -INT "$meet_pid" && wait "$meet_pid" 2>/dev/null
  : >"$work/server.log"
  begin_meet
  wait_for "the server comes back" "$work/server.log" "joined the meeting point"
}
begin_server() {
  start_in "$work" "$patient" "$work/server.log" "$bin/telepalp-server" --source synthetic \
    --key keys/server.key --meet meet.example
  wait_for "the server" "$work/server.log" "joined the meeting point"
}
server_behind() { # KIND
  [ -z "${server_pid:-}" ] || { kill -INT "$server_pid" && wait "$server_pid" 2>/dev/null; }
  router patient "$1"
  begin_server
  server_pid=${background[-1]} server_at=$1
}
make_keys() {
  (cd "$work" && "$bin/telepalp-keys" authority --host meet.example && "$bin/telepalp-keys" server --host meet.example --name meet &&
    "$bin/telepalp-keys" server --host ward3.meet.example && "$bin/telepalp-keys" client --name anna --role doctor) >"$work/keys.log" 2>&1 || fail "keys" "$work/keys.log"
}
