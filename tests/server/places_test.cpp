// Acceptance and disconnection of peers by a full server, over real sockets.

#include <gtest/gtest.h>

#include "tests/server/loopback_site.h"

namespace telepalp::server {
namespace {

using Clients = std::vector<std::unique_ptr<Client>>;

Clients join(Site& site, std::size_t count, const std::vector<std::string>& topics, const std::string& role) {
  Clients clients;
  for (std::size_t number = 0; number < count; ++number)
    clients.push_back(std::make_unique<Client>(site, topics, role + std::to_string(number), 0, role));
  return clients;
}

std::size_t connected(const Clients& clients) {
  return static_cast<std::size_t>(
      std::count_if(clients.begin(), clients.end(), [](const auto& client) { return client->connected(); }));
}

bool any_contains(const std::vector<std::string>& texts, const std::string& part) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

TEST(Places, SixtyFourViewersLeaveRoomForTheDoctorAndTheRecorderAndTheNextViewerGetsAReason) {
  Site site;
  const Clients viewers = join(site, 64, {"/clock"}, "viewer");
  ASSERT_TRUE(site.run_until([&] { return connected(viewers) == 48 && site.listener->counts().refused >= 16; }));
  Client doctor(site, {"/camera/*"}, "station", 0, "doctor");
  Client recorder(site, {"*"}, "telepalp-record", 0, "recorder");
  EXPECT_TRUE(site.run_until([&] { return doctor.connected() && recorder.connected(); }));
  std::size_t refused = 0;
  for (const auto& viewer : viewers)
    if (any_contains(viewer->details, "the server is full: all 48 places for viewers are taken. fix: ")) ++refused;
  EXPECT_EQ(refused, 16u);
  EXPECT_TRUE(any_contains(site.notes, "is refused: the server is full: all 48 places for viewers"));
  EXPECT_LE(std::count_if(site.notes.begin(), site.notes.end(),
                          [](const std::string& note) { return note.find("is refused") != std::string::npos; }),
            2)
      << "a flood does not fill the log";
}

TEST(Places, APlaceThatIsLeftIsGivenToWhoAsksAgain) {
  Site site;
  site.listener = site.listen(0, {.viewers = 1});
  auto first = std::make_unique<Client>(site, std::vector<std::string>{"/clock"}, "first");
  ASSERT_TRUE(site.run_until([&] { return first->connected(); }));
  Client second(site, {"/clock"}, "second");
  ASSERT_TRUE(site.run_until([&] { return site.listener->counts().refused > 0; }));
  first.reset();
  EXPECT_TRUE(site.run_until([&] { return second.connected(); }));
}

TEST(Places, APeerWithoutTopicsIsDisconnectedWithinSecondsAndOthersAreKept) {
  Site site;
  site.listener = site.listen(0, {}, {.without_topics = 500ms, .silent = 60s});
  wire::ClientLink idle(site.io, {.port = site.listener->port(), .name = "idle"}, {});
  idle.start();
  Client subscriber(site, {"/clock"}, "subscriber");
  Client publisher(site, {}, "publisher");  // advertises the station's topics
  ASSERT_TRUE(site.run_until([&] { return site.listener->counts().let_go_idle > 0; }, 4s));
  EXPECT_TRUE(site.run_until(
      [&] { return any_contains(site.notes, "this client subscribes to no topic and publishes nothing"); }));
  EXPECT_EQ(subscriber.link.counts().connections, 1u);
  EXPECT_EQ(publisher.link.counts().connections, 1u);
}

TEST(Places, ASilentPublisherIsDisconnected) {
  Site site;
  site.listener = site.listen(0, {}, {.without_topics = 100ms, .silent = 500ms});
  Client silent(site, {}, "silent");
  EXPECT_TRUE(site.run_until([&] { return site.listener->counts().let_go_idle > 0; }, 4s));
}

TEST(Places, ConnectionsThatNeverGreetDoNotKeepOutAPeerThatDoes) {
  Site site;
  site.listener = site.listen(0, {.strangers = 32});
  std::vector<std::unique_ptr<boost::asio::ip::tcp::socket>> mute;
  for (int number = 0; number < 64; ++number) {
    mute.push_back(std::make_unique<boost::asio::ip::tcp::socket>(site.io));
    mute.back()->connect({boost::asio::ip::make_address("127.0.0.1"), site.listener->port()});
  }
  ASSERT_TRUE(site.run_until([&] { return site.listener->counts().accepted == 64; }));
  EXPECT_LE(site.listener->peers(), 32u);
  Client doctor(site, {"/camera/*"}, "station", 0, "doctor");
  EXPECT_TRUE(site.run_until([&] { return doctor.connected(); }, 2s));
}

using Socket = boost::asio::ip::tcp::socket;

/// A connection from the local address `from` to `port`, which sends nothing.
std::unique_ptr<Socket> silent_from(const std::string& from, boost::asio::io_context& io, std::uint16_t port) {
  auto socket = std::make_unique<Socket>(io);
  socket->open(boost::asio::ip::tcp::v4());
  socket->bind({boost::asio::ip::make_address(from), 0});
  socket->connect({boost::asio::ip::make_address("127.0.0.1"), port});
  return socket;
}

bool is_closed(Socket& socket) {
  socket.non_blocking(true);
  std::array<char, 4096> bytes{};
  boost::system::error_code failed;
  while (!failed) socket.read_some(boost::asio::buffer(bytes), failed);
  return failed != boost::asio::error::would_block;
}

TEST(Places, ManySilentConnectionsFromOneNetworkLoseTheirOwnPlacesAndNobodyElses) {
  Site site;
  site.listener = site.listen(0, {.strangers = 8});
  boost::asio::io_context io;
  const auto slow = silent_from("127.0.9.1", io, site.listener->port());  // a program on a slow path, before its Hello
  std::vector<std::unique_ptr<Socket>> flood;
  for (int number = 0; number < 200; ++number) {
    flood.push_back(silent_from("127.0.2." + std::to_string(1 + number % 4), io, site.listener->port()));
    const auto accepted = static_cast<std::uint64_t>(number) + 2;
    ASSERT_TRUE(site.run_until([&] { return site.listener->counts().accepted == accepted; }));
  }
  EXPECT_LE(site.listener->peers(), 8u);
  EXPECT_FALSE(is_closed(*slow));
}

TEST(UpstreamRate, AFloodOfEventsIsHeldToItsRateAndTheStationsStateIsNot) {
  Site site;
  Client viewer(site, {"/station/*"}, "viewer");
  Client station(site, {}, "station", 0, "doctor");
  ASSERT_TRUE(site.run_until([&] { return viewer.connected() && station.connected(); }));
  msg::StationEvent event;
  event.set_text(std::string(8192, 'e'));
  std::size_t sent = 0;
  for (int round = 0; round < 200; ++round) {  // 2 s of 0.8 MB/s
    station.link.publish(wire::make_message(wire::kStationEvents, session_time(1), event));
    sent += 8192;
    station.link.publish(station_state(round));
    site.run_until([] { return false; }, 10ms);
  }
  std::size_t event_bytes = 0;
  std::size_t states = 0;
  for (const wire::Message& one : viewer.messages) {
    if (one.topic.name == wire::kStationEvents.name) event_bytes += one.payload->size();
    if (one.topic.name == wire::kStationState.name) ++states;
  }
  EXPECT_GT(sent, std::size_t{1'500'000});
  EXPECT_LT(event_bytes, std::size_t{(256 + 64 * 5) << 10});  // the burst, plus the rate over a slow machine's run time
  EXPECT_GE(states, 199u);
  EXPECT_GT(site.listener->counts().over_rate, 0u);
  EXPECT_TRUE(any_contains(site.notes, "publishes /station/events faster than 50 messages or 64 KiB a second"));
}

}  // namespace
}  // namespace telepalp::server
