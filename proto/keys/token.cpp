#include "proto/keys/token.h"

#include <openssl/evp.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <vector>

#include "proto/keys/openssl.h"

namespace telepalp::keys {
namespace {

using DigestPtr = std::unique_ptr<EVP_MD_CTX, Freed<EVP_MD_CTX_free>>;

constexpr std::string_view kPrefix = "tp1.";
constexpr std::string_view kSigned =
    "telepalp token 1\n";  // the authority also signs certificates, which begin otherwise
constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

std::string to_base64(std::string_view bytes) {
  std::string text;
  unsigned waiting = 0;
  int bits = 0;
  for (const char byte : bytes) {
    waiting = (waiting << 8U) | static_cast<unsigned char>(byte);
    for (bits += 8; bits >= 6; bits -= 6) text += kDigits[(waiting >> static_cast<unsigned>(bits - 6)) & 63U];
  }
  if (bits > 0) text += kDigits[(waiting << static_cast<unsigned>(6 - bits)) & 63U];
  return text;
}

std::optional<std::string> from_base64(std::string_view text) {
  std::string bytes;
  unsigned waiting = 0;
  int bits = 0;
  for (const char letter : text) {
    const std::size_t digit = kDigits.find(letter);
    if (digit == std::string_view::npos) return std::nullopt;
    waiting = (waiting << 6U) | static_cast<unsigned>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>((waiting >> static_cast<unsigned>(bits)) & 255U);
  }
  if (to_base64(bytes) != text) return std::nullopt;  // one token has one spelling
  return bytes;
}

bool is_signed(const std::string& payload, const std::string& signature, EVP_PKEY& key) {
  const DigestPtr digest(EVP_MD_CTX_new());
  const std::string message = std::string(kSigned) + payload;
  return EVP_DigestVerifyInit(digest.get(), nullptr, EVP_sha256(), nullptr, &key) == 1 &&
         EVP_DigestVerify(digest.get(), reinterpret_cast<const unsigned char*>(signature.data()), signature.size(),
                          reinterpret_cast<const unsigned char*>(message.data()), message.size()) == 1;
}

std::string payload_of(const Identity& bearer) {
  return bearer.name + " " + std::string(name(bearer.role)) + " " +
         std::to_string(std::chrono::system_clock::to_time_t(bearer.expires)) + " " + bearer.serial;
}

std::optional<Identity> bearer_in(const std::string& payload) {
  std::istringstream words(payload);
  Identity bearer;
  std::string role;
  std::time_t expires = 0;
  if (!(words >> bearer.name >> role >> expires >> bearer.serial)) return std::nullopt;
  const std::optional<Role> known = role_named(role);
  if (!known) return std::nullopt;
  bearer.role = *known;
  bearer.expires = std::chrono::system_clock::from_time_t(expires);
  return bearer;
}

Error refused(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "token", .fix = std::move(fix)};
}

}  // namespace

Result<std::string> sign_token(const Identity& bearer, EVP_PKEY& authority_key) {
  const std::string payload = payload_of(bearer);
  const std::string message = std::string(kSigned) + payload;
  const auto* bytes = reinterpret_cast<const unsigned char*>(message.data());
  const DigestPtr digest(EVP_MD_CTX_new());
  std::string signature(160, '\0');
  std::size_t size = signature.size();
  if (EVP_DigestSignInit(digest.get(), nullptr, EVP_sha256(), nullptr, &authority_key) != 1 ||
      EVP_DigestSign(digest.get(), reinterpret_cast<unsigned char*>(signature.data()), &size, bytes, message.size()) !=
          1)
    return openssl_error("token");
  signature.resize(size);
  return std::string(kPrefix) + to_base64(payload) + "." + to_base64(signature);
}

Result<Identity> read_token(std::string_view token, EVP_PKEY& authority_key, WallTime now) {
  const Error no_token = refused("this is not a token of the server's authority",
                                 "paste all that follows `token:` in a file that telepalp-keys token wrote, or ask the "
                                 "technician for a new token");
  if (token.size() > kMaxTokenBytes || !token.starts_with(kPrefix)) return no_token;
  const std::string_view rest = token.substr(kPrefix.size());
  const std::size_t dot = rest.find('.');
  if (dot == std::string_view::npos) return no_token;
  const std::optional<std::string> payload = from_base64(rest.substr(0, dot));
  const std::optional<std::string> signature = from_base64(rest.substr(dot + 1));
  if (!payload || !signature || !is_signed(*payload, *signature, authority_key)) return no_token;
  const std::optional<Identity> bearer = bearer_in(*payload);
  if (!bearer) return no_token;
  if (bearer->expires <= now)
    return refused("the token of " + describe(*bearer) + " has expired",
                   "ask the technician for a new one: telepalp-keys token");
  return *bearer;
}

Result<Identity> read_token(std::string_view token, std::string_view authority_pem, WallTime now) {
  const std::vector<CertificatePtr> authority = certificates_in(authority_pem);
  if (authority.empty())
    return refused("the authority's certificate in the server's key cannot be read",
                   "make the server's key again: telepalp-keys server");
  return read_token(token, *X509_get0_pubkey(authority.front().get()), now);
}

}  // namespace telepalp::keys
