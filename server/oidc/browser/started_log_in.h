#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace telepalp::oidc {

/// The secrets of one log-in.
struct LogIn {
  std::string state;      ///< comes back with the browser
  std::string nonce;      ///< comes back in the ID token
  std::string verifier;   ///< proves to the provider that the server which began the log-in ends it (PKCE, RFC 7636)
  std::string challenge;  ///< base64url(SHA-256(verifier))
  std::string page;       ///< where the browser goes in the end: "/?view=doctor"
};

/// Log-ins that have begun. The server keeps none of them, so nobody can begin too many: the browser's cookie has a
/// random secret, the time and an authentication code (MAC), and all of LogIn is derived from these and from a key of
/// this object. What has come back is remembered, so that it is taken once. Pure except for randomness. Owner: the
/// network thread.
class StartedLogIns {
 public:
  using TimePoint = std::chrono::system_clock::time_point;
  static constexpr std::chrono::seconds kLongest{600};  ///< from leaving for the provider until coming back
  /// The most ended log-ins that are remembered; beyond it, the oldest is forgotten. One address cannot end as many
  /// within kLongest, because TokenBackOff slows it down. Who ends a forgotten one again is refused by the provider,
  /// which takes each code once.
  static constexpr std::size_t kMost = 16'384;

  StartedLogIns();

  /// The cookie of a new log-in.
  [[nodiscard]] std::string begin(std::string_view page, TimePoint now) const;
  /// The log-in of a cookie. nullopt: begin() did not make the cookie, or it is older than kLongest.
  [[nodiscard]] std::optional<LogIn> read(std::string_view cookie, TimePoint now) const;
  /// The log-in of a cookie, if `state` is its own. A second call for the same log-in returns nullopt.
  [[nodiscard]] std::optional<LogIn> end(std::string_view cookie, std::string_view state, TimePoint now);

 private:
  [[nodiscard]] std::string mac(std::string_view label, std::string_view text) const;

  std::string key_;
  std::set<std::string> ended_;  // their states
  std::deque<std::string> order_;
};

}  // namespace telepalp::oidc
