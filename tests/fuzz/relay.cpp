// Parts of messages as they come from a cluster of NATS servers, which an edge joins. Each part of the input begins
// with its length (2 bytes, little-endian), whose highest bit chooses the topic.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "server/relay/relay_frames.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace telepalp;
  relay::PartJoiner joiner;
  std::string_view input(reinterpret_cast<const char*>(data), size);
  while (input.size() >= 2) {
    const auto low = static_cast<unsigned char>(input[0]);
    const auto high = static_cast<unsigned char>(input[1]);
    input.remove_prefix(2);
    const std::string_view part = input.substr(0, (high & 0x7f) * 256U + low);
    input.remove_prefix(part.size());
    const wire::Topic& topic = (high & 0x80) != 0 ? wire::kCameraDepth : wire::kStationState;
    const auto message = joiner.add(topic, part);
    if (!message) continue;
    if (message->sequence == 0 || message->payload->size() > wire::kMaxPayloadBytes) std::abort();
    if (!topic.predicted && !message->key_frame) std::abort();
  }
  return 0;
}
