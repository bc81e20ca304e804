#include "codec/context/context_coding.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include "codec/entropy/palette_coding.h"
#include "codec/model/depth_tables.h"
#include "proto/words/demand.h"

namespace telepalp::codec {
namespace {

constexpr int kPixelsWorthASlice = 16384;
constexpr int kPixelsOfFourSlices = 1 << 20;  // larger images have four slices for each so many pixels
constexpr int kMostSlices = 64;

struct Free {
  void operator()(void* bytes) const noexcept { std::free(bytes); }
};
using Scratch = std::unique_ptr<void, Free>;

Scratch scratch_for(int width, const ContextTables& tables) {
  constexpr std::size_t kAlignment = 64;
  const std::size_t bytes = scratch_bytes(width, tables);
  Scratch scratch(std::aligned_alloc(kAlignment, (bytes + kAlignment - 1) / kAlignment * kAlignment));
  demand(scratch != nullptr, "there is enough memory for the coder's models and rows");
  return scratch;
}

std::size_t first_pixel(const Slicing& slicing, int slice, int width) noexcept {
  return static_cast<std::size_t>(slice) * static_cast<std::size_t>(slicing.rows) * static_cast<std::size_t>(width);
}

/// The ranks of one slice; nullptr when `ranks` is empty.
const std::uint16_t* band(const Ranks& ranks, const Slicing& slicing, int slice, int width) noexcept {
  return ranks.empty() ? nullptr : ranks.data() + first_pixel(slicing, slice, width);
}

const ContextTables& tables_for(const FrameBefore& before) {
  return before.samples.empty() ? depth_tables() : dependent_depth_tables();
}

LevelPalette palette_before(const FrameBefore& before) {
  return before.palette != nullptr ? *before.palette : palette_of(before.samples);
}

Ranks ranks_of_before(const FrameBefore& before, const LevelPalette& palette) {
  return before.samples.empty() ? Ranks{} : ranks_by(nearest_ranks_of(palette), before.samples);
}

}  // namespace

const ContextKernel& context_kernel() {
  static const ContextKernel& best = v3_context_kernel() != nullptr ? *v3_context_kernel() : portable_context_kernel();
  return best;
}

Slicing Slicing::for_frame(int width, int height) noexcept {
  const int pixels = width * height;
  const int wanted = pixels > kPixelsOfFourSlices ? pixels / (kPixelsOfFourSlices / 4) : pixels / kPixelsWorthASlice;
  const int slices = std::clamp(std::min(wanted, pixels > kPixelsOfFourSlices ? kMostSlices : kLanes), 1, height);
  const int rows = (height + slices - 1) / slices;
  return {.slices = (height + rows - 1) / rows, .rows = rows};
}

std::optional<Slicing> Slicing::declared(int height, int slices) noexcept {
  if (slices < 1 || slices > std::min(height, kMostSlices)) return std::nullopt;
  const int rows = (height + slices - 1) / slices;
  if ((slices - 1) * rows >= height) return std::nullopt;
  return Slicing{.slices = slices, .rows = rows};
}

int Slicing::rows_of(int slice, int height) const noexcept {
  return slice + 1 < slices ? rows : height - (slices - 1) * rows;
}

void put_levels(const Ranks& ranks, const LevelPalette& palette, std::span<std::uint16_t> samples) {
  std::vector<std::uint16_t> levels(std::size_t{1} << 16);
  std::copy(palette.levels.begin(), palette.levels.end(), levels.begin());
  for (std::size_t i = 0; i < ranks.size(); ++i) samples[i] = levels[ranks[i]];
}

std::optional<std::string> encode_contexts(RankedFrame& frame, int width, const FrameBefore& before,
                                           const Slicing& slicing, const ContextKernel& kernel) {
  Ranks& ranks = frame.ranks;
  const int height = static_cast<int>(ranks.size()) / width;
  const ContextTables& tables = tables_for(before);
  const Ranks ranks_before = ranks_of_before(before, frame.palette);
  const Scratch scratch = scratch_for(width, tables);
  const std::size_t raw_bytes = ranks.size() * sizeof(std::uint16_t);
  const std::size_t room = raw_bytes / static_cast<std::size_t>(slicing.slices) + 64;
  const std::unique_ptr<std::uint8_t[]> bytes(new std::uint8_t[kLanes * room]);
  std::string body;
  append_coded_palette(body, frame.palette, palette_before(before));
  for (int first = 0; first < slicing.slices; first += kLanes) {
    std::array<EncodeSlice, kLanes> slices{};
    const int count = std::min(kLanes, slicing.slices - first);
    for (int i = 0; i < count; ++i)
      slices[static_cast<std::size_t>(i)] = {.ranks = ranks.data() + first_pixel(slicing, first + i, width),
                                             .most = band(frame.most, slicing, first + i, width),
                                             .before = band(ranks_before, slicing, first + i, width),
                                             .rows = slicing.rows_of(first + i, height),
                                             .bytes = bytes.get() + static_cast<std::size_t>(i) * room,
                                             .room = room};
    kernel.encode(slices.data(), count, width, tables, scratch.get());
    for (int i = 0; i < count; ++i) {
      const EncodeSlice& slice = slices[static_cast<std::size_t>(i)];
      if (slice.size == 0) return std::nullopt;
      append_varint(body, static_cast<std::uint32_t>(slice.size));
      body.append(reinterpret_cast<const char*>(slice.bytes), slice.size);
    }
  }
  if (body.size() >= raw_bytes) return std::nullopt;
  return body;
}

std::optional<LevelPalette> decode_contexts(const Packet& packet, const FrameBefore& before,
                                            std::span<std::uint16_t> samples, const ContextKernel& kernel) {
  const PacketHeader& header = packet.header;
  const std::optional<Slicing> slicing = Slicing::declared(header.height, header.slices);
  ByteReader reader(packet.body);
  std::optional<LevelPalette> palette = slicing ? read_coded_palette(reader, palette_before(before)) : std::nullopt;
  if (!palette) return std::nullopt;
  const ContextTables& tables = tables_for(before);
  const Ranks ranks_before = ranks_of_before(before, *palette);
  const Scratch scratch = scratch_for(header.width, tables);
  Ranks ranks(header.pixels());
  for (int first = 0; first < slicing->slices; first += kLanes) {
    std::array<DecodeSlice, kLanes> slices{};
    const int count = std::min(kLanes, slicing->slices - first);
    for (int i = 0; i < count; ++i) {
      const std::optional<std::uint32_t> size = reader.varint();
      const auto bytes = size ? reader.take(*size) : std::nullopt;
      if (!bytes) return std::nullopt;
      slices[static_cast<std::size_t>(i)] = {.bytes = reinterpret_cast<const std::uint8_t*>(bytes->data()),
                                             .size = bytes->size(),
                                             .ranks = ranks.data() + first_pixel(*slicing, first + i, header.width),
                                             .before = band(ranks_before, *slicing, first + i, header.width),
                                             .rows = slicing->rows_of(first + i, header.height)};
    }
    kernel.decode(slices.data(), count, header.width, tables, scratch.get());
  }
  if (!reader.empty()) return std::nullopt;
  put_levels(ranks, *palette, samples);
  return palette;
}

}  // namespace telepalp::codec
