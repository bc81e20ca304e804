#include <cstdio>

#include "proto/wire/depth_loss.h"
#include "proto/wire/mcap/reader.h"
#include "support/program/json.h"
#include "tools/codec_tool/commands.h"
#include "tools/codec_tool/totals.h"

namespace telepalp::codec_tool {
namespace {

void print_line(std::size_t number, const codec::DepthPacketInfo& packet, std::size_t bytes,
                const wire::DepthFidelity& fidelity) {
  const std::string place =
      packet.since_key == 0 ? "key frame" : "frames since key frame: " + std::to_string(packet.since_key);
  std::printf(
      "frame %6zu  mode %-8s  coding %-10s %d x %d pixels  depth unit %g mm  slices %d  %s  %zu B  compression ratio "
      "%.2f%s\n",
      number, std::string(codec::name(packet.mode)).c_str(), std::string(packet.coding).c_str(), packet.width,
      packet.height, 1000.0 * packet.unit_m, packet.slices, place.c_str(), bytes,
      2.0 * packet.width * packet.height / static_cast<double>(bytes),
      fidelity.moved ? ("  " + wire::how_far(fidelity)).c_str() : "");
}

void add_frame(program::Json& json, const codec::DepthPacketInfo& packet, std::size_t bytes,
               const wire::DepthFidelity& fidelity) {
  json.begin_object();
  json.add("mode", codec::name(packet.mode));
  json.add("coding", packet.coding);
  json.add("width", static_cast<std::uint64_t>(packet.width));
  json.add("height", static_cast<std::uint64_t>(packet.height));
  json.add("unit_mm", 1000.0 * packet.unit_m);
  json.add("slices", static_cast<std::uint64_t>(packet.slices));
  json.add("since_key", static_cast<std::uint64_t>(packet.since_key));
  json.add("bytes", static_cast<std::uint64_t>(bytes));
  fidelity.moved ? json.add("moved", wire::how_far(fidelity)) : json.add_null("moved");
  json.end_object();
}

/// Calls `visit` with each depth image of `input`, in order.
template <class Visit>
Result<Totals> for_each_packet(const std::filesystem::path& input, Visit visit) {
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
      return Error{.what = "message " + std::to_string(totals.frames) +
                           " of /camera/depth, counted from 0, is not a depth image",
                   .where = input.string(),
                   .fix = "check the session: telepalp-record verify " + input.string()};
    const Result<codec::DepthPacketInfo> packet = codec::inspect_depth(std::as_bytes(std::span(image.data())));
    if (!packet)
      return Error{.what = "depth image " + std::to_string(totals.frames) +
                           ", counted from 0, cannot be read: " + packet.error().what,
                   .where = input.string(),
                   .fix = "check the session: telepalp-record verify " + input.string()};
    visit(totals.frames, *packet, image.data().size(), wire::depth_fidelity(image));
    totals.add(1.0 * packet->width * packet->height, image.data().size());
  }
  if (totals.frames == 0)
    return Error{.what = "holds no depth image",
                 .where = input.string(),
                 .fix = "give a session in which /camera/depth was recorded"};
  return totals;
}

Result<void> describe_in_words(const std::filesystem::path& input) {
  const Result<Totals> totals = for_each_packet(input, print_line);
  if (!totals) return totals.error();
  totals->print();
  return {};
}

/// Prints only if all images could be read, because a truncated JSON text is useless.
Result<void> describe_in_json(const std::filesystem::path& input) {
  program::Json json;
  json.begin_object();
  json.begin_list("frames");
  const Result<Totals> totals = for_each_packet(
      input, [&json](std::size_t, const codec::DepthPacketInfo& packet, std::size_t bytes,
                     const wire::DepthFidelity& fidelity) { add_frame(json, packet, bytes, fidelity); });
  if (!totals) return totals.error();
  json.end_list();
  json.begin_object("total");
  json.add("frames", static_cast<std::uint64_t>(totals->frames));
  json.add("sample_bytes", static_cast<std::uint64_t>(2.0 * totals->pixels));
  json.add("packet_bytes", static_cast<std::uint64_t>(totals->bytes));
  json.add("ratio", 2.0 * totals->pixels / totals->bytes);
  json.end_object();
  json.end_object();
  std::fputs(std::move(json).finish().c_str(), stdout);
  return {};
}

}  // namespace

Result<void> describe_recording(const std::filesystem::path& input, bool json) {
  return json ? describe_in_json(input) : describe_in_words(input);
}

}  // namespace telepalp::codec_tool
