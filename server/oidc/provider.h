#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <string>

#include "proto/keys/identity.h"
#include "server/oidc/settings.h"
#include "server/oidc/token/claims.h"
#include "server/oidc/web/fetch.h"

namespace telepalp::oidc {

/// A person whom the provider has signed in.
struct Person {
  keys::Identity who;
  std::string subject;    ///< claim `sub`: the provider's number of the person
  std::string full_name;  ///< claim `name`; empty: not told
};

/// The person of checked claims. Error: no rule gives the person a role.
[[nodiscard]] Result<Person> person_of(const Claims& claims, const Settings& settings, keys::WallTime now);

/// The hospital's provider, asked by HTTP (OpenID Connect Core 1.0 and Discovery 1.0). Each call waits for the reply.
/// Owner: one thread. `stopped` may be set by another one.
class Provider {
 public:
  static constexpr std::chrono::hours kKnown{1};        ///< the provider's addresses are asked for again after this
  static constexpr std::chrono::seconds kUnreached{5};  ///< after a failure, it is not asked for its addresses again
  static constexpr std::chrono::minutes kKeysKept{1};   ///< new keys are not fetched more often

  explicit Provider(const Settings& settings) : settings_(settings) {}

  /// The page where people log in. Error: the provider is not reached, or names another issuer than the settings.
  [[nodiscard]] Result<std::string> log_in_address();
  /// The person for whom the provider gave `code` to the browser. Error: the provider is not reached, refuses the code,
  /// or sends a wrong ID token; or no rule gives the person a role.
  [[nodiscard]] Result<Person> person(const std::string& code, const std::string& verifier, const std::string& nonce);

  /// Ends a call that waits.
  void stop() noexcept { stopped_ = true; }

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] Result<Claims> ask(const WebRequest& request) const;
  [[nodiscard]] Result<void> discover();
  [[nodiscard]] Result<Claims> discovered() const;
  [[nodiscard]] WebRequest token_request(const std::string& code, const std::string& verifier) const;
  [[nodiscard]] Result<void> look_for_key(const std::string& token);
  [[nodiscard]] Result<void> add_user_info(const std::string& access_token, Claims& claims) const;

  const Settings& settings_;
  std::atomic<bool> stopped_ = false;
  Claims addresses_;  // of the provider; empty: unknown
  std::optional<Clock::time_point> discovered_;
  std::optional<Error> unreached_;  // of the last call of discover()
  Claims key_set_;
  std::optional<Clock::time_point> keys_fetched_;
};

}  // namespace telepalp::oidc
