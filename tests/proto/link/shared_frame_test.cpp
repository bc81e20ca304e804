// A frame that several subscribers get: its payload is read in place, and its repairs are made once.

#include "proto/link/frames/shared_frame.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>

#include "proto/link/frames/frame_sender.h"
#include "proto/link/seal/sealed_channel.h"
#include "proto/words/little_endian.h"

namespace telepalp::link {
namespace {

using namespace std::chrono_literals;

const SessionTime kCaptured{1h};

std::shared_ptr<const std::string> payload_of(std::size_t bytes) {
  std::mt19937 random(static_cast<unsigned>(bytes));
  std::string text(bytes, '\0');
  for (char& letter : text) letter = static_cast<char>(random());
  return std::make_shared<const std::string>(std::move(text));
}

std::shared_ptr<const SharedFrame> frame_of(const std::shared_ptr<const std::string>& payload,
                                            std::size_t prefix = 16) {
  return std::make_shared<const SharedFrame>(SharedFrame::Label{.number = 1, .captured = kCaptured},
                                             std::vector<std::byte>(prefix, std::byte{7}),
                                             std::as_bytes(std::span(*payload)), payload);
}

/// The frame as one piece: time stamp, prefix, payload, zeros.
std::vector<std::byte> whole(const std::string& payload, std::size_t prefix, const FrameLayout& layout) {
  std::vector<std::byte> bytes(8);
  put_little_endian<std::int64_t>(bytes.data(), to_nanoseconds(kCaptured));
  bytes.insert(bytes.end(), prefix, std::byte{7});
  for (const char letter : payload) bytes.push_back(static_cast<std::byte>(letter));
  bytes.resize(layout.data_shards * layout.shard_bytes);
  return bytes;
}

TEST(SharedFrame, ItsShardsAreTheFrameOfAnySize) {
  for (const std::size_t prefix : {0U, 16U})
    for (const std::size_t bytes :
         {1U, 7U, 1120U, 1121U, 1144U, 1145U, 1146U, 2300U, 50'000U, 147'000U, 148'000U, 8'000'000U}) {
      const auto payload = payload_of(bytes);
      const auto frame = frame_of(payload, prefix);
      const FrameLayout& layout = frame->layout();
      const std::vector<std::byte> expected = whole(*payload, prefix, layout);
      for (std::size_t block = 0; block < layout.blocks; ++block)
        for (std::size_t i = 0; i < layout.data_in_block(block); ++i) {
          const auto shard = frame->shard(block, i);
          const auto part = std::span(expected).subspan(layout.offset(block, i), layout.shard_bytes);
          ASSERT_TRUE(std::ranges::equal(shard, part)) << bytes << " B, block " << block << ", shard " << i;
        }
    }
}

/// What eight links read while each sends `frame`: bytes of the payload, and bytes in other memory, each address once.
struct ReadBytes {
  std::size_t of_payload = 0;
  std::map<const std::byte*, std::size_t> elsewhere;  // by address
  [[nodiscard]] std::size_t elsewhere_B() const {
    std::size_t sum = 0;
    for (const auto& [at, bytes] : elsewhere) sum += bytes;
    return sum;
  }
};
ReadBytes read_by(int links, const std::shared_ptr<const SharedFrame>& frame, const std::string& payload) {
  ReadBytes read;
  const auto* const begin = reinterpret_cast<const std::byte*>(payload.data());
  for (int link = 0; link < links; ++link) {
    FrameSender sender(100ms);
    PathEstimate path;
    sender.offer(frame);
    while (const auto next = sender.next(kCaptured, path)) {
      const bool is_inside =
          next->shard.data() >= begin && next->shard.data() + next->shard.size() <= begin + payload.size();
      if (is_inside)
        read.of_payload += next->shard.size();
      else
        read.elsewhere[next->shard.data()] = next->shard.size();
    }
  }
  return read;
}

TEST(SharedFrame, EachSubscriberReadsThePayloadOnceInPlaceAndTheRepairsAreShared) {
  constexpr int kLinks = 8;
  const auto payload = payload_of(150'000);
  const auto frame = frame_of(payload);
  const ReadBytes one = read_by(1, frame_of(payload), *payload);
  const ReadBytes all = read_by(kLinks, frame, *payload);
  EXPECT_EQ(all.of_payload, kLinks * one.of_payload) << "one pass for each subscriber";
  EXPECT_LE(one.of_payload, payload->size());
  EXPECT_GT(one.of_payload, payload->size() - 2 * frame->layout().shard_bytes) << "all but the two ends";
  EXPECT_EQ(all.elsewhere_B(), one.elsewhere_B()) << "seven more subscribers need no memory of their own";
  EXPECT_LT(one.elsewhere_B(), payload->size() / 5) << "the two ends, and the repairs";
}

TEST(SharedFrame, RepairsThatALinkNeedsLaterLeaveTheOthersInPlace) {
  const auto payload = payload_of(150'000);
  const auto frame = frame_of(payload);
  const std::size_t data = frame->layout().data_in_block(0);
  frame->make_repairs(0, 2);
  const std::byte* const first = frame->shard(0, data).data();
  const std::vector<std::byte> before(first, first + frame->layout().shard_bytes);
  frame->make_repairs(0, kMostRepairShards);
  EXPECT_EQ(frame->shard(0, data).data(), first);
  EXPECT_TRUE(std::ranges::equal(frame->shard(0, data), before));
}

TEST(Sealer, APayloadInTwoPartsIsSealedAsOne) {
  for (const Cipher cipher : {Cipher::Aes256Gcm, Cipher::ChaCha20Poly1305})
    for (const std::size_t head : {0U, 1U, 15U, 16U, 17U}) {
      const SealSettings settings{.number = 5, .cipher = cipher};
      Sealer in_one(settings, Direction::ServerToClient), in_two(settings, Direction::ServerToClient);
      const auto payload = payload_of(1150);
      const auto bytes = std::as_bytes(std::span(*payload));
      Datagram one, two;
      ASSERT_TRUE(in_one.seal(bytes, one));
      ASSERT_TRUE(in_two.seal(bytes.first(head), bytes.subspan(head), two));
      EXPECT_TRUE(std::ranges::equal(one.bytes(), two.bytes())) << head;
    }
}

}  // namespace
}  // namespace telepalp::link
