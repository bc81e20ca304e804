#include "server/access/line_budget.h"

namespace telepalp::access {
namespace {

constexpr std::size_t kMostPeers = 1024;

}  // namespace

bool LineBudget::has(const std::string& serial, std::chrono::nanoseconds now) {
  if (budgets_.size() >= kMostPeers && !budgets_.contains(serial))
    std::erase_if(budgets_, [now](const auto& budget) {
      TokenBucket present = budget.second;  // refilled to now
      return present.has(0.0, now) && present.is_full();
    });
  return of(serial).has(1.0, now);
}

TokenBucket& LineBudget::of(const std::string& serial) {
  return budgets_.try_emplace(serial, kPerSecond, serial.empty() ? kStrangersBurst : kBurst).first->second;
}

}  // namespace telepalp::access
