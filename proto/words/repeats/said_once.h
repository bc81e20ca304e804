#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace telepalp {

/// Remembers which texts have been said, so that each is said once. A peer may have written a part of a text; so at
/// most kMost texts are remembered, and after them no further one is said.
class SaidOnce {
 public:
  static constexpr std::size_t kMost = 16;

  /// True if `text` is to be said now.
  [[nodiscard]] bool is_new(const std::string& text) { return said_.size() < kMost && said_.insert(text).second; }

 private:
  std::set<std::string> said_;
};

}  // namespace telepalp
