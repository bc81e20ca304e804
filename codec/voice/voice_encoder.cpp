#include <opus/opus.h>

#include <algorithm>
#include <cmath>

#include "codec/voice.h"
#include "proto/words/demand.h"

namespace telepalp::codec {
namespace {

/// Half of the best: speech sounds the same, and a station's core has other work.
constexpr int kComplexity = 5;

}  // namespace

struct VoiceEncoder::State {
  struct Destroy {
    void operator()(OpusEncoder* encoder) const noexcept { opus_encoder_destroy(encoder); }
  };
  std::unique_ptr<OpusEncoder, Destroy> encoder;
  opus_int32 delay_samples = 0;
};

VoiceEncoder::VoiceEncoder(const VoiceSettings& settings) : state_(std::make_unique<State>()) {
  int failed = OPUS_OK;
  state_->encoder.reset(opus_encoder_create(kVoiceRate_hz, 1, OPUS_APPLICATION_VOIP, &failed));
  demand(failed == OPUS_OK && state_->encoder, "libopus makes an encoder of one channel at 48 kHz");
  OpusEncoder* const encoder = state_->encoder.get();
  const bool set = opus_encoder_ctl(encoder, OPUS_SET_BITRATE(settings.bit_per_s)) == OPUS_OK &&
                   opus_encoder_ctl(encoder, OPUS_SET_COMPLEXITY(kComplexity)) == OPUS_OK &&
                   opus_encoder_ctl(encoder, OPUS_SET_SIGNAL(OPUS_SIGNAL_VOICE)) == OPUS_OK &&
                   opus_encoder_ctl(encoder, OPUS_SET_INBAND_FEC(1)) == OPUS_OK &&
                   opus_encoder_ctl(encoder, OPUS_SET_PACKET_LOSS_PERC(settings.expected_loss_pct)) == OPUS_OK &&
                   opus_encoder_ctl(encoder, OPUS_SET_DTX(0)) == OPUS_OK &&
                   opus_encoder_ctl(encoder, OPUS_GET_LOOKAHEAD(&state_->delay_samples)) == OPUS_OK;
  demand(set, "libopus takes these settings of speech");
}
VoiceEncoder::~VoiceEncoder() = default;
VoiceEncoder::VoiceEncoder(VoiceEncoder&&) noexcept = default;
VoiceEncoder& VoiceEncoder::operator=(VoiceEncoder&&) noexcept = default;

std::string VoiceEncoder::encode(const VoiceSamples& samples) {
  VoiceSamples finite;
  std::ranges::transform(samples, finite.begin(),
                         [](float sample) { return std::isfinite(sample) ? std::clamp(sample, -1.0F, 1.0F) : 0.0F; });
  std::string packet(kMaxVoicePacketBytes, '\0');
  const opus_int32 bytes =
      opus_encode_float(state_->encoder.get(), finite.data(), static_cast<int>(finite.size()),
                        reinterpret_cast<unsigned char*>(packet.data()), static_cast<opus_int32>(packet.size()));
  demand(bytes > 0, "libopus encodes any 20 ms of numbers");
  packet.resize(static_cast<std::size_t>(bytes));
  return packet;
}

int VoiceEncoder::delay_samples() const noexcept { return state_->delay_samples; }

}  // namespace telepalp::codec
