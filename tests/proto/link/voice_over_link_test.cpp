// Speech through a sealed link that loses packets in bursts, and through the listener's jitter buffer, in virtual time:
// what a busy machine adds does not count here.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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
constexpr Nanoseconds kOpusLag{6'500'000};  // of the decoded sound behind the coded sound
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
  /// Of the images when they were shown: how far their capture was from the instant of the sound heard then [ms].
  [[nodiscard]] double apart_ms(double share) { return quantile_of(apart_ms_, share); }
  [[nodiscard]] std::size_t compared() const { return apart_ms_.size(); }
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
  /// Shows an image that was captured when the frame of its number had been said.
  void show(std::uint32_t number, SessionTime now) {
    ++images_;
    if (number < shown_) return;  // a newer one is on the screen
    shown_ = number;
    const SessionTime captured = kBegin + number * Nanoseconds(kVoiceFrameTime);
    if (!heard_ || now - heard_->at > kVoiceFrameTime || number < kSettled) return;
    apart_ms_.push_back(std::abs(to_milliseconds(heard_->spoken + (now - heard_->at) - captured)));
  }
  void hear(SessionTime now) {
    while (const std::optional<Frame> frame = pair_.client().take(now)) {
      if (frame->channel == kImages) show(get_little_endian<std::uint32_t>(frame->bytes.data()), now);
      if (frame->channel != kVoice || !frame->newest) continue;
      const std::uint32_t newest = get_little_endian<std::uint32_t>(frame->bytes.data()) - 1;
      for (std::uint32_t number = newest - std::min(newest, kEarlier); number <= newest; ++number)
        playout_.add({.talker = 1, .number = number, .begun = 0, .opus = opus()[number % opus().size()]}, now);
    }
  }
  void play(SessionTime now) {
    const codec::VoicePlayout::Played played = playout_.next(now);
    heard_.reset();
    if (played.kind != codec::VoicePlayout::Kind::Silence && played.kind != codec::VoicePlayout::Kind::Stretched)
      heard_ = Heard{.at = now, .spoken = kBegin + played.number * Nanoseconds(kVoiceFrameTime) - kOpusLag};
    if (played.kind != codec::VoicePlayout::Kind::Voice || played.number < kSettled) return;
    const SessionTime spoken = kBegin + played.number * Nanoseconds(kVoiceFrameTime);
    mouth_to_ear_ms_.push_back(to_milliseconds(now - spoken - kOneWay + kOpusLag));
  }

  /// A frame whose sound began at `at`.
  struct Heard {
    SessionTime at{};
    SessionTime spoken{};
  };

  impaired::ImpairedPair pair_;
  std::size_t image_B_;
  std::optional<Heard> heard_;  // nullopt: silence
  std::uint32_t shown_ = 0;     // number of the newest image
  std::vector<double> apart_ms_;
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

/// Images beside each frame: 0.8, 2.4 and 3.2 Mbit/s of the 4 Mbit/s that the line has.
TEST(VoiceOverLink, SpeechIsHeardSoonAfterOrBeforeItsPicture) {
  // 40 ms are wanted and not reached: small images arrive before speech has left its jitter buffer, large ones after
  // it.
  constexpr double kMostApart_ms = 100.0;
  for (const std::size_t image_B : {std::size_t{2'000}, std::size_t{6'000}, std::size_t{8'000}})
    for (const double loss : {0.0, 0.01}) {
      Talk talk(line(loss, 1.0), image_B, 5);
      talk.run();
      std::cout << image_B << " B, loss " << loss << ": p95 " << talk.apart_ms(0.95) << " ms, p50 "
                << talk.apart_ms(0.5) << " ms apart; mouth to ear p95 " << talk.mouth_to_ear_ms(0.95) << " ms; "
                << talk.played_percent() << " % played\n";
      ASSERT_GT(talk.compared(), 1'000u);
      EXPECT_LE(talk.apart_ms(0.95), kMostApart_ms);
      EXPECT_GE(talk.played_percent(), 99.0);
    }
  Talk bursts(line(0.1, 4.0), 6'000, 5);  // most images come late or not at all: told, not promised
  bursts.run();
  std::cout << "10 % loss in bursts of 4: p95 " << bursts.apart_ms(0.95) << " ms, p50 " << bursts.apart_ms(0.5)
            << " ms apart\n";
}

TEST(VoiceOverLink, WithoutLossSpeechHardlyWaits) {
  Talk talk(line(0.0, 1.0), 6'000, 1);
  talk.run();
  EXPECT_LE(talk.mouth_to_ear_ms(0.95), 70.0);
  EXPECT_GE(talk.played_percent(), 99.9);
}

}  // namespace
}  // namespace telepalp::link
