// The messages that a viewer may and may not send.

#include "server/gateway/viewer_commands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "proto/wire/viewer/viewer_hand.h"
#include "server/gateway/hand_holder.h"

namespace telepalp::server {
namespace {

std::string hand_at(double x, double y, double z, std::uint64_t viewer = 999) {
  msg::ViewerHand hand;
  hand.set_viewer(viewer);
  hand.set_sampled_us(7);
  hand.mutable_hand_camera()->set_x(x);
  hand.mutable_hand_camera()->set_y(y);
  hand.mutable_hand_camera()->set_z(z);
  return hand.SerializeAsString();
}

std::string data(const std::string& payload, std::string header = std::string("\x01\x05\0\0\0", 5)) {
  return header + payload;
}

/// A viewer that has advertised its hand as channel 5.
gateway::ViewerCommands voice() {
  gateway::ViewerCommands made;
  EXPECT_TRUE(made.advertise({5, "/viewer/hand", "protobuf"}));
  return made;
}

TEST(ViewerCommands, AHandIsPublishedStampedAndSignedByTheServer) {
  gateway::ViewerCommands viewer = voice();
  const auto heard = viewer.hear(data(hand_at(0.1, -0.2, 0.8)), 3, session_time(1'000));
  ASSERT_TRUE(heard);
  ASSERT_TRUE(heard->has_value());
  EXPECT_EQ((*heard)->topic.name, "/viewer/hand");
  EXPECT_EQ((*heard)->published, session_time(1'000));
  const auto hand = wire::read_viewer_hand(*(*heard)->payload);
  ASSERT_TRUE(hand);
  EXPECT_EQ(hand->viewer(), 3u) << "whatever the viewer wrote";
  EXPECT_EQ(hand->hand_camera().y(), -0.2);
}

TEST(ViewerCommands, NoOtherMessageIsAllowed) {
  gateway::ViewerCommands viewer;
  for (const auto& channel :
       {gateway::foxglove::Request::Channel{1, "/station/events", "protobuf"},
        gateway::foxglove::Request::Channel{1, "/camera/depth", "protobuf"},
        gateway::foxglove::Request::Channel{1, "/viewer/hand", "json"}, gateway::foxglove::Request::Channel{1, "", ""}})
    EXPECT_FALSE(viewer.advertise(channel)) << channel.topic;
  EXPECT_FALSE(viewer.hear(std::string("\x01\x01\0\0\0", 5) + hand_at(0, 0, 1), 1, {})) << "not advertised";
  for (std::uint32_t id = 0; id < 8; ++id) EXPECT_TRUE(viewer.advertise({id, "/viewer/hand", "protobuf"}));
  EXPECT_FALSE(viewer.advertise({8, "/viewer/hand", "protobuf"})) << "channels are bounded";
}

TEST(ViewerCommands, ImpossibleHandPositionsAreRefused) {
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  gateway::ViewerCommands viewer = voice();
  std::int64_t at = 0;
  for (const std::string& bytes :
       {std::string(), std::string("\x01"), std::string("\x02\x05\0\0\0", 5), data(""), data("\xff\xff\xff"),
        data(hand_at(nan, 0, 1)), data(hand_at(0, infinity, 1)), data(hand_at(0, 0, -10.1)), data(hand_at(1e300, 0, 1)),
        data(hand_at(0, 0, 1) + std::string(200, ' ')), data(std::string(64'000, '\x0a'))})
    EXPECT_FALSE(viewer.hear(bytes, 1, session_time(at += 1'000'000'000))) << bytes.size();
}

TEST(ViewerCommands, AFloodIsThinnedToFiveHundredASecond) {
  gateway::ViewerCommands viewer = voice();
  int published = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto heard = viewer.hear(data(hand_at(0, 0, 1)), 1, session_time(i * 10'000));
    ASSERT_TRUE(heard);
    if (*heard) ++published;
  }
  EXPECT_EQ(published, 500);
  const auto after_the_clock_went_back = viewer.hear(data(hand_at(0, 0, 1)), 1, session_time(0));
  EXPECT_TRUE(after_the_clock_went_back && *after_the_clock_went_back);
}

TEST(ViewerCommands, LettingGoIsHeardOnItsOwnChannelOnly) {
  const gateway::ViewerCommands viewer = voice();
  msg::ViewerHand hand;
  hand.set_let_go(true);
  EXPECT_TRUE(viewer.lets_go(data(hand.SerializeAsString())));
  EXPECT_FALSE(viewer.lets_go(data(hand.SerializeAsString(), std::string("\x01\x06\0\0\0", 5))));
  EXPECT_FALSE(viewer.lets_go(data(hand_at(0, 0, 1))));
  EXPECT_FALSE(viewer.lets_go(data(std::string(1000, '\xff'))));
}

using namespace std::chrono_literals;

TEST(HandHolder, AHandIsHeldUntilItsViewerLetsGo) {
  gateway::HandHolder holder;
  const SessionTime began = session_time(1'000);
  EXPECT_TRUE(holder.moves(1, began, true));
  EXPECT_FALSE(holder.moves(2, began + 1h, true));
  holder.let_go(2);
  EXPECT_FALSE(holder.moves(2, began + 2h, true)) << "letting go of what it does not hold changes nothing";
  holder.let_go(1);
  EXPECT_TRUE(holder.moves(2, began + 2h + 1ms, true));
  EXPECT_FALSE(holder.moves(1, began + 2h + 2ms, true));
}

TEST(HandHolder, OnlyADoctorsOwnViewerMovesTheStationUnlessItHandsTheHandOver) {
  gateway::HandHolder holder;
  const SessionTime began = session_time(1'000);
  EXPECT_FALSE(holder.moves(2, began, false)) << "the hand is free, and the station another doctor's";
  EXPECT_FALSE(holder.may_command(2, false));
  EXPECT_TRUE(holder.moves(1, began, true));
  EXPECT_FALSE(holder.moves(2, began, false));
  EXPECT_TRUE(holder.hand_over(1, 2, began));
  EXPECT_TRUE(holder.moves(2, began, false)) << "it was handed over";
  EXPECT_TRUE(holder.may_command(2, false));
  holder.let_go(2);
  EXPECT_FALSE(holder.moves(2, began, false));
  EXPECT_TRUE(holder.moves(3, began, true));
  EXPECT_FALSE(holder.moves(3, began, false)) << "another doctor's station took the touch meanwhile";
  EXPECT_FALSE(holder.holds(3));
}

TEST(HandHolder, ASilentViewerLosesTheHandAfterTwoSeconds) {
  gateway::HandHolder holder;
  const SessionTime began = session_time(1'000);
  EXPECT_TRUE(holder.moves(1, began, true));
  EXPECT_TRUE(holder.moves(1, began + 1s, true));
  holder.end_if_silent(began + 2900ms);
  EXPECT_FALSE(holder.moves(2, began + 2900ms, true)) << "1.9 s of silence";
  holder.end_if_silent(began + 3100ms);
  EXPECT_FALSE(holder.holds(1));
  EXPECT_EQ(holder.news(began + 3100ms)->viewer(), 0u);
  EXPECT_TRUE(holder.moves(2, began + 3200ms, true));
}

TEST(HandHolder, TheHolderHandsOverToAViewerThatAsksAndToNobodyElse) {
  gateway::HandHolder holder;
  const SessionTime began = session_time(1'000);
  EXPECT_TRUE(holder.moves(1, began, true));
  EXPECT_FALSE(holder.hand_over(1, 2, began)) << "viewer 2 does not ask";
  EXPECT_FALSE(holder.moves(2, began + 1s, true));
  EXPECT_FALSE(holder.moves(3, began + 1s, true));
  EXPECT_FALSE(holder.hand_over(3, 2, began + 1s)) << "viewer 3 holds nothing";
  EXPECT_FALSE(holder.hand_over(1, 2, began + 5s)) << "the request is 4 s old";
  EXPECT_FALSE(holder.moves(2, began + 5s, true));
  EXPECT_TRUE(holder.hand_over(1, 2, began + 6s));
  EXPECT_FALSE(holder.moves(3, began + 6s, true)) << "nobody takes the hand in between";
  EXPECT_EQ(holder.news(began + 6s)->viewer(), 2u);
  EXPECT_TRUE(holder.moves(2, began + 6s, true));
  EXPECT_FALSE(holder.moves(1, began + 6s, true));
}

TEST(ViewerCommands, HandingOverNamesAViewer) {
  const gateway::ViewerCommands viewer = voice();
  msg::ViewerHand hand;
  hand.set_hand_over_to(7);
  EXPECT_EQ(viewer.hands_over_to(data(hand.SerializeAsString())), 7u);
  EXPECT_FALSE(viewer.hands_over_to(data(hand.SerializeAsString(), std::string("\x01\x06\0\0\0", 5))));
  EXPECT_FALSE(viewer.hands_over_to(data(hand_at(0, 0, 1))));
  EXPECT_FALSE(viewer.hands_over_to(data(std::string(1000, '\xff'))));
}

TEST(ViewerCommands, ReArmingIsAMessageOfItsOwn) {
  gateway::ViewerCommands viewer = voice();
  msg::ViewerHand hand;
  hand.set_rearm(true);
  EXPECT_TRUE(viewer.asks_to_rearm(data(hand.SerializeAsString())));
  EXPECT_FALSE(viewer.asks_to_rearm(data(hand.SerializeAsString(), std::string("\x01\x06\0\0\0", 5))));
  EXPECT_FALSE(viewer.asks_to_rearm(data(hand_at(0, 0, 1))));
  EXPECT_FALSE(viewer.hear(data(hand.SerializeAsString()), 3, session_time(1'000))) << "it is no hand";
  hand.mutable_hand_camera()->set_z(0.8);
  const auto heard = viewer.hear(data(hand.SerializeAsString()), 3, session_time(1'000));
  ASSERT_TRUE(heard && *heard);
  EXPECT_FALSE(wire::read_viewer_hand(*(*heard)->payload)->rearm()) << "a hand never re-arms";
}

TEST(ViewerCommands, AcceptingAnObjectIsAMessageOfItsOwn) {
  gateway::ViewerCommands viewer = voice();
  msg::ViewerHand hand;
  hand.set_accept_object(true);
  EXPECT_TRUE(wire::read_viewer_hand(hand.SerializeAsString())) << "the station reads it without a position";
  EXPECT_TRUE(viewer.accepts_object(data(hand.SerializeAsString())));
  EXPECT_FALSE(viewer.asks_to_rearm(data(hand.SerializeAsString())));
  EXPECT_FALSE(viewer.accepts_object(data(hand.SerializeAsString(), std::string("\x01\x06\0\0\0", 5))));
  EXPECT_FALSE(viewer.accepts_object(data(hand_at(0, 0, 1))));
  hand.mutable_hand_camera()->set_z(0.8);
  const auto heard = viewer.hear(data(hand.SerializeAsString()), 3, session_time(1'000));
  ASSERT_TRUE(heard && *heard);
  EXPECT_FALSE(wire::read_viewer_hand(*(*heard)->payload)->accept_object()) << "a moving hand never accepts";
}

TEST(HandHolder, OnlyTheHolderCommandsTheStationWhileThereIsOne) {
  gateway::HandHolder holder;
  EXPECT_TRUE(holder.may_command(2, true));
  EXPECT_TRUE(holder.moves(1, session_time(0), true));
  EXPECT_TRUE(holder.may_command(1, true));
  EXPECT_FALSE(holder.may_command(2, true));
}

TEST(HandHolder, ARequestIsPublishedOnceAndForgottenAfterThreeSeconds) {
  gateway::HandHolder holder;
  const SessionTime began = session_time(1'000);
  EXPECT_FALSE(holder.news(began)) << "nobody holds it, nobody asks";
  EXPECT_TRUE(holder.moves(7, began, true));
  EXPECT_EQ(holder.news(began)->viewer(), 7u);
  EXPECT_FALSE(holder.moves(8, began + 1s, true));
  const auto asked = holder.news(began + 1s);
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->viewer(), 7u);
  ASSERT_EQ(asked->asking_size(), 1);
  EXPECT_EQ(asked->asking(0), 8u);
  EXPECT_FALSE(holder.moves(8, began + 2s, true));
  EXPECT_FALSE(holder.news(began + 2s));
  EXPECT_EQ(holder.news(began + 6s)->asking_size(), 0);
  holder.let_go(7);
  EXPECT_EQ(holder.news(began + 7s)->viewer(), 0u);
}

}  // namespace
}  // namespace telepalp::server
