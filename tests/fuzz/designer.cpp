// What the designer's page sends: any bytes are read as a command or refused with a sentence, and a linkage that is
// read has finite numbers.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tools/study/designer/command.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace telepalp::study;
  const auto read = parse_command({reinterpret_cast<const char*>(data), size});
  if (!read) {
    if (read.error().what.empty() || read.error().fix.empty()) std::abort();
    return 0;
  }
  if (const auto* const chosen = std::get_if<ChooseDesign>(&*read))
    if (!std::isfinite(chosen->design.bar.l1_m + chosen->design.bar.l2_m + chosen->design.bar.handle_rad)) std::abort();
  if (const auto* const hand = std::get_if<AimHand>(&*read))
    if (!hand->at_m.allFinite()) std::abort();
  return 0;
}
