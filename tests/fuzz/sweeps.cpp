// Orders and answers as they come from a cluster of NATS servers. The first byte of the input chooses which.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "tools/replay/workers/cell_answer.h"
#include "tools/replay/workers/cell_order.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace telepalp::replay;
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 4) {
    case 0: {
      const OrderRules rules{.build = "b", .options = {"scene", "loss", "hand"}};
      const auto order = parse_order(bytes, rules);
      if (!order) break;
      if (order->recording && (order->recording->size_B > kMostRecording_B || order->recording->chunks() == 0))
        std::abort();
      if (!order->recording && !is_plain_synthetic(order->source)) std::abort();
      for (const std::string& word : command_of(*order, "local", "scene"))
        if (word.find('\0') != word.npos || word.find('\n') != word.npos) std::abort();
      if (axes_of(*order).empty()) std::abort();
      const auto again = parse_order(encode(*order), rules);
      if (!again || *again != *order) std::abort();
      break;
    }
    case 1:
      (void)names_a_file(std::string(bytes));
      break;
    case 2:
      (void)parse_answer(bytes, "b", "fedcba9876543210");
      break;
    default:
      (void)parse_presence(bytes);
  }
  return 0;
}
