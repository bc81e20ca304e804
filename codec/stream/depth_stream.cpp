#include "codec/depth_stream.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "codec/bounded/reconstruction.h"
#include "codec/levels/level_palette.h"
#include "codec/stream/frame_coding.h"
#include "codec/stream/packet_decoder.h"
#include "codec/stream/window_coding.h"
#include "proto/words/demand.h"

namespace telepalp::codec {
namespace {

bool same_size_and_unit(const DepthImage& a, const DepthImage& b) noexcept {
  return a.width == b.width && a.height == b.height && a.unit_m == b.unit_m;
}

}  // namespace

struct DepthEncoder::State {
  DepthStreamSettings settings;
  // Used in the mode Bounded, and around windows. They stay for a group of frames, because changing them costs bits.
  ReconstructionLevels reconstruction;
  int since_levels = 0;  // frames with a window since the levels were chosen; 0: no levels are chosen for windows
  CodedFrame previous;   // the last frame as the decoder has it
  int since_key = 0;
  bool key_frame_requested = true;

  [[nodiscard]] bool next_is_key(const DepthImage& depth);
  [[nodiscard]] CodedFrame code(const DepthImage& depth, bool is_key, const Reference& reference);
  [[nodiscard]] CodedFrame code_around(const DepthImage& depth, const DepthWindow& window, const Reference& reference);
};

DepthEncoder::DepthEncoder(const DepthStreamSettings& settings)
    : state_(std::make_unique<State>(State{.settings = settings,
                                           .reconstruction = {},
                                           .since_levels = 0,
                                           .previous = {},
                                           .since_key = 0,
                                           .key_frame_requested = true})) {}
DepthEncoder::~DepthEncoder() = default;
DepthEncoder::DepthEncoder(DepthEncoder&&) noexcept = default;
DepthEncoder& DepthEncoder::operator=(DepthEncoder&&) noexcept = default;

void DepthEncoder::request_key_frame() noexcept { state_->key_frame_requested = true; }

bool DepthEncoder::State::next_is_key(const DepthImage& depth) {
  constexpr int kMost = std::numeric_limits<std::uint16_t>::max();
  return std::exchange(key_frame_requested, false) || !same_size_and_unit(depth, previous.depth) ||
         since_key + 1 >= std::min(settings.key_every, kMost);
}

CodedFrame DepthEncoder::State::code(const DepthImage& depth, bool is_key, const Reference& reference) {
  if (settings.mode == DepthMode::Fast) return {.packet = write_frame(depth, settings.mode, {}), .depth = {}};
  LevelPalette palette = palette_of(depth.samples);
  if (settings.mode != DepthMode::Bounded) {
    WrittenPacket packet = write_lossless(depth, palette, settings.mode, reference);
    if (!is_predictive(settings.mode)) return {.packet = std::move(packet), .depth = {}};
    return {.packet = std::move(packet), .depth = depth, .palette = std::move(palette)};
  }
  if (is_key) reconstruction = reconstruction_levels_for(depth, palette, settings.bound);
  return code_bounded(depth, palette, reconstruction, reference);
}

/// Chooses levels for the whole image, so that they also suit a window at another place.
CodedFrame DepthEncoder::State::code_around(const DepthImage& depth, const DepthWindow& window,
                                            const Reference& reference) {
  const bool suits = since_levels > 0 && reconstruction.bound.bound == window.near &&
                     reconstruction.bound.unit_m == depth.unit_m && since_levels < settings.key_every;
  if (!suits) reconstruction = reconstruction_levels_for(depth, palette_of(depth.samples), window.near);
  since_levels = suits ? since_levels + 1 : 1;
  return code_window(depth, settings.mode, window, reconstruction, reference);
}

EncodedDepth DepthEncoder::encode(const DepthImage& depth, const std::optional<DepthWindow>& window) {
  demand(is_well_formed(depth), "DepthEncoder is given a well-formed image");
  State& state = *state_;
  const DepthMode mode = state.settings.mode;
  const bool has_window = window && (mode == DepthMode::Intra || mode == DepthMode::Temporal);
  if (has_window) demand(is_well_formed(*window, depth.width, depth.height), "a window lies within its image");
  EncodedDepth encoded{.bytes = {}, .key_frame = true, .mode = mode, .bound = std::nullopt, .crc = 0};
  if (mode == DepthMode::Bounded) encoded.bound = state.settings.bound;
  if (has_window) {
    encoded.window = window;
    encoded.bound = window->border;
  }
  const bool predictive = is_predictive(mode);
  const bool is_key = !predictive || state.next_is_key(depth);
  state.since_key = is_key ? 0 : state.since_key + 1;
  const Reference reference{.depth = is_key ? nullptr : &state.previous.depth,
                            .palette = is_key || !state.previous.palette ? nullptr : &*state.previous.palette,
                            .crc = state.previous.packet.crc,
                            .since_key = static_cast<std::uint16_t>(state.since_key)};
  CodedFrame coded = has_window ? state.code_around(depth, *window, reference) : state.code(depth, is_key, reference);
  encoded.bytes = std::move(coded.packet.bytes);
  encoded.crc = coded.packet.crc;
  encoded.key_frame = coded.packet.key_frame;
  if (predictive) state.previous = std::move(coded);
  return encoded;
}

struct DepthDecoder::State {
  PacketDecoder decoder;
};

DepthDecoder::DepthDecoder() : state_(std::make_unique<State>()) {}
DepthDecoder::~DepthDecoder() = default;
DepthDecoder::DepthDecoder(DepthDecoder&&) noexcept = default;
DepthDecoder& DepthDecoder::operator=(DepthDecoder&&) noexcept = default;

Result<DepthImage> DepthDecoder::decode(std::span<const std::byte> bytes) {
  const Result<Packet> packet = read_packet(bytes);
  return packet ? state_->decoder.decode(*packet) : packet.error();
}

}  // namespace telepalp::codec
