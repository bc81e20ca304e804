#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>

#include "server/access/token_bucket.h"

namespace telepalp::access {

/// Slows down guessing: after a wrong token came five times from an address, this token is refused unchecked for a
/// second there. The time doubles each further time, up to a minute. Other tokens of this address are still checked, so
/// that one person does not keep out the colleagues behind the same router (NAT). But when different wrong tokens come
/// from an address faster than kPerSecond, its tokens are refused unchecked, except those that were right there before.
/// Memory is bounded. Pure.
class TokenBackOff {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  static constexpr double kPerSecond = 20;  ///< different wrong tokens of one address
  static constexpr double kBurst = 100;

  /// `token`: the text that was sent, or a hash of it.
  [[nodiscard]] bool may_try(const std::string& address, const std::string& token, TimePoint now);
  void failed(const std::string& address, const std::string& token, TimePoint now);
  void succeeded(const std::string& address, const std::string& token, TimePoint now);
  [[nodiscard]] std::size_t entries() const noexcept { return tokens_.size() + addresses_.size(); }

 private:
  struct Tried {
    unsigned failures = 0;  // 0: the token was right
    TimePoint until{};
    TimePoint last{};
  };
  struct Address {
    TokenBucket wrong{kPerSecond, kBurst};
    TimePoint last{};
  };
  [[nodiscard]] Tried& tried(const std::string& address, const std::string& token, TimePoint now);

  // At most kMost each; the one that was used longest ago is forgotten.
  std::map<std::pair<std::string, std::string>, Tried> tokens_;  // by address and token
  std::map<std::string, Address> addresses_;
};

}  // namespace telepalp::access
