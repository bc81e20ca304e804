#include <gtest/gtest.h>

#include <limits>

#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <random>

#include "server/hub/upstream.h"
#include "tests/server/loopback_site.h"

namespace telepalp::server {
namespace {

using boost::asio::ip::tcp;

msg::Control hello() {
  msg::Control control;
  control.mutable_hello()->set_protocol(wire::kProtocolVersion);
  control.mutable_hello()->set_name("stranger");
  return control;
}

msg::Control advertisement(std::uint32_t channel, std::string_view topic, std::string_view schema) {
  msg::Control control;
  msg::Advertise::Topic& entry = *control.mutable_advertise()->add_topics();
  entry.set_channel(channel);
  entry.set_name(std::string(topic));
  entry.set_schema(std::string(schema));
  return control;
}

msg::Control subscription(const std::string& topic) {
  msg::Control control;
  control.mutable_subscribe()->add_topics(topic);
  return control;
}

/// A peer that sends any bytes.
class Stranger {
 public:
  explicit Stranger(Site& site) : socket_(site.io) {
    socket_.connect({boost::asio::ip::make_address("127.0.0.1"), site.listener->port()});
  }
  void say(const std::string& bytes) {
    boost::system::error_code ignored;  // the server may already have closed the connection
    boost::asio::write(socket_, boost::asio::buffer(bytes), ignored);
  }
  void listen() {
    socket_.async_read_some(boost::asio::buffer(buffer_), [this](const boost::system::error_code& code, std::size_t n) {
      heard_.append(buffer_.data(), n);
      closed_ = static_cast<bool>(code);
      if (!closed_) listen();
    });
  }
  void hang_up() { socket_.close(); }
  /// The reason in the server's Goodbye; empty without a Goodbye.
  std::string goodbye() const {
    wire::FrameParser parser;
    std::span<const std::byte> bytes = std::as_bytes(std::span(heard_));
    while (true) {
      const Result<std::optional<wire::Frame>> frame = parser.next(bytes);
      if (!frame || !*frame) return "";
      msg::Control control;
      if ((*frame)->header.kind == wire::FrameKind::Control && control.ParseFromString((*frame)->payload) &&
          control.has_goodbye())
        return control.goodbye().reason();
    }
  }
  bool closed() const { return closed_; }

 private:
  tcp::socket socket_;
  std::array<char, 4096> buffer_{};
  std::string heard_;
  bool closed_ = false;
};

/// The server's reply to a peer whose first bytes are `bytes`. Checks that the server disconnects it and continues to
/// serve others.
std::string answer_to(const std::string& bytes) {
  Site site;
  Client honest(site, {"/clock"}, "honest");
  EXPECT_TRUE(site.run_until([&] { return honest.connected(); }));
  Stranger stranger(site);
  stranger.listen();
  stranger.say(bytes);
  EXPECT_TRUE(site.run_until([&] { return stranger.closed(); }));
  EXPECT_TRUE(site.run_until([&] { return site.listener->peers() == 1; }));
  site.hub.publish(message(wire::kClock, "still here"));
  EXPECT_TRUE(site.run_until([&] { return honest.messages.size() == 1; }));
  EXPECT_EQ(honest.link.counts().connections, 1u);
  return stranger.goodbye();
}

void expect_says(const std::string& answer, const std::string& part) {
  EXPECT_NE(answer.find(part), std::string::npos) << "answered: " << answer;
}

TEST(HostilePeer, ALengthOfFourGibibytesIsRefused) {
  expect_says(answer_to(frame_bytes({.payload_bytes = 0xffffffffu}, "")), "declares a payload of 4294967295 B");
}

TEST(HostilePeer, APayloadBeyondWhatAStationMaySendIsRefused) {
  expect_says(
      answer_to(
          control_frame(hello()) +
          frame_bytes({.payload_bytes = hub::kMaxUpstreamBytes + 1, .kind = wire::FrameKind::Data, .channel = 1}, "")),
      "it declares a payload of 1048577 B, but at most 1048576 B are accepted");
}

TEST(HostilePeer, GarbageIsRefused) {
  std::mt19937 random(5);
  std::string garbage(64 << 10, '\0');
  for (char& byte : garbage) byte = static_cast<char>(random());
  expect_says(answer_to(garbage), "of the wire protocol instead of 1 or 2");
}

TEST(HostilePeer, AnHttpRequestIsRefused) {
  expect_says(answer_to("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"), "of the wire protocol instead of 1 or 2");
}

TEST(HostilePeer, DamagedControlIsRefused) {
  expect_says(answer_to(frame_bytes({.payload_bytes = 3}, "\xff\xff\xff")), "damaged control");
}

TEST(HostilePeer, DataBeforeHelloIsRefused) { expect_says(answer_to(data_frame(1, "x")), "data before its Hello"); }

TEST(HostilePeer, ASubscriptionBeforeHelloIsRefused) {
  expect_says(answer_to(control_frame(subscription("*"))), "does not begin with a Hello message");
}

TEST(HostilePeer, AnotherProtocolVersionIsNamed) {
  msg::Control control = hello();
  control.mutable_hello()->set_protocol(3);
  expect_says(answer_to(control_frame(control)), "speaks version 3 of the wire protocol instead of version 1 or 2");
}

TEST(HostilePeer, AChannelThatWasNotAdvertisedIsRefused) {
  expect_says(answer_to(control_frame(hello()) + data_frame(9, "x")), "channel 9 without advertising it");
}

TEST(HostilePeer, NobodyButTheServerPublishesTheCamera) {
  for (const wire::Topic& topic : {wire::kCameraDepth, wire::kCameraColor, wire::kCameraInfo, wire::kCameraStatus,
                                   wire::kClock, wire::kServerStats})
    expect_says(answer_to(control_frame(hello()) + control_frame(advertisement(1, topic.name, topic.schema))),
                "may not publish " + std::string(topic.name));
}

TEST(HostilePeer, AWellKnownTopicOfAnotherTypeIsRefused) {
  expect_says(answer_to(control_frame(hello()) + control_frame(advertisement(1, "/station/state", "evil.Type"))),
              "with another message type than telepalp.msg.StationState");
}

TEST(HostilePeer, AdvertisingWithoutEndIsRefused) {
  std::string bytes = control_frame(hello());
  for (std::uint32_t channel = 1; channel <= 300; ++channel)
    bytes += control_frame(advertisement(channel, "/unknown/" + std::to_string(channel), "a.B"));
  expect_says(answer_to(bytes), "more than 256 channels");
}

TEST(HostilePeer, AskingWithoutListeningEndsTheConnectionAndNotTheMemory) {
  Site site;
  Stranger stranger(site);
  msg::Control probe;
  probe.mutable_clock_probe()->set_asked_ns(1);
  std::string probes;
  for (int i = 0; i < 1000; ++i) probes += control_frame(probe);
  stranger.say(control_frame(hello()));
  for (int i = 0;
       i < 300 &&
       !site.run_until([&] { return site.listener->counts().accepted == 1 && site.listener->peers() == 0; }, 2ms);
       ++i)
    stranger.say(probes);
  EXPECT_EQ(site.listener->peers(), 0u);
  ASSERT_FALSE(site.notes.empty());
  expect_says(site.notes.back(), "without reading the replies");
}

TEST(HostilePeer, AskingForKeyFramesWithoutEndAsksThePublisherOnce) {
  Site site;
  int asked = 0;
  site.hub.on_key_frame_request([&](std::string_view) { ++asked; });
  for (int number = 1; number <= 2; ++number) {
    site.hub.publish(
        {wire::kCameraDepth, session_time(number), std::make_shared<const std::string>("d"), 0, number == 1});
  }
  std::string bytes = control_frame(hello()) + control_frame(subscription("/camera/depth"));
  for (const std::int64_t published : {std::int64_t{0}, std::int64_t{2}, std::numeric_limits<std::int64_t>::max(),
                                       std::numeric_limits<std::int64_t>::min()})
    for (const char* topic : {"/camera/depth", "/camera/color", "/nowhere", ""})
      for (int i = 0; i < 100; ++i) {
        msg::Control request;
        request.mutable_key_frame_request()->set_topic(topic);
        request.mutable_key_frame_request()->set_published_ns(published);
        bytes += control_frame(request);
      }
  Stranger stranger(site);
  stranger.listen();
  stranger.say(bytes + control_frame(advertisement(4, wire::kStationState.name, wire::kStationState.schema)) +
               data_frame(4, ""));  // the last message: all before it were handled
  const auto heard = [&] { return site.hub.topic_counts().contains(wire::kStationState.name); };
  ASSERT_TRUE(site.run_until(heard));
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(site.listener->peers(), 1u);
}

TEST(HostilePeer, AMessageThatIsNotOfItsTopicsTypeIsCountedAndGoesNoFurther) {
  Site site;
  Client viewer(site, {"/station/*"}, "viewer");
  ASSERT_TRUE(site.run_until([&] { return viewer.connected(); }));
  Stranger stranger(site);
  stranger.say(control_frame(hello()) +
               control_frame(advertisement(4, wire::kStationState.name, wire::kStationState.schema)) +
               data_frame(4, "\xff\xff\xff\xff") + data_frame(4, msg::StationState().SerializeAsString()));
  ASSERT_TRUE(site.run_until([&] { return viewer.messages.size() == 1; }));
  msg::StationState state;
  ASSERT_TRUE(state.ParseFromString(*viewer.messages[0].payload));
  EXPECT_NE(state.sender(), 0U) << "the server adds the sender's number";
  state.clear_sender();
  EXPECT_EQ(state.SerializeAsString(), "");
  EXPECT_EQ(site.listener->counts().invalid_messages, 1u);
}

TEST(HostilePeer, ATopicOfALaterVersionIsPassedOver) {
  Site site;
  Client viewer(site, {"*"}, "viewer");
  ASSERT_TRUE(site.run_until([&] { return viewer.connected(); }));
  Stranger newer(site);
  newer.say(control_frame(hello()) + control_frame(advertisement(1, "/station/thermal", "telepalp.msg.Thermal")) +
            control_frame(advertisement(2, wire::kStationState.name, wire::kStationState.schema)) +
            data_frame(1, "warm") + data_frame(2, ""));
  ASSERT_TRUE(site.run_until([&] { return viewer.messages.size() == 1; }));
  EXPECT_EQ(viewer.messages[0].topic.name, "/station/state");
}

TEST(HostilePeer, APeerThatHangsUpInTheMiddleOfAFrameLeavesNoTrace) {
  Site site;
  for (int round = 0; round < 20; ++round) {
    Stranger stranger(site);
    stranger.say(control_frame(hello()) +
                 data_frame(1, std::string(1000, 'x')).substr(0, 10 + 40u * static_cast<unsigned>(round)));
    stranger.hang_up();
  }
  EXPECT_TRUE(site.run_until([&] { return site.listener->counts().accepted == 20 && site.listener->peers() == 0; }));
  EXPECT_TRUE(site.hub.subscriber_counts().empty());
}

TEST(HostilePeer, SilenceBeforeHelloAndAfterHalfAFrameAreBothEndedAfterFiveSeconds) {
  Site site;
  Stranger mute(site);
  Stranger half(site);
  mute.listen();
  half.listen();
  mute.say(control_frame(hello()).substr(0, 12));
  // It holds a subscription: a peer without one may lose its place after five seconds, too.
  half.say(control_frame(hello()) + control_frame(subscription("*")) + control_frame(subscription("*")).substr(0, 20));
  EXPECT_FALSE(site.run_until([&] { return mute.closed() || half.closed(); }, 4s));
  EXPECT_TRUE(site.run_until([&] { return mute.closed() && half.closed(); }, 3s));
  EXPECT_EQ(mute.goodbye(), "no Hello message (the greeting of a telepalp program) arrived within 5 s");
  EXPECT_EQ(half.goodbye(), "no message arrived for 5 s");
}

TEST(HostilePeer, AThousandConnectionsHoldNoMorePlacesThanThereAre) {
  Site site;
  constexpr std::size_t kPlaces = 8;
  site.listener = site.listen(0, {.strangers = kPlaces});
  std::vector<std::unique_ptr<Stranger>> strangers;
  for (int i = 0; i < 1000; ++i) {
    if (strangers.size() == 100) strangers.erase(strangers.begin());
    strangers.push_back(std::make_unique<Stranger>(site));
    while (site.io.poll_one() != 0) EXPECT_LE(site.listener->peers(), kPlaces);
  }
  EXPECT_TRUE(site.run_until([&] { return site.listener->counts().accepted == 1000; }));
  EXPECT_GT(site.listener->counts().refused, 0u);
  strangers.clear();
  Client honest(site, {}, "honest");
  EXPECT_TRUE(site.run_until([&] { return honest.connected(); }));
}

TEST(HostilePeer, ASubscriberThatStallsLosesItsOwnImagesAndNobodyElses) {
  Site site;
  Client quick(site, {"/camera/depth", "/station/events"}, "quick");
  ASSERT_TRUE(site.run_until([&] { return quick.connected(); }));
  Stranger stalled(site);
  stalled.say(control_frame(hello()) + control_frame(subscription("*")));
  ASSERT_TRUE(site.run_until([&] { return site.hub.subscriber_counts().size() == 2; }));
  constexpr std::size_t kImages = 60;
  const std::string image(300'000, 'i');
  for (std::size_t i = 1; i <= kImages; ++i) {
    site.hub.publish(message(wire::kCameraDepth, image));
    site.hub.publish(message(wire::kStationEvents, "e"));
    ASSERT_TRUE(site.run_until([&] { return quick.messages.size() == 2 * i; }));
  }
  for (const hub::Hub::SubscriberCount& count : site.hub.subscriber_counts()) {
    const hub::Hub::TopicCount& depth = count.topics.at(wire::kCameraDepth.name);
    EXPECT_EQ(depth.published, kImages) << count.name;
    if (count.name == "quick") {
      EXPECT_EQ(depth.sent, kImages);
      EXPECT_EQ(count.dropped(), 0u);
    } else {
      EXPECT_GT(depth.dropped, kImages / 2) << "the kernel took the rest";
      EXPECT_EQ(count.topics.at(wire::kStationEvents.name).dropped, 0u);
    }
  }
}

}  // namespace
}  // namespace telepalp::server
