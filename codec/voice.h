#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "proto/words/result.h"
#include "proto/words/voice/voice_packet.h"

namespace telepalp::codec {

/// 20 ms of speech: one channel at 48 kHz, in [-1, 1].
using VoiceSamples = std::array<float, kVoiceFrameSamples>;

struct VoiceSettings {
  int bit_per_s = 24'000;      ///< target rate; single frames may be larger
  int expected_loss_pct = 10;  ///< 0 to 100: how much of a frame is repeated coarsely in the next one (in-band FEC)
};

/// Compresses the speech of one microphone in order, as Opus (RFC 6716). Silence is coded, too: a pause without packets
/// would look like loss.
class VoiceEncoder {
 public:
  explicit VoiceEncoder(const VoiceSettings& settings = {});
  ~VoiceEncoder();
  VoiceEncoder(VoiceEncoder&&) noexcept;
  VoiceEncoder& operator=(VoiceEncoder&&) noexcept;

  /// The packet of the next 20 ms: one that is_voice_packet(). Samples that are not numbers count as 0.
  [[nodiscard]] std::string encode(const VoiceSamples& samples);

  /// Samples by which the decoded sound lags behind the encoded sound.
  [[nodiscard]] int delay_samples() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Decodes the packets of one VoiceEncoder in order. For each lost packet, the caller calls restore() or conceal().
class VoiceDecoder {
 public:
  VoiceDecoder();
  ~VoiceDecoder();
  VoiceDecoder(VoiceDecoder&&) noexcept;
  VoiceDecoder& operator=(VoiceDecoder&&) noexcept;

  /// The next 20 ms. Error: not a voice packet, or damaged; the decoder's state has not changed.
  [[nodiscard]] Result<VoiceSamples> decode(std::span<const std::byte> packet);
  /// The 20 ms before `next`, whose own packet was lost: from the coarse repetition that `next` holds. Without a
  /// repetition Opus conceals. Error: as for decode(). Afterwards, decode(next) follows.
  [[nodiscard]] Result<VoiceSamples> restore(std::span<const std::byte> next);
  /// 20 ms that continue the sound before, and fade while they are repeated. Opus's own concealment.
  [[nodiscard]] VoiceSamples conceal();
  /// Forgets the sound before: another talker begins.
  void restart();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace telepalp::codec
