#!/usr/bin/env bash
# A thief of authority.key signs for a bank and for a host of the site: a browser that trusts the authority believes the
# second alone. limited_authority_test.sh BIN_DIR; ends with 77 without chromium or certutil.
set -uo pipefail
export PATH=$1:$PATH
for tool in chromium certutil openssl; do command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }; done
work=$(mktemp -d)
servers=()
leave() { kill "${servers[@]}" 2>/dev/null; rm -rf "$work"; }
trap leave EXIT
cd "$work" && export HOME=$work || exit 1
fail() { echo "FAILED: $1"; [ -n "${2:-}" ] && tail -n 5 "$2"; exit 1; }

telepalp-keys authority --host hospital.example >keys.log || fail "no authority" keys.log
sed -n '/BEGIN PRIVATE/,/END PRIVATE/p' keys/authority.key >stolen.key
forge() { # NAME PORT: a certificate and a web server with it
  openssl req -new -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -keyout "$1.key" -subj /CN=x -out "$1.req" 2>openssl.log &&
    printf 'subjectAltName=DNS:%s\nextendedKeyUsage=serverAuth\nbasicConstraints=critical,CA:FALSE\n' "$1" >ext &&
    openssl x509 -req -in "$1.req" -CA keys/authority.crt -CAkey stolen.key -extfile ext -days 9 -out "$1.crt" 2>openssl.log ||
    fail "$1 cannot be signed" openssl.log
  openssl s_server -accept "$2" -cert "$1.crt" -key "$1.key" -www -quiet >"$1.log" 2>&1 &
  servers+=($!)
}
forge ward.hospital.example 9444
forge bank.example 9443
openssl verify -CAfile keys/authority.crt ward.hospital.example.crt >verify.log 2>&1 || fail "OpenSSL refuses the site's own host" verify.log
openssl verify -CAfile keys/authority.crt bank.example.crt >verify.log 2>&1 && fail "OpenSSL believes a bank"
grep -q 'permitted subtree violation' verify.log || fail "OpenSSL refuses the bank for another reason" verify.log

mkdir -p .pki/nssdb && certutil -d "sql:$work/.pki/nssdb" -N --empty-password &&
  certutil -d "sql:$work/.pki/nssdb" -A -t C,, -n telepalp -i keys/authority.crt || fail "the authority cannot be imported"
look() { # URL
  timeout 90 chromium --headless --no-sandbox --disable-gpu --user-data-dir="$work/profile" \
    --host-resolver-rules='MAP * 127.0.0.1' --dump-dom "$1" 2>browser.log
}
for _ in $(seq 100); do (exec 3<>/dev/tcp/127.0.0.1/9444) 2>/dev/null && break; sleep 0.1; done
look https://ward.hospital.example:9444/ >page
grep -q 's_server' page || fail "the browser does not trust the site's own host, so nothing is proved" browser.log
look https://bank.example:9443/ >page
grep -q 's_server' page && fail "the browser believes a bank that the site's authority signed"
grep -q 'net::ERR_CERT' page browser.log || fail "the bank fails for another reason than its certificate" browser.log
echo "limited authority: $(chromium --version 2>/dev/null | cut -d' ' -f1,2) believes the site's host, and not the bank"
