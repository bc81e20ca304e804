#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "proto/link/frames/frame_receiver.h"
#include "proto/link/path/loss_meter.h"

namespace telepalp::link {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds kDeadline = 100ms;
const SessionTime kStart{1h};

Frame frame(std::uint32_t number, std::size_t bytes, bool key_frame = true, std::uint8_t channel = 3) {
  Frame made{.channel = channel, .number = number, .key_frame = key_frame, .captured = kStart, .bytes = {}};
  std::mt19937 random(number);
  for (std::size_t i = 0; i < bytes; ++i) made.bytes.push_back(static_cast<std::byte>(random()));
  return made;
}

using Payloads = std::vector<std::vector<std::byte>>;

/// The next datagram's payload as one piece; nullopt: none.
std::optional<std::vector<std::byte>> next_payload(FrameSender& sender, SessionTime now, PathEstimate& path) {
  const auto next = sender.next(now, path);
  return next ? std::optional(next->joined()) : std::nullopt;
}

/// All fragments of `frame` as a new sender on an unknown path cuts them.
Payloads fragments(const Frame& frame) {
  FrameSender sender(kDeadline);
  PathEstimate path;
  sender.offer(frame);
  Payloads all;
  while (auto payload = next_payload(sender, kStart, path)) all.push_back(std::move(*payload));
  return all;
}

void add(FrameReceiver& receiver, const std::vector<std::byte>& payload, SessionTime at = kStart) {
  const auto fragment = read_fragment(payload);
  ASSERT_TRUE(fragment);
  receiver.add(*fragment, at);
}

TEST(Frames, OfAnySizeComeThroughInAnyOrderWithoutTheirRepairs) {
  std::mt19937 random(1);
  for (const std::size_t bytes : {1U, 7U, 1144U, 1145U, 1146U, 50'000U, 147'000U, 148'000U, 1'000'000U}) {
    const Frame sent = frame(1, bytes);
    Payloads payloads = fragments(sent);
    std::shuffle(payloads.begin(), payloads.end(), random);
    FrameReceiver receiver(kDeadline);
    for (const auto& payload : payloads) {
      ASSERT_LE(payload.size(), kPayloadBytes);
      add(receiver, payload);
      add(receiver, payload);  // twice
    }
    const auto received = receiver.take();
    ASSERT_TRUE(received) << bytes;
    EXPECT_EQ(received->bytes, sent.bytes);
    EXPECT_EQ(received->captured, sent.captured);
    EXPECT_FALSE(receiver.take());
    EXPECT_EQ(receiver.assembling_B(), 0U);
  }
}

TEST(Frames, LossUpToTheRepairsIsRestoredAndOneMoreIsNeverShown) {
  const Frame sent = frame(1, 100'000);
  const Payloads payloads = fragments(sent);
  const std::size_t repairs = read_fragment(payloads[0])->header.repair_shards;
  ASSERT_GE(repairs, 1U);
  std::mt19937 random(2);
  for (int round = 0; round < 50; ++round) {
    Payloads kept = payloads;
    std::shuffle(kept.begin(), kept.end(), random);
    kept.resize(payloads.size() - repairs);
    FrameReceiver receiver(kDeadline);
    for (std::size_t i = 0; i + 1 < kept.size(); ++i) add(receiver, kept[i]);
    EXPECT_FALSE(receiver.take());
    EXPECT_EQ(receiver.missing(kStart + 10ms), (std::vector<Missing>{{3, 1, 0, 1}}));
    add(receiver, kept.back());
    ASSERT_EQ(receiver.take()->bytes, sent.bytes);
  }
}

TEST(Frames, RepairsOnRequestCompleteABlock) {
  const Frame sent = frame(1, 100'000);
  FrameSender sender(kDeadline);
  PathEstimate path;
  sender.offer(sent);
  FrameReceiver receiver(kDeadline);
  for (int i = 0; const auto payload = next_payload(sender, kStart, path); ++i)
    if (i % 3 != 0) add(receiver, *payload);
  const std::vector<Missing> missing = receiver.missing(kStart + 10ms);
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_TRUE(receiver.missing(kStart + 1ms).empty());  // others may only have been overtaken
  sender.on_missing(missing, kStart + 20ms, path);
  sender.on_missing(missing, kStart + 20ms, path);
  std::size_t answers = 0;
  for (; const auto payload = next_payload(sender, kStart + 20ms, path); ++answers)
    add(receiver, *payload, kStart + 40ms);
  EXPECT_GE(answers, missing[0].shards);
  EXPECT_EQ(receiver.take()->bytes, sent.bytes);
}

/// A path that loses `percent` of the packets, as its reports say.
PathEstimate path_with_loss(std::uint32_t percent) {
  PathEstimate path;
  std::uint32_t lost = 0;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const SessionTime now = kStart - 2s + i * 1ms;
    path.sent(i, 1200, now);
    if (i % 100 < percent) ++lost;
    path.on_feedback({.highest_sequence = i,
                      .received_bytes = std::uint64_t{1200} * (i + 1 - lost),
                      .reported_ns = to_nanoseconds(now),
                      .held_us = 0,
                      .settled = i + 1,
                      .lost = lost,
                      .bursts = lost},
                     now);
  }
  return path;
}

TEST(Frames, OnAPathWithLossesAnEchoedFrameIsSentAgainAndEachEchoAloneRestoresIt) {
  const auto bytes = std::make_shared<const std::vector<std::byte>>(400, std::byte{7});
  const SharedFrame::Label spoken{.channel = 6, .number = 1, .captured = kStart, .echoed = true};
  const auto offered =
      std::make_shared<const SharedFrame>(spoken, std::span<const std::byte>{}, std::span(*bytes), bytes);
  PathEstimate path = path_with_loss(5);
  FrameSender sender(kDeadline);
  sender.offer(offered);
  while (next_payload(sender, kStart, path)) {
  }
  ASSERT_EQ(echoes_after(path.loss()).size(), 2U);
  EXPECT_EQ(echoes_after(0.1).size(), 4U);
  for (const Nanoseconds after : echoes_after(path.loss())) {
    ASSERT_EQ(sender.echo_due(), kStart + after);
    EXPECT_FALSE(next_payload(sender, kStart + after - 1ms, path));
    const auto echo = next_payload(sender, kStart + after, path);
    ASSERT_TRUE(echo);
    EXPECT_FALSE(next_payload(sender, kStart + after, path));
    FrameReceiver receiver(kDeadline);
    add(receiver, *echo);
    const auto restored = receiver.take();
    ASSERT_TRUE(restored);
    EXPECT_EQ(restored->bytes, *bytes);
  }
  EXPECT_FALSE(sender.echo_due());

  PathEstimate without_loss;
  FrameSender calm(kDeadline);
  calm.offer(offered);
  ASSERT_TRUE(next_payload(calm, kStart, without_loss));
  EXPECT_FALSE(calm.echo_due());
}

/// A frame of 400 bytes that overtakes others.
std::shared_ptr<const SharedFrame> urgent_frame(std::uint32_t number) {
  const auto bytes = std::make_shared<const std::vector<std::byte>>(400, std::byte{7});
  const SharedFrame::Label label{.channel = 6, .number = number, .captured = kStart, .urgent = true};
  return std::make_shared<const SharedFrame>(label, std::span<const std::byte>{}, std::span(*bytes), bytes);
}

TEST(Frames, AnUrgentFrameOvertakesTheRestOfAnImageThatHasBegun) {
  FrameSender sender(kDeadline);
  PathEstimate path;
  sender.offer(frame(1, 100'000));
  ASSERT_TRUE(next_payload(sender, kStart, path));
  EXPECT_FALSE(sender.idle());
  ASSERT_TRUE(sender.idle_for_urgent());
  sender.offer(urgent_frame(1));
  EXPECT_FALSE(sender.idle_for_urgent());
  const auto second = next_payload(sender, kStart, path);
  ASSERT_TRUE(second);
  EXPECT_EQ(read_fragment(*second)->header.channel, 6);
  std::size_t rest = 1;
  bool overtakes = true;  // with its repair shard
  while (const auto payload = next_payload(sender, kStart, path)) {
    const bool of_image = read_fragment(*payload)->header.channel == 3;
    EXPECT_TRUE(of_image || overtakes);
    EXPECT_EQ(sender.idle_for_urgent(), of_image || read_fragment(*payload)->header.shard > 0);
    overtakes = overtakes && !of_image;
    if (of_image) ++rest;
  }
  EXPECT_EQ(rest, fragments(frame(1, 100'000)).size()) << "the image is sent completely";
}

TEST(Frames, UrgentFramesWithoutEndStayBoundedAndLetTheImageThrough) {
  FrameSender sender(kDeadline);
  PathEstimate path;
  sender.offer(frame(1, 100'000));
  const std::size_t image = fragments(frame(1, 100'000)).size();
  std::size_t of_image = 0;
  for (std::uint32_t number = 1; number < 400 && of_image < image; ++number) {
    if (sender.idle_for_urgent()) sender.offer(urgent_frame(number));
    const auto payload = next_payload(sender, kStart, path);
    ASSERT_TRUE(payload) << number;
    if (read_fragment(*payload)->header.channel == 3) ++of_image;
  }
  EXPECT_EQ(of_image, image);
}

TEST(Frames, AShardThatWaitsForRoomIsNotRepaired) {
  FrameSender sender(kDeadline);
  PathEstimate path;
  sender.offer(frame(1, 100'000));
  FrameReceiver receiver(kDeadline);
  std::size_t sent = 10;
  for (std::size_t i = 0; i < sent; ++i) add(receiver, *next_payload(sender, kStart, path));
  const std::vector<Missing> missing = receiver.missing(kStart + 10ms);
  ASSERT_EQ(missing.size(), 1U);
  sender.on_missing(missing, kStart + 20ms, path);
  while (next_payload(sender, kStart + 20ms, path)) ++sent;
  EXPECT_EQ(sent, fragments(frame(1, 100'000)).size());
  EXPECT_EQ(sender.statistics().requested_shards, 0U);
}

TEST(Frames, AFrameIsKeptWhileItsFragmentsCome) {
  FrameReceiver receiver(kDeadline);
  const Payloads slow = fragments(frame(1, 100'000));
  for (std::size_t i = 0; i < slow.size(); ++i) {
    const SessionTime at = kStart + i * 2ms;
    receiver.step(at);
    add(receiver, slow[i], at);
  }
  EXPECT_TRUE(receiver.take());
  for (int i = 0; i < 40; ++i) {
    receiver.step(kStart + 1s + i * 20ms);
    EXPECT_LE(receiver.assembling_B(), 201'000U);
    add(receiver, fragments(frame(2, 200'000))[static_cast<std::size_t>(i)], kStart + 1s + i * 20ms);
  }
  EXPECT_GE(receiver.statistics().incomplete, 2U) << "a trickle is not kept for ever";
}

TEST(Frames, ARequestAfterTheDeadlineIsNotAnswered) {
  FrameSender sender(kDeadline);
  PathEstimate path;
  sender.offer(frame(1, 5000));
  while (next_payload(sender, kStart, path)) {
  }
  const std::vector<Missing> missing{{3, 1, 0, 2}, {3, 99, 0, 1}, {5, 1, 0, 1}, {3, 1, 77, 1}};
  sender.on_missing(missing, kStart + kDeadline + 1ms, path);
  EXPECT_FALSE(next_payload(sender, kStart + kDeadline + 1ms, path));
  sender.on_missing(missing, kStart + 50ms, path);  // only the first exists
  EXPECT_TRUE(next_payload(sender, kStart + 50ms, path));
}

TEST(Frames, NewestWins) {
  FrameSender sender(kDeadline);
  PathEstimate path;
  EXPECT_EQ(sender.offer(frame(1, 5000)), std::nullopt);
  EXPECT_EQ(sender.offer(frame(2, 5000)), 1U);
  FrameReceiver receiver(kDeadline);
  const Payloads third = fragments(frame(3, 5000));
  while (const auto payload = next_payload(sender, kStart, path)) add(receiver, *payload);
  for (const auto& payload : third) add(receiver, payload);
  EXPECT_EQ(receiver.take()->number, 2U);
  EXPECT_EQ(receiver.take()->number, 3U);
  for (const auto& payload : fragments(frame(2, 5000))) add(receiver, payload);  // late, and once more
  EXPECT_FALSE(receiver.take());
}

TEST(Frames, ANewFrameThatStandsAloneOvertakesAnIncompleteOne) {
  FrameReceiver receiver(kDeadline);
  const Payloads first = fragments(frame(1, 5000));
  add(receiver, first[0]);
  for (const auto& payload : fragments(frame(2, 5000))) add(receiver, payload);
  EXPECT_EQ(receiver.take()->number, 2U);
  for (const auto& payload : first) add(receiver, payload);
  const auto late = receiver.take();
  EXPECT_EQ(late->number, 1U);
  EXPECT_FALSE(late->newest);
  EXPECT_EQ(receiver.statistics().late, 1U);
  for (const auto& payload : first) add(receiver, payload);
  EXPECT_FALSE(receiver.take());
}

TEST(Frames, AFrameThatDependsOnAMissingOneIsNotShownAndAKeyFrameIsAskedFor) {
  FrameReceiver receiver(kDeadline);
  for (const auto& payload : fragments(frame(1, 5000))) add(receiver, payload);
  EXPECT_EQ(receiver.take()->number, 1U);
  for (const auto& payload : fragments(frame(3, 5000, false))) add(receiver, payload);
  EXPECT_FALSE(receiver.take());
  EXPECT_EQ(receiver.key_frames_wanted(), 0U);  // the second may still come
  receiver.step(kStart + 10ms);
  EXPECT_EQ(receiver.key_frames_wanted(), 1U << 3U);
  for (const auto& payload : fragments(frame(4, 5000))) add(receiver, payload);
  EXPECT_EQ(receiver.take()->number, 4U);
  EXPECT_EQ(receiver.key_frames_wanted(), 0U);
}

TEST(Frames, ADependentFrameWaitsForTheOneBeforeIt) {
  FrameReceiver receiver(kDeadline);
  for (const auto& payload : fragments(frame(1, 5000))) add(receiver, payload);
  EXPECT_EQ(receiver.take()->number, 1U);
  const Payloads second = fragments(frame(2, 5000, false));
  add(receiver, second[0]);
  for (const auto& payload : fragments(frame(3, 5000, false))) add(receiver, payload);
  receiver.step(kStart + 20ms);
  EXPECT_FALSE(receiver.take());
  for (const auto& payload : second) add(receiver, payload);
  EXPECT_EQ(receiver.take()->number, 2U);
  EXPECT_EQ(receiver.take()->number, 3U);
}

TEST(Frames, FirstFragmentsAloneAreBoundedAndTimeOut) {
  FrameReceiver receiver(kDeadline);
  for (std::uint32_t number = 1; number < 200; ++number) {
    std::vector<std::byte> payload(kFragmentHeaderBytes + FrameLayout(kMostFrameBytes).shard_bytes);
    write_fragment_header(
        {.channel = static_cast<std::uint8_t>(number % kMostChannels), .frame = number, .frame_bytes = kMostFrameBytes},
        std::span<std::byte, kFragmentHeaderBytes>(payload.data(), kFragmentHeaderBytes));
    add(receiver, payload);
    ASSERT_LE(receiver.assembling_B(), FrameReceiver::kMostAssembling_B);
  }
  receiver.step(kStart + kDeadline + 1ms);
  EXPECT_EQ(receiver.assembling_B(), 0U);
  EXPECT_EQ(receiver.statistics().incomplete, 199U);
}

TEST(Frames, AFrameAboveTheReceiversBoundIsRefused) {
  FrameReceiver receiver(kDeadline, 10'000);
  for (const auto& payload : fragments(frame(1, 20'000))) add(receiver, payload);
  EXPECT_EQ(receiver.assembling_B(), 0U);
  EXPECT_GT(receiver.statistics().malformed, 0U);
  for (const auto& payload : fragments(frame(2, 5000))) add(receiver, payload);
  EXPECT_EQ(receiver.take()->number, 2U);
}

TEST(Frames, AWrongFragmentIsRefused) {
  const std::vector<std::byte> good = fragments(frame(1, 5000))[0];
  EXPECT_TRUE(read_fragment(good));
  const auto with = [&](std::size_t at, std::uint8_t value) {
    std::vector<std::byte> bad = good;
    bad[at] = std::byte{value};
    return read_fragment(bad);
  };
  EXPECT_FALSE(with(0, 9));         // kind
  EXPECT_FALSE(with(1, 16));        // channel
  EXPECT_FALSE(with(2, 2));         // flags
  EXPECT_FALSE(with(7, 0));         // another size: the shard does not fit it
  EXPECT_FALSE(with(10, 255));      // 4 GiB
  EXPECT_FALSE(with(11, 1));        // block
  EXPECT_FALSE(with(12, 5 + 127));  // a repair index beyond the code
  EXPECT_FALSE(with(13, 128));      // repairs
  EXPECT_FALSE(with(14, 1));        // reserved
  for (std::size_t size = 0; size < good.size(); ++size) EXPECT_FALSE(read_fragment(std::span(good).first(size)));
}

TEST(Frames, FeedbackComesBackAsItWasWritten) {
  Feedback feedback{.highest_sequence = UINT64_MAX - 1,
                    .received_bytes = 1,
                    .reported_ns = 5,
                    .held_us = 7,
                    .settled = 8,
                    .lost = 9,
                    .bursts = 10,
                    .age_us = 11,
                    .key_frames_wanted = 0x8001};
  for (std::uint8_t i = 0; i < kMostMissing; ++i)
    feedback.missing.push_back(
        {static_cast<std::uint8_t>(i % kMostChannels), 7U * i, i, static_cast<std::uint8_t>(1 + i)});
  const std::vector<std::byte> written = write_feedback(feedback);
  EXPECT_LE(written.size(), kPayloadBytes);
  EXPECT_EQ(read_feedback(written), feedback);
  for (std::size_t size = 0; size < written.size(); ++size) EXPECT_FALSE(read_feedback(std::span(written).first(size)));
}

TEST(Frames, TimesBeforeTheSessionAreNotBelieved) {  // their differences would overflow; found by fuzzing
  EXPECT_FALSE(read_feedback(write_feedback({.reported_ns = INT64_MIN + 232})));
  FrameSender sender(kDeadline);
  PathEstimate path;
  sender.offer(frame(1, 100));
  std::vector<std::byte> payload = *next_payload(sender, kStart, path);
  put_little_endian<std::uint64_t>(&payload[kFragmentHeaderBytes], std::uint64_t{1} << 63U);
  FrameReceiver receiver(kDeadline);
  add(receiver, payload);
  EXPECT_EQ(receiver.take()->captured, SessionTime{});
}

TEST(LossMeter, CountsLossesAndBurstsAndForgivesReordering) {
  LossMeter meter;
  std::mt19937 random(3);
  std::vector<std::uint64_t> sequences;
  for (std::uint64_t i = 0; i < 10'000; ++i)
    if (i % 100 >= 4) sequences.push_back(i);  // bursts of four
  for (std::size_t i = 0; i + 50 < sequences.size(); i += 50)
    std::shuffle(sequences.begin() + static_cast<std::ptrdiff_t>(i),
                 sequences.begin() + static_cast<std::ptrdiff_t>(i) + 50, random);
  SessionTime now{1s};
  for (const std::uint64_t sequence : sequences) meter.received(sequence, now += 1ms);
  EXPECT_NEAR(meter.settled(), 10'000 - LossMeter::kPatience, 300);
  EXPECT_NEAR(meter.lost(), 0.04 * meter.settled(), 4);
  EXPECT_NEAR(meter.bursts(), meter.lost() / 4, 1);
}

TEST(LossMeter, AMeterWithoutTimeStillCountsWhenManyNewerPacketsCame) {
  LossMeter meter;
  for (std::uint64_t i = 1; i < 20'000; ++i) meter.received(i, SessionTime{1s});  // 0 is lost
  EXPECT_EQ(meter.lost(), 1U);
  EXPECT_NEAR(meter.settled(), 20'000 - LossMeter::kMostWaiting, 1);
}

TEST(LossMeter, AnOutageIsOneBurst) {
  LossMeter meter;
  for (std::uint64_t i = 0; i < 1000; ++i) meter.received(i, SessionTime{1s + i * 1ms});
  for (std::uint64_t i = 20'000; i < 21'000; ++i) meter.received(i, SessionTime{1s + i * 1ms});
  EXPECT_EQ(meter.bursts(), 1U);
  EXPECT_EQ(meter.lost(), 19'000U);
}

TEST(RepairShards, GrowWithLossAndBurstsAndStayBelowTheBound) {
  EXPECT_EQ(repair_shards(80, 0.0, 1.0, true), 0U);
  for (const bool repairable : {false, true}) {
    std::size_t last = 0;
    for (const double loss : {0.001, 0.01, 0.05, 0.1, 0.5, 1.0}) {
      const std::size_t shards = repair_shards(80, loss, 1.0, repairable);
      EXPECT_GE(shards, last);
      EXPECT_LE(shards, 34U);
      EXPECT_GE(repair_shards(80, loss, 4.0, repairable), shards);
      last = shards;
    }
  }
  EXPECT_LE(repair_shards(128, 1.0, 100.0, false), kMostRepairShards);
}

TEST(RepairShards, OfASmallBlockAreNoMoreThanItsLossesNeed) {
  EXPECT_EQ(repair_shards(3, 0.01, 1.0, false), 1U) << "two of four packets are lost in one block of 1700";
  EXPECT_EQ(repair_shards(8, 0.01, 1.0, false), 2U) << "one would fail in one block of 280";
  EXPECT_EQ(repair_shards(1, 0.1, 4.0, false), 2U) << "a burst takes both packets in one block of 27";
  EXPECT_EQ(repair_shards(12, 0.01, 1.0, true), 1U);
  for (std::size_t shards = 1; shards <= 12; ++shards) {
    EXPECT_LE(repair_shards(shards, 1.0, 100.0, false), (shards * 2 + 4) / 5 + 1);
    EXPECT_GE(repair_shards(shards, 0.3, 4.0, false), repair_shards(shards, 0.02, 4.0, false)) << shards;
  }
}

}  // namespace
}  // namespace telepalp::link
