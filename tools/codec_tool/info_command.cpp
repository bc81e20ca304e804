#include <cstdio>

#include "proto/wire/depth_loss.h"
#include "proto/wire/mcap/reader.h"
#include "tools/codec_tool/commands.h"
#include "tools/codec_tool/totals.h"

namespace telepalp::server {
namespace {

void print_line(std::size_t number, const codec::DepthPacketInfo& packet, std::size_t bytes,
                const wire::DepthFidelity& told) {
  const std::string place = packet.since_key == 0 ? "key" : "key+" + std::to_string(packet.since_key);
  std::printf("%6zu  %-8s %-10s %d x %d  unit %g mm  %d slices  %s  %zu B  ratio %.2f%s\n", number,
              std::string(codec::name(packet.mode)).c_str(), std::string(packet.coding).c_str(), packet.width,
              packet.height, 1000.0 * packet.unit_m, packet.slices, place.c_str(), bytes,
              2.0 * packet.width * packet.height / static_cast<double>(bytes),
              told.moved ? ("  " + wire::how_far(told)).c_str() : "");
}

}  // namespace

Result<void> describe_recording(const std::filesystem::path& input) {
  Result<wire::McapReader> reader = wire::McapReader::open(input);
  if (!reader) return reader.error();
  reader->select({.topics = {std::string(wire::kCameraDepth.name)}});
  Totals totals;
  while (true) {
    const Result<std::optional<wire::Message>> message = reader->next();
    if (!message) return message.error();
    if (!*message) break;
    msg::DepthImage image;
    if (!image.ParseFromString(*(*message)->payload))
      return Error{.what = "message " + std::to_string(totals.frames) + " is no DepthImage",
                   .where = input.string(),
                   .fix = "record it again"};
    const Result<codec::DepthPacketInfo> packet = codec::inspect_depth(std::as_bytes(std::span(image.data())));
    if (!packet) return packet.error();
    print_line(totals.frames, *packet, image.data().size(), wire::depth_fidelity(image));
    totals.add(1.0 * packet->width * packet->height, image.data().size());
  }
  if (totals.frames == 0) return Error{.what = "holds no depth", .where = input.string(), .fix = "give a session file"};
  totals.print();
  return {};
}

}  // namespace telepalp::server
