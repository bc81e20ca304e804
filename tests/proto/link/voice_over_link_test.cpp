// Speech through a sealed link that loses packets in bursts, and through the listener's jitter buffer, in virtual time:
// what a busy machine adds does not count here.

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <vector>

#include "codec/voice_playout.h"
#include "proto/impaired/impaired_pair.h"
#include "proto/words/little_endian.h"
#include "proto/words/numbers/quantile.h"
#include "tests/support/speech.h"

namespace telepalp::link {
namespace {

using namespace std::chrono_literals;

constexpr SessionTime kBegin{100s};
constexpr Nanoseconds kOneWay = 25ms;
constexpr std::uint32_t kFrames = 3'000;  // 60 s
constexpr std::uint32_t kSettled = 250;   // 5 s, in which the jitter buffer has met the first bursts
constexpr std::uint32_t kEarlier = 6;     // frames that each message repeats
constexpr std::size_t kVoice_B = 520;
constexpr std::uint8_t kImages = 1;
constexpr std::uint8_t kVoice = 7;

impaired::Profile line(double loss, double burst_packets) {
  const impaired::Impairment both{
      .delay = kOneWay, .loss = loss, .burst_packets = burst_packets, .rate_B_per_s = 4e6 / 8.0, .queue_B = 250'000};
  return {.name = "thin", .down = both, .up = both};
}

std::shared_ptr<const SharedFrame> frame(std::uint8_t channel, std::uint32_t number, std::size_t size,
                                         SessionTime now) {
  auto bytes = std::make_shared<std::vector<std::byte>>(size, std::byte{7});
  put_little_endian<std::uint32_t>(bytes->data(), number);
  const bool spoken = channel == kVoice;
  return std::make_shared<const SharedFrame>(
      SharedFrame::Label{.channel = channel, .number = number, .captured = now, .echoed = spoken, .urgent = spoken},
      std::span<const std::byte>{}, std::span<const std::byte>(*bytes), bytes);
}

const std::vector<std::string>& opus() {
  static const std::vector<std::string> packets = [] {
    codec::VoiceEncoder encoder;
    std::vector<std::string> coded;
    for (std::uint32_t number = 0; number < 200; ++number) coded.push_back(encoder.encode(support::speech(number)));
    return coded;
  }();
  return packets;
}

/// A talker at the server's end, with an image of `image_B` beside each frame (0: none), and a listener.
class Talk {
 public:
  Talk(const impaired::Profile& network, std::size_t image_B, std::uint64_t seed)
      : pair_(kBegin, network, seed, {.seal = {.session = {}, .number = 1, .cipher = Cipher::Aes256Gcm}}),
        image_B_(image_B) {}

  void run() {
    const SessionTime end = kBegin + (kFrames + 50) * Nanoseconds(kVoiceFrameTime);
    for (SessionTime now = kBegin; now < end; now += 1ms) {
      const auto call = (now - kBegin) / Nanoseconds(kVoiceFrameTime);
      const bool begins = (now - kBegin) % Nanoseconds(kVoiceFrameTime) == 0ns;
      if (begins && call > 0 && call <= kFrames) say(static_cast<std::uint32_t>(call - 1), now);
      pair_.deliver(now);
      pair_.client().want_report();
      send(now);
      hear(now);
      if ((now - kBegin) % Nanoseconds(kVoiceFrameTime) == 7ms) play(now);
    }
  }
  [[nodiscard]] double mouth_to_ear_ms(double share) { return quantile_of(mouth_to_ear_ms_, share); }
  [[nodiscard]] double played_percent() const {
    return 100.0 * static_cast<double>(playout_.counts().played) / kFrames;
  }
  [[nodiscard]] double images_percent() const { return 100.0 * static_cast<double>(images_) / kFrames; }
  [[nodiscard]] double sent_Mbit_per_s() const {
    return 8e-6 * static_cast<double>(sent_B_) / (kFrames * to_seconds(Nanoseconds(kVoiceFrameTime)));
  }

 private:
  void say(std::uint32_t number, SessionTime now) {
    voice_ = frame(kVoice, number + 1, kVoice_B, now);
    if (image_B_ > 0) image_ = frame(kImages, number + 1, image_B_, now);
  }
  /// Sends in the order of DatagramEnd: speech before images, and only speech while an image is being sent.
  void send(SessionTime now) {
    do {
      const bool takes_any = pair_.server().ready_for_frame(now);
      if (voice_ && (takes_any || pair_.server().ready_for_urgent(now)))
        (void)pair_.server().offer(std::exchange(voice_, nullptr));
      else if (image_ && takes_any)
        (void)pair_.server().offer(std::exchange(image_, nullptr));
    } while (transmit(now) > 0);
    (void)pair_.transmit_from_client(now);
  }
  std::size_t transmit(SessionTime now) {
    const std::size_t bytes = pair_.transmit_from_server(now);
    sent_B_ += bytes;
    return bytes;
  }
  void hear(SessionTime now) {
    while (const std::optional<Frame> frame = pair_.client().take(now)) {
      if (frame->channel == kImages) ++images_;
      if (frame->channel != kVoice || !frame->newest) continue;
      const std::uint32_t newest = get_little_endian<std::uint32_t>(frame->bytes.data()) - 1;
      for (std::uint32_t number = newest - std::min(newest, kEarlier); number <= newest; ++number)
        playout_.add({.talker = 1, .number = number, .begun = 0, .opus = opus()[number % opus().size()]}, now);
    }
  }
  void play(SessionTime now) {
    const codec::VoicePlayout::Played played = playout_.next(now);
    if (played.kind != codec::VoicePlayout::Kind::Voice || played.number < kSettled) return;
    const SessionTime spoken = kBegin + played.number * Nanoseconds(kVoiceFrameTime);
    mouth_to_ear_ms_.push_back(to_milliseconds(now - spoken - kOneWay) + 6.5);  // Opus lags by 6.5 ms
  }

  impaired::ImpairedPair pair_;
  std::size_t image_B_;
  std::shared_ptr<const SharedFrame> voice_;
  std::shared_ptr<const SharedFrame> image_;
  codec::VoicePlayout playout_;
  std::vector<double> mouth_to_ear_ms_;
  std::size_t images_ = 0;
  std::uint64_t sent_B_ = 0;
};

/// The budget is 120 ms, which is missed (docs/performance-log.md). Without the echoes it was 188 ms.
constexpr double kMostDelay_ms = 170.0;

void expect_speech(std::size_t image_B) {
  for (const std::uint64_t seed : {1U, 21U, 41U, 61U}) {
    Talk talk(line(0.1, 4.0), image_B, seed);
    talk.run();
    std::cout << "seed " << seed << ": p95 " << talk.mouth_to_ear_ms(0.95) << " ms, p50 " << talk.mouth_to_ear_ms(0.5)
              << " ms, " << talk.played_percent() << " % played, " << talk.images_percent() << " % of the images, "
              << talk.sent_Mbit_per_s() << " Mbit/s\n";
    EXPECT_LE(talk.mouth_to_ear_ms(0.95), kMostDelay_ms) << "seed " << seed;
    EXPECT_GE(talk.played_percent(), 99.0) << "seed " << seed;
    if (image_B > 0) {
      EXPECT_GE(talk.images_percent(), 50.0) << "seed " << seed;
    }
  }
}

TEST(VoiceOverLink, TenPercentLossInBurstsOfFour) { expect_speech(0); }

TEST(VoiceOverLink, TheSameBesideImages) { expect_speech(6'000); }

TEST(VoiceOverLink, WithoutLossSpeechHardlyWaits) {
  Talk talk(line(0.0, 1.0), 6'000, 1);
  talk.run();
  EXPECT_LE(talk.mouth_to_ear_ms(0.95), 70.0);
  EXPECT_GE(talk.played_percent(), 99.9);
}

}  // namespace
}  // namespace telepalp::link
