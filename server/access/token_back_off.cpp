#include "server/access/token_back_off.h"

#include <algorithm>

namespace telepalp::access {
namespace {

constexpr unsigned kFree = 5;
constexpr std::size_t kMostAddresses = 1024;
constexpr std::chrono::seconds kLongest{60};

}  // namespace

bool TokenBackOff::may_try(const std::string& address, TimePoint now) const {
  const auto found = addresses_.find(address);
  return found == addresses_.end() || now >= found->second.until;
}

void TokenBackOff::failed(const std::string& address, TimePoint now) {
  if (addresses_.size() >= kMostAddresses && !addresses_.contains(address))
    addresses_.erase(std::min_element(addresses_.begin(), addresses_.end(),
                                      [](const auto& a, const auto& b) { return a.second.last < b.second.last; }));
  Failures& failures = addresses_[address];
  failures.last = now;
  if (++failures.count < kFree) return;
  const auto wait = std::chrono::seconds(1LL << std::min(failures.count - kFree, 6U));
  failures.until = now + std::min<std::chrono::seconds>(wait, kLongest);
}

}  // namespace telepalp::access
