#include <opus/opus.h>

#include "codec/voice.h"
#include "proto/words/demand.h"

namespace telepalp::codec {
namespace {

Error damaged_voice(const char* what) {
  return {.what = std::string("a packet of speech is refused: ") + what,
          .where = "VoiceDecoder",
          .fix = "send Opus with one frame of 20 ms of one channel in a packet"};
}

}  // namespace

struct VoiceDecoder::State {
  struct Destroy {
    void operator()(OpusDecoder* decoder) const noexcept { opus_decoder_destroy(decoder); }
  };
  /// `packet` of 0 bytes: conceals. False: libopus refuses the packet.
  bool decode(std::span<const std::byte> packet, bool restores, VoiceSamples& samples) {
    const auto* bytes = packet.empty() ? nullptr : reinterpret_cast<const unsigned char*>(packet.data());
    return opus_decode_float(decoder.get(), bytes, static_cast<opus_int32>(packet.size()), samples.data(),
                             static_cast<int>(samples.size()), restores ? 1 : 0) == static_cast<int>(samples.size());
  }
  std::unique_ptr<OpusDecoder, Destroy> decoder;
};

VoiceDecoder::VoiceDecoder() : state_(std::make_unique<State>()) {
  int failed = OPUS_OK;
  state_->decoder.reset(opus_decoder_create(kVoiceRate_hz, 1, &failed));
  demand(failed == OPUS_OK && state_->decoder, "libopus makes a decoder of one channel at 48 kHz");
}
VoiceDecoder::~VoiceDecoder() = default;
VoiceDecoder::VoiceDecoder(VoiceDecoder&&) noexcept = default;
VoiceDecoder& VoiceDecoder::operator=(VoiceDecoder&&) noexcept = default;

Result<VoiceSamples> VoiceDecoder::decode(std::span<const std::byte> packet) {
  if (!is_voice_packet(packet)) return damaged_voice("it is not one frame of 20 ms of one channel");
  VoiceSamples samples{};
  if (!state_->decode(packet, false, samples)) return damaged_voice("libopus cannot decode it");
  return samples;
}

Result<VoiceSamples> VoiceDecoder::restore(std::span<const std::byte> next) {
  if (!is_voice_packet(next)) return damaged_voice("it is not one frame of 20 ms of one channel");
  VoiceSamples samples{};
  if (!state_->decode(next, true, samples)) return damaged_voice("libopus cannot decode it");
  return samples;
}

VoiceSamples VoiceDecoder::conceal() {
  VoiceSamples samples{};
  demand(state_->decode({}, false, samples), "libopus conceals 20 ms at any time");
  return samples;
}

void VoiceDecoder::restart() { opus_decoder_ctl(state_->decoder.get(), OPUS_RESET_STATE); }

}  // namespace telepalp::codec
