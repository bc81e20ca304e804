#include "server/oidc/provider.h"

#include <algorithm>

#include "proto/keys/audit_chain.h"
#include "server/oidc/token/id_token.h"
#include "server/oidc/web/web_address.h"

namespace telepalp::oidc {
namespace {

constexpr std::size_t kSerialDigits = 40;  // a certificate's serial number has as many
constexpr std::size_t kLongestName = 57;   // with a hyphen and six digits it is as long as that of a key
constexpr long kOk = 200;

/// `name` with no letters but those that a key's name may have. If it had to be changed, digits of `serial` follow, so
/// that two people do not get one name.
std::string plain_name(const std::string& name, const std::string& serial) {
  constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._@-";
  std::string plain = name.substr(0, kLongestName);
  for (std::size_t at = 0; (at = plain.find_first_not_of(kPlain, at)) != std::string::npos;) plain[at] = '_';
  if (plain == name && !name.empty()) return plain;
  return (plain.empty() ? "person" : plain) + "-" + serial.substr(0, 6);
}

std::string in_form(const char* name, const std::string& value) {
  return std::string(name) + "=" + percent_encoded(value);
}

}  // namespace

Result<Person> person_of(const Claims& claims, const Settings& settings, keys::WallTime now) {
  const std::string subject = text_of(claims, "sub");
  const auto fits = [&](const Rule& one) { return states(claims, one.claim, one.value); };
  const auto rule = std::ranges::find_if(settings.rules, fits);
  const std::string serial = keys::sha256_hex(settings.issuer + '\n' + subject).substr(0, kSerialDigits);
  const std::string name = plain_name(text_of(claims, settings.name_claim), serial);
  if (rule == settings.rules.end())
    return Error{.what = "your hospital's account (" + name + ") has no role here",
                 .where = {},
                 .fix = "ask the technician which group may enter, and your hospital to take you into it"};
  return Person{.who = {.name = name, .role = rule->role, .serial = serial, .expires = now + settings.longest},
                .subject = subject,
                .full_name = text_of(claims, "name")};
}

Result<Claims> Provider::ask(const WebRequest& request) const {
  const Result<WebReply> reply = fetch(request, settings_.authority_file, stopped_);
  if (!reply) return reply.error();
  if (reply->status == kOk) return read_claims(reply->body, request.address);
  const Result<Claims> why = read_claims(reply->body, request.address);
  const std::string code = why ? text_of(*why, "error") : "";
  return Error{
      .what = "the provider answers " + std::to_string(reply->status) + (code.empty() ? "" : " (" + code + ")"),
      .where = request.address,
      .fix = "compare client_id, the client's secret and the registered address " + settings_.back() +
             " with the provider's settings"};
}

/// What the provider publishes about itself. Error: it is not reached, or lacks what a log-in needs.
Result<Claims> Provider::discovered() const {
  std::string address = settings_.issuer;
  while (address.ends_with('/')) address.pop_back();
  address += "/.well-known/openid-configuration";
  Result<Claims> found = ask({.address = address});
  if (!found) return found;
  if (text_of(*found, "issuer") != settings_.issuer)
    return Error{.what = "the provider calls itself '" + text_of(*found, "issuer").substr(0, 200) + "'",
                 .where = address,
                 .fix = "give the issuer exactly as the provider writes it"};
  for (const char* name : {"authorization_endpoint", "token_endpoint", "jwks_uri"})
    if (!is_safe_address(text_of(*found, name)))
      return Error{.what = std::string("the provider's ") + name + " is not an address that begins with https://",
                   .where = address,
                   .fix = "tell who runs the provider"};
  return found;
}

Result<void> Provider::discover() {
  const auto now = Clock::now();
  if (discovered_ && now - *discovered_ < (unreached_ ? Clock::duration(kUnreached) : Clock::duration(kKnown)))
    return unreached_ ? Result<void>(*unreached_) : Result<void>();
  Result<Claims> found = discovered();
  discovered_ = Clock::now();
  unreached_ = found ? std::nullopt : std::optional(found.error());
  if (!found) return found.error();
  addresses_ = std::move(found).value();
  return {};
}

Result<std::string> Provider::log_in_address() {
  if (const Result<void> known = discover(); !known) return known.error();
  return text_of(addresses_, "authorization_endpoint");
}

WebRequest Provider::token_request(const std::string& code, const std::string& verifier) const {
  constexpr const char* kMethods = "token_endpoint_auth_methods_supported";
  WebRequest request{.address = text_of(addresses_, "token_endpoint")};
  // `code` is as it came in the query: encoded already
  request.form = "grant_type=authorization_code&code=" + code + "&" + in_form("redirect_uri", settings_.back()) + "&" +
                 in_form("code_verifier", verifier);
  const bool takes_basic = find(addresses_, kMethods) == nullptr || states(addresses_, kMethods, "client_secret_basic");
  if (settings_.client_secret.empty() || !takes_basic) request.form += "&" + in_form("client_id", settings_.client_id);
  if (settings_.client_secret.empty()) return request;
  if (!takes_basic) {
    request.form += "&" + in_form("client_secret", settings_.client_secret);
    return request;
  }
  request.user = percent_encoded(settings_.client_id);  // RFC 6749, 2.3.1
  request.password = percent_encoded(settings_.client_secret);
  return request;
}

/// Fetches the provider's keys if none of the known ones may have signed `token`.
Result<void> Provider::look_for_key(const std::string& token) {
  const auto now = Clock::now();
  if (has_key_of(token, key_set_) || (keys_fetched_ && now - *keys_fetched_ < kKeysKept)) return {};
  keys_fetched_ = now;
  Result<Claims> fetched = ask({.address = text_of(addresses_, "jwks_uri")});
  if (!fetched) return fetched.error();
  key_set_ = std::move(fetched).value();
  return {};
}

/// Adds the claims that the provider tells at its userinfo address alone. Where the ID token states one, too, that
/// stays.
Result<void> Provider::add_user_info(const std::string& access_token, Claims& claims) const {
  const std::string address = text_of(addresses_, "userinfo_endpoint");
  if (access_token.empty() || !is_safe_address(address)) return {};
  const Result<Claims> told = ask({.address = address, .bearer = access_token});
  if (!told) return told.error();
  if (text_of(*told, "sub") != text_of(claims, "sub"))
    return Error{.what = "the provider tells of another person", .where = address, .fix = "tell who runs the provider"};
  claims.mutable_fields()->insert(told->fields().begin(), told->fields().end());
  return {};
}

Result<Person> Provider::person(const std::string& code, const std::string& verifier, const std::string& nonce) {
  if (const Result<void> known = discover(); !known) return known.error();
  const Result<Claims> tokens = ask(token_request(code, verifier));
  if (!tokens) return tokens.error();
  const std::string token = text_of(*tokens, "id_token");
  if (const Result<void> known = look_for_key(token); !known) return known.error();
  const auto now = std::chrono::system_clock::now();
  Result<Claims> claims = check_id_token(token, key_set_, {settings_.issuer, settings_.client_id, nonce, now});
  if (!claims) return claims.error();
  if (const Result<void> told = add_user_info(text_of(*tokens, "access_token"), *claims); !told) return told.error();
  return person_of(*claims, settings_, now);
}

}  // namespace telepalp::oidc
