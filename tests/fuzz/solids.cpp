// Solids in Polish notation, from a person: any text is read or refused, and a solid that is read survives being
// written, built and evaluated.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "haptic_station/solids/polish.h"
#include "haptic_station/solids/solid_tree.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace telepalp::solids;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto solid = parse_polish(text, "fuzz");
  if (!solid) return 0;
  const auto again = parse_polish(to_polish(*solid), "again");
  if (!again || *again != *solid) std::abort();
  const auto tree = build_tree(*solid);
  if (!tree) std::abort();
  for (const double at : {0.0, 0.01, -3.0}) {
    const SolidAt value = solid_at(**tree, {at, 0.5 * at, -at});
    if (value.m != value.m || !value.gradient.allFinite()) std::abort();
  }
  return 0;
}
