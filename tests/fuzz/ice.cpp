// The candidates that the other end of a connection sends: a candidate that is read leads to a permitted address, and
// is read again as it is written.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "proto/ice/words/candidate.h"

namespace {

void must(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace telepalp::ice;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const Reach reach : {Reach::Network, Reach::Loopback}) {
    const auto candidate = read_candidate(text, reach);
    if (!candidate) continue;
    must(may_check(candidate->address, reach) && candidate->port != 0 && size <= kMostCandidateBytes);
    const auto again = read_candidate(to_text(*candidate), reach);
    must(again && again->address == candidate->address && again->port == candidate->port &&
         again->kind == candidate->kind && again->priority == candidate->priority);
  }
  (void)is_credential(text, 4);
  return 0;
}
