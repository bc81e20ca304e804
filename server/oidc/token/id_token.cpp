#include "server/oidc/token/id_token.h"

#include <cjose/cjose.h>
#include <google/protobuf/util/json_util.h>

#include <memory>

namespace telepalp::oidc {
namespace {

using google::protobuf::Value;

constexpr std::size_t kLeastRsaBits = 2048;
constexpr std::size_t kMostRsaBits = 8192;
constexpr std::size_t kMostNameBytes = 255;  // of the claim sub (OpenID Connect Core 1.0, 2)

struct Release {
  void operator()(cjose_jws_t* token) const noexcept { cjose_jws_release(token); }
  void operator()(cjose_jwk_t* key) const noexcept { cjose_jwk_release(key); }
};
using Token = std::unique_ptr<cjose_jws_t, Release>;
using Key = std::unique_ptr<cjose_jwk_t, Release>;

Error refused(std::string what) {
  return {.what = "the provider's ID token " + std::move(what), .where = {}, .fix = "tell who runs the provider"};
}

Token import(const std::string& text) {
  cjose_err ignored{};
  if (text.size() > kMostTokenBytes) return nullptr;
  return Token(cjose_jws_import(text.data(), text.size(), &ignored));
}

std::string header(cjose_jws_t* token, const char* name) {
  cjose_err ignored{};
  const char* const text = cjose_header_get(cjose_jws_get_protected(token), name, &ignored);
  return text == nullptr ? "" : text;
}

/// Type of the keys that sign with `algorithm`; empty: the algorithm is not taken.
std::string key_type(const std::string& algorithm) {
  if (algorithm == "RS256" || algorithm == "PS256") return "RSA";
  return algorithm == "ES256" ? "EC" : "";
}

bool may_have_signed(const Claims& key, const std::string& algorithm, const std::string& id) {
  const auto is_or_is_left_out = [&](const char* name, const std::string& wanted) {
    return find(key, name) == nullptr || text_of(key, name) == wanted;
  };
  return !key_type(algorithm).empty() && text_of(key, "kty") == key_type(algorithm) &&
         (algorithm != "ES256" || text_of(key, "crv") == "P-256") && is_or_is_left_out("use", "sig") &&
         is_or_is_left_out("alg", algorithm) && (id.empty() || text_of(key, "kid") == id);
}

/// The key that may have signed `token`; null: there is none, or there are several and the token does not say which.
const Claims* key_of(cjose_jws_t* token, const Claims& key_set) {
  const Value* const keys = find(key_set, "keys");
  if (keys == nullptr || !keys->has_list_value()) return nullptr;
  const Claims* found = nullptr;
  for (const Value& key : keys->list_value().values()) {
    if (!key.has_struct_value()) continue;
    if (!may_have_signed(key.struct_value(), header(token, CJOSE_HDR_ALG), header(token, CJOSE_HDR_KID))) continue;
    if (found != nullptr) return nullptr;
    found = &key.struct_value();
  }
  return found;
}

Key import(const Claims& key) {
  std::string json;
  if (!google::protobuf::util::MessageToJsonString(key, &json).ok()) return nullptr;
  cjose_err ignored{};
  Key imported(cjose_jwk_import(json.data(), json.size(), &ignored));
  if (!imported || cjose_jwk_get_kty(imported.get(), &ignored) != CJOSE_JWK_KTY_RSA) return imported;
  const std::size_t bits = cjose_jwk_get_keysize(imported.get(), &ignored);
  return bits >= kLeastRsaBits && bits <= kMostRsaBits ? std::move(imported) : nullptr;
}

/// The claims of `text`. Error: it is no token that a key of `key_set` signed.
Result<Claims> signed_claims(const std::string& text, const Claims& key_set) {
  const Token token = import(text);
  if (!token) return refused("cannot be read, or is longer than 16 KiB");
  if (key_type(header(token.get(), CJOSE_HDR_ALG)).empty())
    return refused("is not signed with RS256, PS256 or ES256, as this server needs it");
  cjose_err ignored{};
  const std::unique_ptr<char, decltype(&std::free)> critical(
      cjose_header_get_raw(cjose_jws_get_protected(token.get()), "crit", &ignored), &std::free);
  if (critical) return refused("needs an extension that this server does not know");
  const Claims* const of_provider = key_of(token.get(), key_set);
  const Key key = of_provider == nullptr ? nullptr : import(*of_provider);
  if (!key) return refused("is signed with none of the provider's keys");
  if (!cjose_jws_verify(token.get(), key.get(), &ignored)) return refused("has a wrong signature");
  std::uint8_t* bytes = nullptr;  // of the token
  std::size_t size = 0;
  if (!cjose_jws_get_plaintext(token.get(), &bytes, &size, &ignored)) return refused("is empty");
  return read_claims({reinterpret_cast<const char*>(bytes), size}, "the provider's ID token");
}

Result<void> check_times(const Claims& claims, keys::WallTime now) {
  const double now_s = std::chrono::duration<double>(now.time_since_epoch()).count();
  const double error_s = std::chrono::duration<double>(kClockError).count();
  const std::optional<double> expires_s = number_of(claims, "exp");
  if (!expires_s || !(*expires_s > now_s - error_s)) return refused("has expired");
  for (const char* from : {"iat", "nbf"})
    if (const auto from_s = number_of(claims, from); from_s && !(*from_s <= now_s + error_s))
      return refused("is not valid yet: compare this computer's clock with the provider's");
  return {};
}

}  // namespace

bool has_key_of(const std::string& token, const Claims& key_set) {
  const Token imported = import(token);
  return imported && key_of(imported.get(), key_set) != nullptr;
}

Result<Claims> check_id_token(const std::string& token, const Claims& key_set, const Expected& expected) {
  Result<Claims> claims = signed_claims(token, key_set);
  if (!claims) return claims;
  if (text_of(*claims, "iss") != expected.issuer) return refused("is of another issuer");
  if (!states(*claims, "aud", expected.client_id)) return refused("is for another client");
  const Value* const audience = find(*claims, "aud");
  const bool has_others = audience->has_list_value() && audience->list_value().values_size() > 1;
  if ((has_others || find(*claims, "azp") != nullptr) && text_of(*claims, "azp") != expected.client_id)
    return refused("was made for another client");
  if (expected.nonce.empty() || text_of(*claims, "nonce") != expected.nonce) return refused("is of another log-in");
  if (const Result<void> timely = check_times(*claims, expected.now); !timely) return timely.error();
  const std::string who = text_of(*claims, "sub");
  if (who.empty() || who.size() > kMostNameBytes) return refused("names nobody");
  return claims;
}

}  // namespace telepalp::oidc
