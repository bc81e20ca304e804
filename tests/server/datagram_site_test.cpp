// Deadline topics by sealed datagram, between a server and its clients over real sockets.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/server/datagram_relay.h"
#include "tests/server/keyed_site.h"

namespace telepalp::server {
namespace {

using keys::Role;
using wire::DatagramPhase;

/// What begins each JPEG image.
constexpr std::string_view kJpeg = "\xff\xd8\xff\xe0";

/// A keyed server, and a client behind a relay that carries UDP like a NAT.
struct RelayedSite : KeyedSite {
  DatagramRelay relay{io, listener->port()};
  KeyedClient client{*this, ring.key("anna", Role::Doctor), "doctor", {}, "127.0.0.1", relay.port()};
  std::uint64_t published = 0;

  bool up() {
    return run_until([&] { return client.link.datagrams() == DatagramPhase::Up && images_go_by_datagram(); });
  }
  [[nodiscard]] bool images_go_by_datagram() const {
    const auto counts = hub.subscriber_counts();
    return !counts.empty() && counts.front().by_datagram;
  }
  /// Publishes an image; true if it arrives within `patience`.
  bool image_arrives(std::chrono::milliseconds patience) {
    const std::string payload = std::string(kJpeg) + "JFIF" + std::to_string(++published) + std::string(50'000, 'x');
    hub.publish({wire::kCameraColor, clock.now(), std::make_shared<const std::string>(payload), 0, true});
    return run_until([&] { return !client.messages.empty() && *client.messages.back().payload == payload; }, patience);
  }
  /// Publishes images until one arrives. A datagram image that is late is dropped, which happens on a busy machine.
  bool images_arrive() {
    for (int tries = 0; tries < 5; ++tries)
      if (image_arrives(1s)) return true;
    return false;
  }
};

std::size_t count(const std::string& in, std::string_view what) {
  std::size_t found = 0;
  for (std::size_t at = in.find(what); at != std::string::npos; at = in.find(what, at + 1)) ++found;
  return found;
}

TEST(DatagramSite, ImagesGoByDatagramAndEverythingElseOverTcp) {
  RelayedSite site;
  ASSERT_TRUE(site.up());
  const std::size_t tcp_before = site.relay.tcp_overheard().size();
  ASSERT_TRUE(site.images_arrive());
  EXPECT_LT(site.relay.tcp_overheard().size() - tcp_before, 10'000U) << "the image of 50 kB does not cross TCP";
  const std::size_t udp_before = site.relay.udp_overheard().size();
  site.hub.publish(message(wire::kCameraInfo, std::string(30'000, 'i')));
  ASSERT_TRUE(site.run_until([&] { return site.client.messages.back().topic.name == wire::kCameraInfo.name; }));
  EXPECT_LT(site.relay.udp_overheard().size() - udp_before, 10'000U);
  EXPECT_NE(std::find(site.notes.begin(), site.notes.end(),
                      "test at " + site.address_of("test") + ": images go by sealed datagrams (UDP)"),
            site.notes.end());
}

TEST(DatagramSite, AMachineThatAnswersNoChallengeGetsAtMostThreeTimesTheBytesThatBoreItsAddress) {
  RelayedSite site;
  ASSERT_TRUE(site.up());
  ASSERT_TRUE(site.images_arrive());
  site.relay.name_a_third_machine_as_sender();
  for (int image = 0; image < 40; ++image) (void)site.image_arrives(50ms);
  EXPECT_GT(site.relay.sent_for_third_B, 0U);
  EXPECT_GT(site.relay.received_by_third_B, 0U) << "it gets the challenges";
  EXPECT_LE(site.relay.received_by_third_B, 3 * site.relay.sent_for_third_B);
}

TEST(DatagramSite, AClientOnANewPortIsProvedAgainAndItsImagesGoOn) {
  RelayedSite site;
  ASSERT_TRUE(site.up());
  ASSERT_TRUE(site.images_arrive());
  site.relay.rebind();
  site.run_until([] { return false; }, 300ms);  // the client reports each 100 ms, and answers the challenge
  const std::size_t udp_before = site.relay.udp_overheard().size();
  ASSERT_TRUE(site.images_arrive());
  EXPECT_GT(site.relay.udp_overheard().size() - udp_before, 50'000U) << "by datagram, to the new port";
}

/// A doctor's station behind a relay, and a viewer that watches its state.
struct StationSite : KeyedSite {
  DatagramRelay relay{io, listener->port()};
  KeyedClient station{*this,       ring.key("anna", Role::Doctor),
                      "doctor",    {wire::kStationState, wire::kStationTicks},
                      "127.0.0.1", relay.port()};
  KeyedClient viewer{*this, ring.key("bea", Role::Viewer)};
  std::uint64_t published = 0;

  bool up() {
    return run_until(
        [&] { return station.link.datagrams() == DatagramPhase::Up && viewer.link.datagrams() == DatagramPhase::Up; });
  }
  /// The station publishes states until the viewer gets one. A change of the carrier may drop some.
  bool state_arrives() {
    for (int i = 0; i < 100; ++i) {
      (void)station.link.publish(station_state(static_cast<std::int64_t>(++published)));
      if (run_until([&] { return newest_state() == published; }, 100ms)) return true;
    }
    return false;
  }
  [[nodiscard]] std::uint64_t newest_state() const {
    msg::StationState state;
    if (viewer.messages.empty() || !state.ParseFromString(*viewer.messages.back().payload)) return 0;
    return state.stamp_ns();
  }
};

TEST(DatagramSite, TheStationsStateGoesByDatagramBothWays) {
  StationSite site;
  ASSERT_TRUE(site.up());
  const std::size_t sent_before = site.relay.from_client().size();
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(site.state_arrives());
  EXPECT_GE(site.relay.from_client().size() - sent_before, 50U);
}

TEST(DatagramSite, WhenUdpDiesTheStationsStateGoesOverTcp) {
  StationSite site;
  ASSERT_TRUE(site.up());
  ASSERT_TRUE(site.state_arrives());
  site.relay.blocks_udp = true;
  EXPECT_TRUE(site.run_until([&] { return site.station.link.datagrams() == DatagramPhase::Blocked; }, 10s));
  EXPECT_TRUE(site.state_arrives());
  EXPECT_TRUE(site.station.connected());
}

TEST(DatagramSite, AViewerPublishesNothingByDatagramEither) {
  KeyedSite site;
  KeyedClient watching(site, site.ring.key("bea", Role::Viewer));
  KeyedClient guest(site, site.ring.key("eve", Role::Viewer));
  ASSERT_TRUE(site.run_until([&] { return guest.link.datagrams() == DatagramPhase::Up; }));
  for (int i = 0; i < 20; ++i) (void)guest.link.publish(station_state(i + 1));
  site.io.run_for(200ms);
  EXPECT_TRUE(watching.messages.empty());
  EXPECT_TRUE(guest.connected());
}

TEST(DatagramSite, NobodyWhoCapturesThePacketsFindsAnImage) {
  RelayedSite site;
  ASSERT_TRUE(site.run_until([&] { return site.client.connected(); }));
  ASSERT_TRUE(site.images_arrive()) << "over TCP";
  ASSERT_TRUE(site.up());
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(site.images_arrive());
  EXPECT_GE(site.relay.udp_overheard().size(), 20U * 50'000U);
  for (const std::string* crossed : {&site.relay.udp_overheard(), &site.relay.tcp_overheard()}) {
    EXPECT_EQ(count(*crossed, "JFIF") + count(*crossed, kJpeg), 0U);
    EXPECT_EQ(count(*crossed, "xxxx"), 0U);
  }
}

TEST(DatagramSite, WithoutTlsOnOneMachineTheyAreSealedWithASecretOfTheOffer) {
  Site site;
  Client client(site, {"/camera/*"}, "test", 0, "viewer", true);
  ASSERT_TRUE(site.run_until([&] { return client.link.datagrams() == DatagramPhase::Up; }));
  ASSERT_TRUE(site.run_until([&] { return site.hub.subscriber_counts().front().by_datagram; }));
  site.hub.publish(message(wire::kCameraDepth, "depth"));
  ASSERT_TRUE(site.run_until([&] { return !client.messages.empty(); }));
  EXPECT_EQ(*client.messages[0].payload, "depth");
}

TEST(DatagramSite, WhereUdpIsBlockedImagesGoOverTcpAndBothEndsSaySo) {
  RelayedSite site;
  site.relay.blocks_udp = true;
  ASSERT_TRUE(site.run_until([&] { return site.client.connected(); }));
  EXPECT_TRUE(site.images_arrive()) << "while it is tried";
  ASSERT_TRUE(site.run_until([&] { return site.client.link.datagrams() == DatagramPhase::Blocked; }, 3s));
  EXPECT_TRUE(site.images_arrive());
  const std::string note = "test at " + site.address_of("test") + ": no UDP datagram arrives: images go over TCP";
  EXPECT_TRUE(
      site.run_until([&] { return std::find(site.notes.begin(), site.notes.end(), note) != site.notes.end(); }, 3s));
  site.relay.blocks_udp = false;  // a firewall was opened meanwhile
  EXPECT_TRUE(site.run_until([&] { return site.images_go_by_datagram(); }, 10s));
}

TEST(DatagramSite, WhenUdpDiesImagesGoOverTcpWithinASecondAndAHalf) {
  RelayedSite site;
  ASSERT_TRUE(site.up());
  site.relay.blocks_udp = true;
  const auto died = std::chrono::steady_clock::now();
  while (!site.image_arrives(100ms) && std::chrono::steady_clock::now() - died < 5s) continue;
  EXPECT_LT(std::chrono::steady_clock::now() - died, 1500ms);
  EXPECT_TRUE(site.client.connected()) << "the connection lives on";
}

TEST(DatagramSite, ANatThatChangesThePortIsFollowed) {
  RelayedSite site;
  ASSERT_TRUE(site.up());
  ASSERT_TRUE(site.images_arrive());
  const auto before = site.relay.nat_port();
  site.relay.rebind();
  ASSERT_NE(site.relay.nat_port(), before);
  site.io.run_for(250ms);  // the next report of the client shows the new port
  EXPECT_TRUE(site.images_arrive());
  site.client.link.change_datagram_port();
  site.io.run_for(250ms);
  EXPECT_TRUE(site.images_arrive());
  EXPECT_EQ(site.client.link.datagrams(), DatagramPhase::Up);
}

TEST(DatagramSite, StrangersForgersAndReplaysAreNotAnsweredAndAreCounted) {
  RelayedSite site;
  ASSERT_TRUE(site.up());
  std::string forged = site.relay.from_client().back();
  forged[8] = static_cast<char>(forged[8] + 100);  // a sequence number that has not come yet
  std::string of_nobody = forged;
  of_nobody[4] = static_cast<char>(of_nobody[4] + 1);
  std::vector<std::string> evil(50, forged);
  evil.insert(evil.end(), {of_nobody, "", "GET / HTTP/1.1\r\n\r\n", std::string(1500, '\1'), std::string(65, '\0')});
  evil.insert(evil.end(), site.relay.from_client().begin(), site.relay.from_client().end());
  const std::uint64_t replays = site.relay.from_client().size();
  EXPECT_EQ(DatagramRelay::answers_to(site.io, site.listener->port(), evil), 0U);
  const hub::DatagramCounts counts = site.listener->datagram_counts();
  EXPECT_EQ(counts.forged, 50U);
  EXPECT_EQ(counts.strangers, 5U);
  EXPECT_EQ(counts.replayed, replays);
  EXPECT_TRUE(site.images_arrive()) << "a replay does not redirect the stream";
}

TEST(DatagramSite, ACarrierChangesWithAKeyFrame) {
  RelayedSite site;
  int asked = 0;
  site.hub.on_key_frame_request([&](std::string_view) { ++asked; });
  const auto publish = [&](bool key_frame) {
    site.hub.publish({wire::kCameraDepth, site.clock.now(), std::make_shared<const std::string>("d"), 0, key_frame});
  };
  ASSERT_TRUE(site.run_until([&] { return site.client.connected(); }));
  publish(true);
  publish(false);
  asked = 0;
  ASSERT_TRUE(site.up());
  EXPECT_EQ(asked, 1);
  const std::size_t before = site.client.messages.size();
  publish(false);
  site.io.run_for(200ms);
  EXPECT_EQ(site.client.messages.size(), before) << "it depends on a frame that another carrier brought";
  publish(true);
  publish(false);
  EXPECT_TRUE(site.run_until([&] { return site.client.messages.size() == before + 2; }));
}

TEST(DatagramSite, AClientThatReconnectsGetsImagesByDatagramAgain) {
  RelayedSite site;
  KeyedClient direct(site, site.ring.key("bea", Role::Viewer));
  ASSERT_TRUE(site.run_until([&] { return direct.link.datagrams() == DatagramPhase::Up; }));
  const std::uint16_t port = site.listener->port();
  site.listener->close("restart");
  ASSERT_TRUE(site.run_until([&] { return direct.link.datagrams() == DatagramPhase::Off; }));
  site.listener.reset();
  auto made = hub::PeerListener::listen(site.io, site.hub, site.clock, {.port = port, .access = site.access});
  ASSERT_TRUE(made.ok());
  site.listener = std::move(made).value();
  EXPECT_TRUE(site.run_until([&] { return direct.link.datagrams() == DatagramPhase::Up; }, 10s));
}

TEST(DatagramSite, WithTheUdpPortTakenTheServerServesOverTcpAndSaysWhy) {
  Site site;
  boost::asio::ip::tcp::acceptor any(site.io, {boost::asio::ip::make_address("127.0.0.1"), 0});
  const std::uint16_t port = any.local_endpoint().port();
  any.close();
  boost::asio::ip::udp::socket other(site.io, {boost::asio::ip::make_address("127.0.0.1"), port});
  site.listener = site.listen(port);
  EXPECT_NE(site.notes.back().find("UDP port " + std::to_string(port) + " cannot be opened"), std::string::npos);
  Client client(site, {"/camera/*"}, "test", 0, "viewer", true);
  ASSERT_TRUE(site.run_until([&] { return client.connected(); }));
  site.hub.publish(message(wire::kCameraDepth, "depth"));
  EXPECT_TRUE(site.run_until([&] { return !client.messages.empty(); }));
}

TEST(DatagramSite, AServerThatOffersTwiceIsLeft) {
  Site site;
  boost::asio::ip::tcp::acceptor acceptor(site.io, {boost::asio::ip::make_address("127.0.0.1"), 0});
  Client client(site, {}, "test", acceptor.local_endpoint().port(), "viewer", true);
  boost::asio::ip::tcp::socket socket(site.io);
  acceptor.async_accept(socket, [&](const boost::system::error_code& failed) {
    if (failed) return;
    msg::Control hello;
    hello.mutable_hello()->set_protocol(wire::kProtocolVersion);
    msg::Control offer;
    offer.mutable_datagram_offer()->set_session(1);
    boost::asio::write(socket, boost::asio::buffer(control_frame(hello) + control_frame(offer) + control_frame(offer)));
  });
  ASSERT_TRUE(site.run_until([&] {
    return std::any_of(client.details.begin(), client.details.end(), [](const std::string& detail) {
      return detail.find("offers datagrams twice") != std::string::npos;
    });
  }));
}

}  // namespace
}  // namespace telepalp::server
