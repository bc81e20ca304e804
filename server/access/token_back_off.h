#pragma once

#include <chrono>
#include <map>
#include <string>

namespace telepalp::access {

/// Slows down guessing: after five wrong tokens from an address, its tokens are refused unchecked for a second. The
/// time doubles with each further wrong token, up to a minute. A right token resets the count of its address. Memory is
/// bounded. Pure.
class TokenBackOff {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  [[nodiscard]] bool may_try(const std::string& address, TimePoint now) const;
  void failed(const std::string& address, TimePoint now);
  void succeeded(const std::string& address) { addresses_.erase(address); }
  [[nodiscard]] std::size_t addresses() const noexcept { return addresses_.size(); }

 private:
  struct Failures {
    unsigned count = 0;
    TimePoint until{};
    TimePoint last{};
  };
  std::map<std::string, Failures> addresses_;  // at most 1024; the one that failed longest ago is forgotten
};

}  // namespace telepalp::access
