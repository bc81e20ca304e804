// What the protocol's page sends: any bytes are read as a command or refused with a sentence, and a motion that is read
// is finite.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tools/study/protocol/page_command.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace telepalp::study;
  const auto read = parse_page_command({reinterpret_cast<const char*>(data), size});
  if (!read) {
    if (read.error().what.empty() || read.error().fix.empty()) std::abort();
    return 0;
  }
  if (const auto* const push = std::get_if<PushHand>(&*read))
    if (!std::isfinite(push->by_m)) std::abort();
  if (const auto* const move = std::get_if<MoveHand>(&*read))
    if (!move->by_m.allFinite()) std::abort();
  return 0;
}
