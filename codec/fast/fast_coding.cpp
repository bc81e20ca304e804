#include "codec/fast/fast_coding.h"

#include <cstring>

#include "codec/bytes/zstd_stream.h"
#include "codec/fast/tokens.h"

namespace telepalp::codec {
namespace {

std::string_view raw(const DepthImage& depth) noexcept {
  return {reinterpret_cast<const char*>(depth.samples.data()), depth.samples.size() * sizeof(std::uint16_t)};
}

bool copy_raw(std::string_view from, std::span<std::uint16_t> samples) noexcept {
  if (from.size() != samples.size_bytes()) return false;
  std::memcpy(samples.data(), from.data(), from.size());
  return true;
}

std::string token_body(const DepthImage& depth, const LevelPalette& palette) {
  const TokenStreams streams = write_tokens(depth.samples, depth.width, palette);
  std::string levels;
  append_palette(levels, palette);
  std::string body;
  append_zstd_stream(body, levels, ZstdEffort::Entropy);
  append_zstd_stream(body, streams.extra, ZstdEffort::Entropy);
  append_zstd_stream(body, streams.entries, ZstdEffort::Entropy);
  for (const std::string& tokens : streams.tokens) append_zstd_stream(body, tokens, ZstdEffort::Entropy);
  return body;
}

bool decode_tokens(const Packet& packet, std::span<std::uint16_t> samples) {
  constexpr std::size_t kMostPaletteBytes = 3 + 3 * kMaxTokenLevels;
  const std::size_t pixels = packet.header.pixels();
  ByteReader reader(packet.body);
  const std::optional<std::string> levels = read_zstd_stream(reader, kMostPaletteBytes);
  if (!levels) return false;
  ByteReader level_reader(std::as_bytes(std::span(*levels)));
  const std::optional<LevelPalette> palette = read_palette(level_reader);
  if (!palette || palette->size() > kMaxTokenLevels || !level_reader.empty()) return false;
  TokenStreams streams;
  const auto read = [&](std::string& stream, std::size_t most_bytes) {
    std::optional<std::string> plain = read_zstd_stream(reader, most_bytes);
    if (!plain) return false;
    stream = std::move(*plain);
    return true;
  };
  if (!read(streams.extra, 4 * pixels) || !read(streams.entries, 3 * pixels)) return false;
  for (std::string& tokens : streams.tokens)
    if (!read(tokens, pixels)) return false;
  return reader.empty() && read_tokens(streams, *palette, packet.header.width, samples);
}

}  // namespace

Body stored(const DepthImage& depth) { return {Coding::Stored, std::string(raw(depth))}; }

Body encode_fast(const DepthImage& depth) {
  const LevelPalette palette = palette_of(depth.samples);
  Body body;
  if (palette.size() <= kMaxTokenLevels) {
    body = {Coding::Tokens, token_body(depth, palette)};
  } else {
    body.coding = Coding::Zstd;
    append_zstd_stream(body.bytes, raw(depth), ZstdEffort::Matches);
  }
  return body.bytes.size() < raw(depth).size() ? std::move(body) : stored(depth);
}

bool decode_fast(const Packet& packet, std::span<std::uint16_t> samples) {
  if (packet.header.coding == Coding::Tokens) return decode_tokens(packet, samples);
  if (packet.header.coding == Coding::Stored)
    return copy_raw({reinterpret_cast<const char*>(packet.body.data()), packet.body.size()}, samples);
  ByteReader reader(packet.body);
  const std::optional<std::string> plain = read_zstd_stream(reader, samples.size_bytes());
  return plain && reader.empty() && copy_raw(*plain, samples);
}

}  // namespace telepalp::codec
