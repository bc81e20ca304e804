#include "proto/words/repeats/repeated_errors.h"

namespace telepalp {
namespace {

constexpr std::chrono::seconds kBetweenLines{5};
constexpr std::size_t kMostKinds = 16;  // an error may contain numbers, so that a damaged stream makes many kinds

}  // namespace

std::optional<std::string> RepeatedErrors::line(const std::string& happened, const Error& error, TimePoint now) {
  if (kinds_.size() >= kMostKinds && !kinds_.contains(error.what)) kinds_.clear();
  Kind& kind = kinds_[error.what];
  ++kind.count;
  if (kind.count > 1 && now < kind.next_line) return std::nullopt;
  kind.next_line = now + kBetweenLines;
  const std::string so_far = kind.count > 1 ? ", " + std::to_string(kind.count) + " so far for this reason: " : ": ";
  return happened + so_far + to_string(error);
}

}  // namespace telepalp
