// How messages pass a cluster of NATS servers in parts; tests/end_to_end/relay_test.sh runs a real one.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "server/relay/relay_address.h"
#include "server/relay/relay_frames.h"

namespace {

using namespace telepalp;
using namespace telepalp::relay;

wire::Message depth(std::uint64_t sequence, std::size_t bytes, bool is_key = true) {
  std::string payload(bytes, '\0');
  for (std::size_t i = 0; i < bytes; ++i) payload[i] = static_cast<char>(i * 131 + sequence);
  return {wire::kCameraDepth, SessionTime{Nanoseconds{1'795'000'000'000'000'000}},
          std::make_shared<const std::string>(std::move(payload)), sequence, is_key};
}

std::vector<std::string> parts_of(const wire::Message& message, std::size_t most_B) {
  std::vector<std::string> parts;
  EXPECT_TRUE(PartCutter(most_B).cut(message, [&](std::string_view part) {
    parts.emplace_back(part);
    return true;
  }));
  return parts;
}

TEST(RelayFrames, AMessageOfAnySizeArrivesAsItWas) {
  PartJoiner joiner;
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, kLeastPartBytes - kPartHeaderBytes,
                                  kLeastPartBytes - kPartHeaderBytes + 1, std::size_t{300'000}}) {
    const wire::Message sent = depth(bytes + 1, bytes, bytes % 2 == 0);
    std::optional<wire::Message> came;
    for (const std::string& part : parts_of(sent, kLeastPartBytes)) {
      EXPECT_LE(part.size(), kLeastPartBytes);
      EXPECT_FALSE(came) << "whole before its last part";
      came = joiner.add(wire::kCameraDepth, part);
    }
    ASSERT_TRUE(came) << bytes;
    EXPECT_EQ(*came->payload, *sent.payload);
    EXPECT_EQ(came->sequence, sent.sequence);
    EXPECT_EQ(came->published, sent.published);
    EXPECT_EQ(bool{came->key_frame}, bool{sent.key_frame});
  }
  EXPECT_EQ(joiner.malformed() + joiner.incomplete(), 0U);
}

TEST(RelayFrames, AMessageThatLostAPartIsDroppedAndTheNextArrives) {
  PartJoiner joiner;
  const auto first = parts_of(depth(1, 20'000), kLeastPartBytes);
  const auto second = parts_of(depth(2, 20'000), kLeastPartBytes);
  for (std::size_t i = 0; i < first.size(); ++i)
    if (i != 2) {
      EXPECT_FALSE(joiner.add(wire::kCameraDepth, first[i]));
    }
  EXPECT_EQ(joiner.incomplete(), 1U);
  std::optional<wire::Message> came;
  for (const std::string& part : second) came = joiner.add(wire::kCameraDepth, part);
  ASSERT_TRUE(came);
  EXPECT_EQ(came->sequence, 2U);
}

TEST(RelayFrames, TopicsDoNotMix) {
  PartJoiner joiner;
  const auto depth_parts = parts_of(depth(7, 8000), kLeastPartBytes);
  wire::Message color = depth(7, 8000);
  color.topic = wire::kCameraColor;
  const auto color_parts = parts_of(color, kLeastPartBytes);
  std::size_t whole = 0;
  for (std::size_t i = 0; i < depth_parts.size(); ++i) {
    whole += joiner.add(wire::kCameraDepth, depth_parts[i]).has_value() ? 1 : 0;
    whole += joiner.add(wire::kCameraColor, color_parts[i]).has_value() ? 1 : 0;
  }
  EXPECT_EQ(whole, 2U);
}

TEST(RelayFrames, WhatNoRelaySendsIsRefused) {
  const std::string good = parts_of(depth(1, 100), kLeastPartBytes).front();
  const auto refused = [](const std::string& part, const wire::Topic& topic = wire::kCameraDepth) {
    PartJoiner joiner;
    return !joiner.add(topic, part) && joiner.malformed() == 1;
  };
  const auto altered = [&](std::size_t at, char value) {
    std::string part = good;
    part[at] = value;
    return part;
  };
  EXPECT_TRUE(refused(""));
  EXPECT_TRUE(refused(good.substr(0, kPartHeaderBytes - 1)));
  EXPECT_TRUE(refused(altered(0, 'X'))) << "other magic";
  EXPECT_TRUE(refused(altered(4, 0))) << "a message without a number";
  EXPECT_TRUE(refused(altered(24, 0))) << "no parts at all";
  EXPECT_TRUE(refused(altered(31, 0x7f))) << "2 GB are announced";
  EXPECT_TRUE(refused(altered(28, 99))) << "more bytes than announced";
  EXPECT_TRUE(refused(good.substr(0, good.size() - 1))) << "fewer bytes than announced";
  EXPECT_TRUE(refused(altered(20, 0), wire::kStationState)) << "this topic has no predicted message";
}

TEST(RelayAddress, NamesAClusterAndASite) {
  const auto address = parse_relay("nats://user:secret@a:4222,nats://b/ward_3-x", "--publish");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->cluster.url, "nats://user:secret@a:4222,nats://b");
  EXPECT_EQ(address->site, "ward_3-x");
  EXPECT_EQ(in_words(*parse_relay("nats://user:secret@a:4222/ward", "x")), "nats://a:4222/ward");
  for (const char* wrong : {"nats://", "nats://a", "nats:///ward", "nats://a/", "nats://a/w.x", "nats://a/*",
                            "nats://a/>", "http://a/ward", "", "nats://a/w d", "nats://a/w?x=1", "nats://a/w?creds="})
    EXPECT_FALSE(parse_relay(wrong, "--publish")) << wrong;
}

TEST(RelayAddress, EachRelayedTopicHasASubjectOfItsOwnSiteAlone) {
  for (const wire::Topic& topic : wire::kTopics) {
    const auto found = topic_of("a", subject_of("a", topic));
    EXPECT_EQ(found.has_value(), is_relayed(topic)) << topic.name;
    if (found) {
      EXPECT_EQ(found->name, topic.name);
    }
    EXPECT_FALSE(topic_of("a", subject_of("b", topic)));
  }
  EXPECT_FALSE(is_relayed(wire::kClock)) << "an edge has its own";
  EXPECT_FALSE(topic_of("a", "telepalp.a.ask.again"));
}

}  // namespace
