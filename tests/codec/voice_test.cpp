// Speech as Opus: what is decoded is what was said, and bytes of a peer that are no speech are refused.

#include "codec/voice.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "tests/support/speech.h"

namespace telepalp::codec {
namespace {

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

TEST(Voice, WhatIsDecodedIsWhatWasSaid) {
  VoiceEncoder encoder;
  VoiceDecoder decoder;
  std::vector<float> said, heard;
  for (std::uint32_t frame = 0; frame < 100; ++frame) {
    const VoiceSamples samples = support::speech(frame);
    const std::string packet = encoder.encode(samples);
    ASSERT_TRUE(is_voice_packet(bytes_of(packet))) << "frame " << frame;
    const Result<VoiceSamples> decoded = decoder.decode(bytes_of(packet));
    ASSERT_TRUE(decoded);
    said.insert(said.end(), samples.begin(), samples.end());
    heard.insert(heard.end(), decoded->begin(), decoded->end());
  }
  const support::Alignment best = support::aligned(said, heard, 1'000);
  EXPECT_NEAR(static_cast<double>(best.lag_samples), encoder.delay_samples(), 24.0) << "half a millisecond";
  EXPECT_GT(best.correlation, 0.8);
}

TEST(Voice, ALostFrameIsRestoredFromTheNextOneBetterThanItIsConcealed) {
  VoiceEncoder encoder({.bit_per_s = 24'000, .expected_loss_pct = 30});
  VoiceDecoder whole, restoring, concealing;
  std::vector<float> right, restored, concealed;
  std::string lost;
  for (std::uint32_t frame = 0; frame < 200; ++frame) {
    const std::string packet = encoder.encode(support::speech(frame));
    const VoiceSamples truth = *whole.decode(bytes_of(packet));
    const bool is_lost = frame % 7 == 3;
    if (frame % 7 == 4) {  // now the frame before is played
      const VoiceSamples from_next = *restoring.restore(bytes_of(packet));
      const VoiceSamples made_up = concealing.conceal();
      restored.insert(restored.end(), from_next.begin(), from_next.end());
      concealed.insert(concealed.end(), made_up.begin(), made_up.end());
    }
    if (is_lost) {
      right.insert(right.end(), truth.begin(), truth.end());
      continue;
    }
    ASSERT_TRUE(restoring.decode(bytes_of(packet)));
    ASSERT_TRUE(concealing.decode(bytes_of(packet)));
  }
  right.resize(restored.size());
  const double by_repetition = support::correlation(right, restored);
  EXPECT_GT(by_repetition, 0.7);
  EXPECT_GT(by_repetition, support::correlation(right, concealed));
}

TEST(Voice, SamplesThatAreNoNumbersAreSilence) {
  VoiceEncoder encoder;
  VoiceSamples samples{};
  samples.fill(std::numeric_limits<float>::quiet_NaN());
  samples[3] = std::numeric_limits<float>::infinity();
  VoiceDecoder decoder;
  const std::string packet = encoder.encode(samples);
  const Result<VoiceSamples> decoded = decoder.decode(bytes_of(packet));
  ASSERT_TRUE(decoded);
  for (const float sample : *decoded) EXPECT_LT(std::abs(sample), 1e-2F);
}

TEST(Voice, PacketsOfAnotherShapeAreRefused) {
  struct Case {
    const char* what;
    std::string packet;
  };
  VoiceEncoder encoder;
  const std::string good = encoder.encode(support::speech(0));
  std::string stereo = good, two_frames = good, other_time = good;
  stereo[0] = static_cast<char>(stereo[0] | 4);
  two_frames[0] = static_cast<char>(two_frames[0] | 1);
  other_time[0] = static_cast<char>(static_cast<unsigned char>(3U << 3U));  // SILK, 60 ms
  for (const Case& one : {Case{"nothing", ""}, Case{"larger than any", good + std::string(kMaxVoicePacketBytes, 'x')},
                          Case{"two channels", stereo}, Case{"two frames", two_frames}, Case{"60 ms", other_time}}) {
    VoiceDecoder decoder;
    EXPECT_FALSE(decoder.decode(bytes_of(one.packet))) << one.what;
    EXPECT_FALSE(decoder.restore(bytes_of(one.packet))) << one.what;
    EXPECT_TRUE(decoder.decode(bytes_of(good))) << "after " << one.what;
  }
}

TEST(Voice, AnyBytesGiveAnErrorOrSound) {
  std::mt19937 random(7);
  VoiceDecoder decoder;
  std::uniform_int_distribution<int> byte(0, 255), size(0, 450);
  int taken = 0;
  for (int i = 0; i < 2'000; ++i) {
    std::string packet(static_cast<std::size_t>(size(random)), '\0');
    for (char& letter : packet) letter = static_cast<char>(byte(random));
    const Result<VoiceSamples> decoded = decoder.decode(bytes_of(packet));
    if (!decoded) continue;
    ++taken;
    for (const float sample : *decoded) ASSERT_TRUE(std::isfinite(sample)) << "seed 7, packet " << i;
  }
  EXPECT_GT(taken, 20) << "some random bytes have the form of a packet";
}

}  // namespace
}  // namespace telepalp::codec
