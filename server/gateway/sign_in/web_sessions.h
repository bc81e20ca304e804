#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "proto/keys/identity.h"

namespace telepalp::gateway {

/// Browsers that signed in with a token. A browser keeps a random cookie; the server keeps the cookie's hash and the
/// person who signed in. A session ends after kLongest; beyond kMost, the oldest ends. Owner: the network thread.
class WebSessions {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  static constexpr std::size_t kMost = 256;
  static constexpr std::chrono::hours kLongest{12};

  /// Begins a session; returns the cookie's value.
  [[nodiscard]] std::string begin(const keys::Identity& who, TimePoint now);
  [[nodiscard]] std::optional<keys::Identity> find(std::string_view cookie, TimePoint now) const;
  /// Ends the session of `cookie`; returns the person who was signed in.
  std::optional<keys::Identity> end(std::string_view cookie);
  [[nodiscard]] std::size_t size() const noexcept { return sessions_.size(); }

 private:
  struct Session {
    keys::Identity who;
    TimePoint begun;
  };
  std::map<std::string, Session> sessions_;  // by the hash of the cookie
};

}  // namespace telepalp::gateway
