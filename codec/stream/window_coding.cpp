#include "codec/stream/window_coding.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "codec/context/context_coding.h"
#include "codec/fast/fast_coding.h"

namespace telepalp::codec {
namespace {

using Samples = std::vector<std::uint16_t>;

/// The reference frame of one of the two images. It has no palette: computing the palette takes time, and saves only a
/// few bytes.
FrameBefore before_of(const Samples& samples) {
  static const LevelPalette kNoLevels;
  return {.samples = samples, .palette = &kNoLevels};
}

/// Calls `copy(first sample in the image, first sample in the window)` for each row of the window.
template <class Copy>
void for_each_row(const PixelRect& exact, int image_width, Copy copy) {
  for (int row = 0; row < exact.height; ++row)
    copy(std::ptrdiff_t{exact.row + row} * image_width + exact.column, std::ptrdiff_t{row} * exact.width);
}

std::size_t pixels_of(const PixelRect& exact) noexcept {
  return static_cast<std::size_t>(exact.width) * static_cast<std::size_t>(exact.height);
}

/// The pixels of the window.
Samples cut_out(std::span<const std::uint16_t> image, int image_width, const PixelRect& exact) {
  if (image.empty()) return {};
  Samples cut(pixels_of(exact));
  for_each_row(exact, image_width, [&](std::ptrdiff_t in_image, std::ptrdiff_t in_window) {
    std::copy_n(image.begin() + in_image, exact.width, cut.begin() + in_window);
  });
  return cut;
}

void put_back(const Samples& cut, std::span<std::uint16_t> image, int image_width, const PixelRect& exact) {
  for_each_row(exact, image_width, [&](std::ptrdiff_t in_image, std::ptrdiff_t in_window) {
    std::copy_n(cut.begin() + in_window, exact.width, image.begin() + in_image);
  });
}

/// The image with its pixels in the window set to "not measured".
Samples without(std::span<const std::uint16_t> image, int image_width, const PixelRect& exact) {
  Samples outer(image.begin(), image.end());
  if (outer.empty()) return outer;
  for_each_row(exact, image_width, [&](std::ptrdiff_t in_image, std::ptrdiff_t) {
    std::fill_n(outer.begin() + in_image, exact.width, std::uint16_t{0});
  });
  return outer;
}

constexpr std::size_t kPixelsWorthFourSlices = 8192;

/// Four slices if the window has enough pixels. Fewer slices would not be faster for each pixel, because the coder
/// processes four in lockstep.
Slicing slicing_of(int width, int height) {
  const bool worth = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) >= kPixelsWorthFourSlices;
  const std::optional<Slicing> four = worth ? Slicing::declared(height, kLanes) : std::nullopt;
  return four.value_or(Slicing::for_frame(width, height));
}

/// Appends the window's part of the body.
void append_exact(std::string& body, const Samples& exact, int width, const Samples& before) {
  const Slicing slicing = slicing_of(width, static_cast<int>(exact.size()) / width);
  RankedFrame frame = ranked(palette_of(exact), exact);
  const std::optional<std::string> coded = encode_contexts(frame, width, before_of(before), slicing, context_kernel());
  const std::string_view raw(reinterpret_cast<const char*>(exact.data()), exact.size() * sizeof(std::uint16_t));
  append(body, static_cast<std::uint8_t>(coded ? slicing.slices : 0));
  append_varint(body, static_cast<std::uint32_t>(coded ? coded->size() : raw.size()));
  body.append(coded ? *coded : raw);
}

std::optional<Samples> read_exact(ByteReader& reader, const PacketHeader& header, const Samples& before) {
  const PixelRect& exact = header.window->exact;
  const std::optional<std::uint8_t> slices = reader.number<std::uint8_t>();
  const std::optional<std::uint32_t> size = slices ? reader.varint() : std::nullopt;
  const auto bytes = size ? reader.take(*size) : std::nullopt;
  if (!bytes) return std::nullopt;
  PacketHeader part = header;
  part.coding = *slices == 0 ? Coding::Stored : header.coding;
  part.slices = *slices;
  part.width = exact.width;
  part.height = exact.height;
  Samples samples(part.pixels());
  const bool done = *slices == 0
                        ? decode_fast({part, *bytes}, samples)
                        : decode_contexts({part, *bytes}, before_of(before), samples, context_kernel()).has_value();
  return done ? std::optional(std::move(samples)) : std::nullopt;
}

}  // namespace

CodedFrame code_window(const DepthImage& depth, DepthMode mode, const DepthWindow& window,
                       ReconstructionLevels& reconstruction, const Reference& reference) {
  const Slicing slicing = Slicing::for_frame(depth.width, depth.height);
  const PixelRect& exact = window.exact;
  const std::span<const std::uint16_t> before = samples_of(reference);

  DepthImage moved{.width = depth.width,
                   .height = depth.height,
                   .unit_m = depth.unit_m,
                   .samples = without(depth.samples, depth.width, exact)};
  RankedFrame outer = within_window(moved, palette_of(moved.samples), reconstruction, window);
  const Samples outer_before = without(before, depth.width, exact);
  const std::optional<std::string> outer_body =
      encode_contexts(outer, depth.width, before_of(outer_before), slicing, context_kernel());
  const auto raw = [&] { return CodedFrame{.packet = stored_packet(depth, mode, window), .depth = depth}; };
  if (!outer_body) return raw();

  const Samples inner = cut_out(depth.samples, depth.width, exact);
  std::string body;
  append_exact(body, inner, exact.width, cut_out(before, depth.width, exact));
  body.append(*outer_body);
  if (body.size() >= depth.samples.size() * sizeof(std::uint16_t)) return raw();
  put_levels(outer.ranks, outer.palette, moved.samples);
  put_back(inner, moved.samples, depth.width, exact);
  PacketHeader header = header_of(mode, depth, slicing, reference);
  header.window = window;
  WrittenPacket packet = write_packet(header, moved.samples, body);
  return {.packet = std::move(packet), .depth = std::move(moved)};
}

bool decode_window(const Packet& packet, std::span<const std::uint16_t> before, std::span<std::uint16_t> samples) {
  const PacketHeader& header = packet.header;
  const PixelRect& exact = header.window->exact;
  ByteReader reader(packet.body);
  const std::optional<Samples> inner = read_exact(reader, header, cut_out(before, header.width, exact));
  if (!inner) return false;
  const Samples outer_before = without(before, header.width, exact);
  if (!decode_contexts({header, reader.rest()}, before_of(outer_before), samples, context_kernel())) return false;
  put_back(*inner, samples, header.width, exact);
  return true;
}

}  // namespace telepalp::codec
