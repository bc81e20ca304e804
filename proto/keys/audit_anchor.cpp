#include "proto/keys/audit_anchor.h"

#include <openssl/evp.h>

#include <charconv>
#include <optional>
#include <span>
#include <sstream>
#include <tuple>
#include <vector>

#include "proto/keys/x509/openssl.h"

namespace telepalp::keys {
namespace {

constexpr std::string_view kSignature = " signature=";
/// Begins each signed text, because the key also signs TLS handshakes.
constexpr std::string_view kAnchorBegins = "telepalp audit anchor 1\n";

/// The bytes that `text` writes in hexadecimal; empty: it is not hexadecimal.
std::string from_hex(std::string_view text) {
  std::string bytes;
  for (; text.size() >= 2; text.remove_prefix(2)) {
    unsigned value = 0;
    if (std::from_chars(text.data(), text.data() + 2, value, 16).ptr != text.data() + 2) return {};
    bytes += static_cast<char>(value);
  }
  return text.empty() ? bytes : std::string();
}

std::string text_of(const AuditAnchor& anchor) {
  return "anchor time=" + anchor.time + " lines=" + std::to_string(anchor.end.lines) + " hash=" + anchor.end.hash;
}

bool is_signed(const std::string& text, const std::string& signature, std::string_view certificate) {
  const std::vector<CertificatePtr> signers = certificates_in(certificate);
  const std::string message = std::string(kAnchorBegins) + text;
  const DigestPtr digest(EVP_MD_CTX_new());
  return !signers.empty() && !signature.empty() &&
         EVP_DigestVerifyInit(digest.get(), nullptr, EVP_sha256(), nullptr, X509_get0_pubkey(signers.front().get())) ==
             1 &&
         EVP_DigestVerify(digest.get(), bytes_of(signature), signature.size(), bytes_of(message), message.size()) == 1;
}

/// The value of the word "name=value"; nullopt: `word` does not begin with `name=`.
std::optional<std::string> value_of(const std::string& word, std::string_view name) {
  if (!word.starts_with(name)) return std::nullopt;
  return word.substr(name.size());
}

std::optional<AuditAnchor> anchor_in(const std::string& text) {
  std::istringstream words(text);
  std::string begin, time, lines, hash;
  if (!(words >> begin >> time >> lines >> hash) || begin != "anchor") return std::nullopt;
  const auto [t, l, h] = std::tuple{value_of(time, "time="), value_of(lines, "lines="), value_of(hash, "hash=")};
  if (!t || !l || !h) return std::nullopt;
  AuditAnchor anchor{.time = *t, .end = {.lines = 0, .hash = *h}};
  const auto [end, wrong] = std::from_chars(l->data(), l->data() + l->size(), anchor.end.lines);
  return wrong == std::errc() && end == l->data() + l->size() ? std::optional(anchor) : std::nullopt;
}

}  // namespace

Result<std::string> anchor_line(const AuditAnchor& anchor, const KeyFile& server) {
  EVP_PKEY* const key = server.private_key.get();
  const std::string message = std::string(kAnchorBegins) + text_of(anchor);
  const DigestPtr digest(EVP_MD_CTX_new());
  std::string signature(160, '\0');
  std::size_t size = signature.size();
  if (key == nullptr || EVP_DigestSignInit(digest.get(), nullptr, EVP_sha256(), nullptr, key) != 1 ||
      EVP_DigestSign(digest.get(), reinterpret_cast<unsigned char*>(signature.data()), &size, bytes_of(message),
                     message.size()) != 1)
    return openssl_error("anchor of the audit log");
  return text_of(anchor) + std::string(kSignature) + in_hexadecimal(std::span(bytes_of(signature), size));
}

Result<AuditAnchor> read_anchor(std::string_view line, std::string_view certificate) {
  const std::size_t at = line.find(kSignature);
  const std::string text(line.substr(0, at));
  const std::optional<AuditAnchor> anchor = anchor_in(text);
  if (at == std::string_view::npos || !anchor ||
      !is_signed(text, from_hex(line.substr(at + kSignature.size())), certificate))
    return Error{.what = "this is no anchor of an audit log, or the server's key did not sign it",
                 .where = std::string(line.substr(0, 60)),
                 .fix = "give a whole line as the server wrote it: anchor time=… lines=… hash=… signature=…"};
  return *anchor;
}

}  // namespace telepalp::keys
