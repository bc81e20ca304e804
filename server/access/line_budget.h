#pragma once

#include <chrono>
#include <map>
#include <string>

#include "server/access/token_bucket.h"

namespace telepalp::access {

/// Limits how many lines each peer may cause in the audit log, so that nobody can fill the disk: one key causes at most
/// kBurst lines at once, and then one each 4 s (21 600 lines, about 8 MB, a day). All strangers (peers that no key or
/// token names) together cause at most kStrangersBurst at once, and then one each 4 s, too. Pure.
class LineBudget {
 public:
  static constexpr double kBurst = 200;
  static constexpr double kStrangersBurst = 20;
  static constexpr double kPerSecond = 0.25;

  /// True if the peer of the key `serial` may cause a line now. Empty `serial`: a stranger. `now`: since any origin.
  [[nodiscard]] bool has(const std::string& serial, std::chrono::nanoseconds now);
  /// Takes one line from the peer's budget, also from an empty one.
  void spend(const std::string& serial) { of(serial).spend(1.0); }

 private:
  TokenBucket& of(const std::string& serial);
  std::map<std::string, TokenBucket> budgets_;  // by serial
};

}  // namespace telepalp::access
