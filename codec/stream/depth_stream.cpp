#include "codec/depth_stream.h"

#include <algorithm>
#include <cmath>
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

/// Of so many frames of Temporal that may be predicted, at least one is also coded alone.
constexpr int kCompareEvery = 8;
/// While the two codings differ by a smaller share, each frame is coded both ways.
constexpr double kUndecided = 0.01;

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
  int compared_every = 1;       // of the frames that may be predicted
  int until_compared = 0;       // frames that may be predicted until both codings are compared again
  bool prediction_pays = true;  // the last comparison found the predicted frame smaller

  [[nodiscard]] bool next_is_key(const DepthImage& depth);
  [[nodiscard]] Reference reference() const noexcept;
  [[nodiscard]] CodedFrame code(const DepthImage& depth, const std::optional<DepthWindow>& window, bool is_key);
  [[nodiscard]] CodedFrame code_smaller(const DepthImage& depth, const std::optional<DepthWindow>& window);
  [[nodiscard]] CodedFrame code_whole(const DepthImage& depth, const Reference& reference);
  [[nodiscard]] CodedFrame code_around(const DepthImage& depth, const DepthWindow& window, const Reference& reference);
};

DepthEncoder::DepthEncoder(const DepthStreamSettings& settings)
    : state_(std::make_unique<State>(State{.settings = settings,
                                           .reconstruction = {},
                                           .since_levels = 0,
                                           .previous = {},
                                           .since_key = 0,
                                           .key_frame_requested = true,
                                           .compared_every = 1,
                                           .until_compared = 0,
                                           .prediction_pays = true})) {}
DepthEncoder::~DepthEncoder() = default;
DepthEncoder::DepthEncoder(DepthEncoder&&) noexcept = default;
DepthEncoder& DepthEncoder::operator=(DepthEncoder&&) noexcept = default;

void DepthEncoder::request_key_frame() noexcept { state_->key_frame_requested = true; }

bool DepthEncoder::State::next_is_key(const DepthImage& depth) {
  constexpr int kMost = std::numeric_limits<std::uint16_t>::max();
  return std::exchange(key_frame_requested, false) || !same_size_and_unit(depth, previous.depth) ||
         since_key + 1 >= std::min(settings.key_every, kMost);
}

/// The frame before, as the reference of the next one.
Reference DepthEncoder::State::reference() const noexcept {
  return {.depth = &previous.depth,
          .palette = previous.palette ? &*previous.palette : nullptr,
          .crc = previous.packet.crc,
          .since_key = static_cast<std::uint16_t>(since_key + 1)};
}

CodedFrame DepthEncoder::State::code(const DepthImage& depth, const std::optional<DepthWindow>& window, bool is_key) {
  const Reference from = is_key ? Reference{} : reference();
  return window ? code_around(depth, *window, from) : code_whole(depth, from);
}

/// Of some cameras, most of all noisy ones, the frame before predicts less well than the neighbouring pixels. Then the
/// frames are coded alone, and are key frames. The longer the comparisons agree, the rarer they become.
CodedFrame DepthEncoder::State::code_smaller(const DepthImage& depth, const std::optional<DepthWindow>& window) {
  if (until_compared > 0) {
    --until_compared;
    return code(depth, window, !prediction_pays);
  }
  CodedFrame predicted = code(depth, window, false);
  CodedFrame alone = code(depth, window, true);
  const auto [predicted_B, alone_B] = std::pair{predicted.packet.bytes.size(), alone.packet.bytes.size()};
  const bool pays = predicted_B < alone_B;
  const double apart = std::abs(static_cast<double>(predicted_B) / static_cast<double>(alone_B) - 1.0);
  const bool decided = apart >= kUndecided && pays == std::exchange(prediction_pays, pays);
  compared_every = decided ? std::min(2 * compared_every, kCompareEvery) : 1;
  until_compared = compared_every - 1;
  return prediction_pays ? std::move(predicted) : std::move(alone);
}

CodedFrame DepthEncoder::State::code_whole(const DepthImage& depth, const Reference& reference) {
  if (settings.mode == DepthMode::Fast) return {.packet = write_frame(depth, settings.mode, {}), .depth = {}};
  LevelPalette palette = palette_of(depth.samples);
  if (settings.mode != DepthMode::Bounded) {
    WrittenPacket packet = write_lossless(depth, palette, settings.mode, reference);
    if (!is_predictive(settings.mode)) return {.packet = std::move(packet), .depth = {}};
    return {.packet = std::move(packet), .depth = depth, .palette = std::move(palette)};
  }
  if (reference.depth == nullptr) reconstruction = reconstruction_levels_for(depth, palette, settings.bound);
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
  const std::optional<DepthWindow> around = has_window ? window : std::nullopt;
  CodedFrame coded =
      !is_key && mode == DepthMode::Temporal ? state.code_smaller(depth, around) : state.code(depth, around, is_key);
  state.since_key = is_key || coded.packet.key_frame ? 0 : state.since_key + 1;
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
