#include "proto/keys/token.h"

#include <openssl/evp.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <vector>

#include "proto/keys/x509/openssl.h"

namespace telepalp::keys {
namespace {

constexpr std::string_view kPrefix = "tp2.";
constexpr std::string_view kBearerPrefix = "tp1.";
constexpr std::string_view kProved = "telepalp token proof 2\n";  // the exporter's bytes follow it
constexpr std::size_t kKeyBytes = 32;                             // of an Ed25519 key, public or secret
constexpr std::string_view kTokenBegins =
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
  const std::string message = std::string(kTokenBegins) + payload;
  return EVP_DigestVerifyInit(digest.get(), nullptr, EVP_sha256(), nullptr, &key) == 1 &&
         EVP_DigestVerify(digest.get(), bytes_of(signature), signature.size(), bytes_of(message), message.size()) == 1;
}

std::string payload_of(const Identity& bearer, const std::string& public_key) {
  return bearer.name + " " + std::string(name(bearer.role)) + " " +
         std::to_string(std::chrono::system_clock::to_time_t(bearer.expires)) + " " + bearer.serial + " " +
         to_base64(public_key);
}

struct Bearer {
  Identity who;
  std::string public_key;  // in Base64; empty in a bearer token
};

std::optional<Bearer> bearer_in(const std::string& payload) {
  std::istringstream words(payload);
  Bearer read;
  Identity& bearer = read.who;
  std::string role;
  std::time_t expires = 0;
  if (!(words >> bearer.name >> role >> expires >> bearer.serial)) return std::nullopt;
  const std::optional<Role> known = role_named(role);
  if (!known) return std::nullopt;
  bearer.role = *known;
  bearer.expires = std::chrono::system_clock::from_time_t(expires);
  words >> read.public_key;
  return read;
}

std::string public_key_of(EVP_PKEY& secret) {
  std::string key(kKeyBytes, '\0');
  std::size_t size = key.size();
  if (EVP_PKEY_get_raw_public_key(&secret, reinterpret_cast<unsigned char*>(key.data()), &size) != 1) return {};
  return key;
}

/// The secret that `text` writes in Base64; null: `text` is no secret.
PrivateKeyPtr token_secret_in(std::string_view text) {
  const std::optional<std::string> raw = from_base64(text);
  if (!raw || raw->size() != kKeyBytes) return nullptr;
  return PrivateKeyPtr(EVP_PKEY_new_raw_private_key(EVP_PKEY_ED25519, nullptr, bytes_of(*raw), raw->size()));
}

std::string proof_message(std::span<const std::byte> exporter) {
  return std::string(kProved) + std::string(reinterpret_cast<const char*>(exporter.data()), exporter.size());
}

bool is_proved(const std::string& public_key, const TokenProof& proof) {
  const std::optional<std::string> raw = from_base64(public_key);
  if (!raw || raw->size() != kKeyBytes || proof.exporter.empty()) return false;
  const PrivateKeyPtr key(EVP_PKEY_new_raw_public_key(EVP_PKEY_ED25519, nullptr, bytes_of(*raw), raw->size()));
  const DigestPtr digest(EVP_MD_CTX_new());
  const std::string message = proof_message(proof.exporter);
  return key && EVP_DigestVerifyInit(digest.get(), nullptr, nullptr, nullptr, key.get()) == 1 &&
         EVP_DigestVerify(digest.get(), bytes_of(proof.signature), proof.signature.size(), bytes_of(message),
                          message.size()) == 1;
}

/// The parts of a token's text; `secret` is empty if it has been left out.
struct Parts {
  std::string_view payload, signature, secret;
  bool is_bearer = false;
};

std::optional<Parts> parts_of(std::string_view token) {
  Parts parts;
  parts.is_bearer = token.starts_with(kBearerPrefix);
  if (token.size() > kMaxTokenBytes || (!parts.is_bearer && !token.starts_with(kPrefix))) return std::nullopt;
  token.remove_prefix(kPrefix.size());
  const std::size_t dot = token.find('.');
  if (dot == std::string_view::npos) return std::nullopt;
  parts.payload = token.substr(0, dot);
  parts.signature = token.substr(dot + 1);
  const std::size_t second = parts.signature.find('.');
  if (second == std::string_view::npos) return parts;
  if (parts.is_bearer) return std::nullopt;
  parts.secret = parts.signature.substr(second + 1);
  parts.signature = parts.signature.substr(0, second);
  return parts;
}

/// Whether the token of `bearer` came with its secret, or with a proof of it.
bool is_possessed(const Parts& parts, const Bearer& bearer, const TokenProof& proof) {
  if (parts.is_bearer) return bearer.public_key.empty();
  if (parts.secret.empty()) return is_proved(bearer.public_key, proof);
  const PrivateKeyPtr secret = token_secret_in(parts.secret);
  return secret && to_base64(public_key_of(*secret)) == bearer.public_key;
}

PrivateKeyPtr new_secret() { return PrivateKeyPtr(EVP_PKEY_Q_keygen(nullptr, nullptr, "ED25519")); }

Error token_refused(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "token", .fix = std::move(fix)};
}

}  // namespace

std::string random_secret() { return random_hexadecimal(kKeyBytes); }

Result<std::string> sign_token(const Identity& bearer, EVP_PKEY& authority_key) {
  const PrivateKeyPtr secret = new_secret();
  std::string raw(kKeyBytes, '\0');
  std::size_t raw_size = raw.size();
  if (!secret ||
      EVP_PKEY_get_raw_private_key(secret.get(), reinterpret_cast<unsigned char*>(raw.data()), &raw_size) != 1)
    return openssl_error("token");
  const std::string payload = payload_of(bearer, public_key_of(*secret));
  const std::string message = std::string(kTokenBegins) + payload;
  const DigestPtr digest(EVP_MD_CTX_new());
  std::string signature(160, '\0');
  std::size_t size = signature.size();
  if (EVP_DigestSignInit(digest.get(), nullptr, EVP_sha256(), nullptr, &authority_key) != 1 ||
      EVP_DigestSign(digest.get(), reinterpret_cast<unsigned char*>(signature.data()), &size, bytes_of(message),
                     message.size()) != 1)
    return openssl_error("token");
  signature.resize(size);
  return std::string(kPrefix) + to_base64(payload) + "." + to_base64(signature) + "." + to_base64(raw);
}

ProvedToken prove_token(std::string_view token, std::span<const std::byte> exporter) {
  const std::optional<Parts> parts = parts_of(token);
  const PrivateKeyPtr secret = parts ? token_secret_in(parts->secret) : nullptr;
  const DigestPtr digest(EVP_MD_CTX_new());
  const std::string message = proof_message(exporter);
  std::string signature(64, '\0');
  std::size_t size = signature.size();
  if (!secret || EVP_DigestSignInit(digest.get(), nullptr, nullptr, nullptr, secret.get()) != 1 ||
      EVP_DigestSign(digest.get(), reinterpret_cast<unsigned char*>(signature.data()), &size, bytes_of(message),
                     message.size()) != 1)
    return {.token = std::string(token), .proof = {}};
  return {.token = std::string(token.substr(0, token.rfind('.'))), .proof = signature};
}

Result<Identity> read_token(std::string_view token, EVP_PKEY& authority_key, WallTime now, const TokenProof& proof) {
  const Error no_token =
      token_refused("this is not a token of the server's authority",
                    "paste all that follows `token:` in a file that telepalp-keys token wrote, or ask the "
                    "technician for a new token");
  const std::optional<Parts> parts = parts_of(token);
  if (!parts) return no_token;
  const std::optional<std::string> payload = from_base64(parts->payload);
  const std::optional<std::string> signature = from_base64(parts->signature);
  if (!payload || !signature || !is_signed(*payload, *signature, authority_key)) return no_token;
  const std::optional<Bearer> bearer = bearer_in(*payload);
  if (!bearer || !is_possessed(*parts, *bearer, proof)) return no_token;
  if (bearer->who.expires <= now)
    return token_refused("the token of " + describe(bearer->who) + " has expired",
                         "ask the technician for a new one: telepalp-keys token");
  return bearer->who;
}

Result<Identity> read_token(std::string_view token, std::string_view authority_pem, WallTime now,
                            const TokenProof& proof) {
  const std::vector<CertificatePtr> authority = certificates_in(authority_pem);
  if (authority.empty())
    return token_refused("the authority's certificate in the server's key cannot be read",
                         "make the server's key again: telepalp-keys server");
  return read_token(token, *X509_get0_pubkey(authority.front().get()), now, proof);
}

}  // namespace telepalp::keys
