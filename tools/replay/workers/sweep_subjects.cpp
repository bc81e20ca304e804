#include "tools/replay/workers/sweep_subjects.h"

#include "tools/replay/source/content_digest.h"
#include "tools/replay/workers/cell_order.h"

namespace telepalp::replay {

std::string build_token(const std::string& build) {
  ContentDigest digest;
  digest.add(build);
  return digest.hex();
}

std::string order_subject(const std::string& build, const std::string& sweep, const std::string& cell) {
  return "telepalp-sweep.cell." + build_token(build) + "." + sweep + "." + cell;
}

std::string orders_of_build(const std::string& build) { return "telepalp-sweep.cell." + build_token(build) + ".>"; }

std::string answer_subject(const std::string& sweep, const std::string& cell) {
  return "telepalp-sweep.answer." + sweep + "." + cell;
}

std::optional<CellPlace> place_of(std::string_view subject) {
  constexpr std::size_t kDigits = 16;
  constexpr std::size_t kBoth = 2 * kDigits + 1;
  if (subject.size() < kBoth) return std::nullopt;
  const std::string_view both = subject.substr(subject.size() - kBoth);
  const std::string_view sweep = both.substr(0, kDigits);
  const std::string_view cell = both.substr(kDigits + 1);
  if (both[kDigits] != '.' || !is_digest(sweep, kDigits) || !is_digest(cell, kDigits)) return std::nullopt;
  return CellPlace{.sweep = std::string(sweep), .cell = std::string(cell)};
}

}  // namespace telepalp::replay
