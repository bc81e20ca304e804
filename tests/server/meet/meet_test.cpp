// The meeting point with real sites and real callers, on one io_context and loopback.
#include <gtest/gtest.h>

#include <boost/asio/read.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/write.hpp>

#include "server/meet/relay/relay_credentials.h"
#include "server/meet/words/meet_frames.h"
#include "tests/server/meet/greeting.h"
#include "tests/server/meet/met_site.h"

namespace telepalp::server {
namespace {

TEST_F(Meeting, JoinsADoctorWithTheSiteThatHeNames) {
  join();
  EXPECT_TRUE(
      met.site_says("joined the meeting point 127.0.0.1: callers reach this site by the name ward3, ward3.example"));
  Caller anna(met, "ward3", met.ring.key("anna", keys::Role::Doctor));
  ASSERT_TRUE(met.run_until([&] { return anna.connected(); }));
  met.hub.publish(message(wire::kClock, "through the meeting point"));
  EXPECT_TRUE(met.run_until([&] { return !anna.messages.empty(); }));
  EXPECT_EQ(met.meeting->streams(), 1U);
  EXPECT_NE(met.ring.audit().find("doctor anna"), std::string::npos) << "the site itself has checked her key";
  anna.link.stop();
  EXPECT_TRUE(met.run_until([&] { return met.meeting->streams() == 0; }));
}

TEST(Relay, CredentialsAreThoseThatTheRelayComputes) {
  const meet::RelayDoor door{.address = "192.0.2.1", .port = 3478, .secret = "0123456789abcdef"};
  const msg::MeetRelay made =
      meet::credentials(door, "ward3", 443, std::chrono::system_clock::time_point(std::chrono::seconds(1700000000)));
  EXPECT_EQ(made.user(), "1700003600:ward3");
  // printf 1700003600:ward3 | openssl dgst -sha1 -hmac 0123456789abcdef -binary | base64
  EXPECT_EQ(made.password(), "MPxn24AIDxI3PZjJFWu2/NsyGZ4=");
  EXPECT_EQ(made.tcp_port(), 443U);
}

TEST_F(Meeting, GivesAJoinedSiteCredentialsForItsRelay) {
  join();
  EXPECT_TRUE(met.dialer->relays().empty()) << "this meeting point has no relay";
  met.relay = {.address = "192.0.2.1", .port = 3478, .secret = "0123456789abcdef"};
  met.dialer.reset();
  met.meeting.reset();
  met.meeting = met.meet_at(0);
  join();
  ASSERT_TRUE(met.run_until([this] { return !met.dialer->relays().empty(); }));
  const msg::IceRelay told = met.dialer->relays().front();
  EXPECT_EQ(told.address(), "192.0.2.1");
  EXPECT_EQ(told.port(), 3478U);
  EXPECT_EQ(told.tcp_port(), met.meeting->port());
  EXPECT_EQ(told.password().size(), 28U) << "20 bytes in Base64";
}

TEST_F(Meeting, ASiteSaysOnceThatItsRelayIsAtAnAddressToWhichNothingIsSent) {
  met.relay = {.address = "127.0.1.1", .port = 3478, .secret = "0123456789abcdef"};
  met.meeting = met.meet_at(0);
  join();
  ASSERT_TRUE(met.run_until([this] { return met.site_says("relay: the relay's address is 127.0.1.1, a loopback"); }));
  EXPECT_TRUE(met.site_says("fix: on the meeting point's computer, name the relay by its public address"));
  EXPECT_TRUE(met.dialer->relays().empty());
  const std::uint16_t port = met.meeting->port();
  met.meeting.reset();
  ASSERT_TRUE(met.run_until([&] { return !met.dialer->has_joined(); }));
  met.meeting = met.meet_at(port);
  ASSERT_TRUE(met.run_until([&] { return met.dialer->has_joined(); }, 10s));
  EXPECT_FALSE(met.run_until([&] { return met.times_said("127.0.1.1") > 1; }, 300ms));
}

TEST(Relay, IsRefusedAtAnAddressWhereNoSiteReachesIt) {
  const support::TemporaryFolder folder;
  const std::filesystem::path secret = folder.path() / "relay.secret";
  std::ofstream(secret) << "0123456789abcdef\n";
  for (const char* const host : {"127.0.1.1", "localhost", "0.0.0.0", "169.254.1.1", "224.0.0.1", "::1"}) {
    const auto door = meet::relay_door(host, 3478, secret);
    ASSERT_FALSE(door.ok()) << host;
    EXPECT_NE(to_string(door.error()).find("at which no site reaches it"), std::string::npos)
        << to_string(door.error());
  }
  EXPECT_TRUE(meet::relay_door("192.0.2.1", 3478, secret).ok());
}

/// The first bytes of a TURN client, and all that follow, reach the relay as they are; its answer comes back.
TEST_F(Meeting, PassesRequestsForTheRelayOnAndClosesThemWithoutOne) {
  const std::string request = {0, 3, 0, 0, 0x21, 0x12, '\xA4', 0x42, 'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h', 'i', 'j'};
  tcp::acceptor relay(met.io, {asio::ip::address_v4::loopback(), 0});
  tcp::socket at_relay(met.io), caller(met.io), other(met.io);
  std::string read(request.size(), ' ');
  bool arrived = false;
  relay.async_accept(at_relay, [&](const boost::system::error_code& failed) {
    ASSERT_FALSE(failed);
    asio::async_read(at_relay, asio::buffer(read), [&](const boost::system::error_code& cut, std::size_t) {
      arrived = !cut;
      asio::write(at_relay, asio::buffer("answer", 6));
    });
  });
  other.connect({asio::ip::address_v4::loopback(), met.meeting->port()});
  asio::write(other, asio::buffer(request));
  EXPECT_TRUE(met.run_until([&] { return met.meeting->counts().refused == 1; })) << "this meeting point has no relay";

  met.relay = {.address = "127.0.0.1", .port = relay.local_endpoint().port(), .secret = "0123456789abcdef"};
  met.meeting = met.meet_at(0);
  caller.connect({asio::ip::address_v4::loopback(), met.meeting->port()});
  asio::write(caller, asio::buffer(request.substr(0, 3)));
  EXPECT_FALSE(met.run_until([&] { return arrived; }, 100ms)) << "three bytes show nothing yet";
  asio::write(caller, asio::buffer(request.substr(3)));
  ASSERT_TRUE(met.run_until([&] { return arrived; }));
  EXPECT_EQ(read, request);
  std::string answer(6, ' ');
  bool answered = false;
  asio::async_read(caller, asio::buffer(answer),
                   [&](const boost::system::error_code& cut, std::size_t) { answered = !cut; });
  EXPECT_TRUE(met.run_until([&] { return answered; }));
  EXPECT_EQ(answer, "answer");
}

TEST_F(Meeting, CannotLeadADoctorToAnotherSite) {
  join({"ward4", "ward3.example"});  // it holds the name, but the server behind it has another key
  Caller anna(met, "ward4", met.ring.key("anna", keys::Role::Doctor));
  EXPECT_TRUE(met.run_until([&] { return anna.link.state() == wire::LinkState::Refused; }));
  EXPECT_NE(to_string(anna.link.refusal()).find("not for the host ward4"), std::string::npos)
      << to_string(anna.link.refusal());
}

TEST_F(Meeting, TellsACallerThatASiteIsNotThereAndGoesOnWhenItComes) {
  Caller anna(met, "ward3", met.ring.key("anna", keys::Role::Doctor));
  ASSERT_TRUE(met.run_until([&] { return met.meeting->counts().refused > 0; }));
  ASSERT_TRUE(met.run_until([&] { return anna.details.size() > 1; }));
  EXPECT_NE(anna.details.at(1).find("unrecognized name"), std::string::npos) << anna.details.at(1);
  join();
  EXPECT_TRUE(met.run_until([&] { return anna.connected(); }, 10s));
}

TEST_F(Meeting, SendsABrowserToTheWebPageAndDeclinesWhatTheSiteDoesNotTake) {
  join();
  met.takes = false;
  Caller anna(met, "ward3", met.ring.key("anna", keys::Role::Doctor));
  EXPECT_TRUE(met.run_until([&] { return met.meeting->counts().refused > 0; })) << "at once, not after 5 s";
  met.takes = true;
  EXPECT_TRUE(met.run_until([&] { return anna.connected(); }, 10s));
  EXPECT_EQ(met.browsers, 0U);
}

TEST_F(Meeting, TakesTwoSitesWhoseKeysBothNameLocalhost) {
  join({"ward3", "localhost", "127.0.0.1"});
  const auto other = met.dial({"ward4", "localhost", "127.0.0.1"});
  EXPECT_TRUE(met.run_until([&] { return other->has_joined(); }));
  EXPECT_EQ(met.meeting->sites(), 2U);
}

TEST_F(Meeting, GivesANameToOneKeyAndTheSameKeyAgain) {
  join();
  const auto squatter = met.dial({"ward3"});
  EXPECT_TRUE(met.run_until([&] { return met.site_says("another key holds the name ward3 here"); }));
  EXPECT_FALSE(squatter->has_joined());
  EXPECT_TRUE(met.dialer->has_joined());
  EXPECT_EQ(met.meeting->sites(), 1U);
}

TEST_F(Meeting, TakesASiteBackAfterItsOwnRestart) {
  join();
  Caller anna(met, "ward3", met.ring.key("anna", keys::Role::Doctor));
  ASSERT_TRUE(met.run_until([&] { return anna.connected(); }));
  const std::uint16_t port = met.meeting->port();
  met.meeting.reset();
  EXPECT_TRUE(met.run_until([&] { return !met.dialer->has_joined(); }));
  met.meeting = met.meet_at(port);
  EXPECT_TRUE(met.run_until([&] { return met.dialer->has_joined(); }, 10s));
  EXPECT_TRUE(met.run_until([&] { return met.meeting->sites() == 1; }));
}

TEST_F(Meeting, JoinsACallerAgainAtOnceWithASiteWhoseAddressHasChanged) {
  join();
  Caller anna(met, "ward3", met.ring.key("anna", keys::Role::Doctor));
  ASSERT_TRUE(met.run_until([&] { return anna.connected(); }));
  met.has_address = false;
  ASSERT_TRUE(met.run_until([&] { return !met.dialer->has_joined(); }, 1s)) << "without waiting for silence";
  met.has_address = true;
  ASSERT_TRUE(met.run_until([&] { return anna.link.counts().connections == 2; }, 2s));
  EXPECT_TRUE(met.site_says("this computer's address has changed"));
  EXPECT_TRUE(std::ranges::any_of(
      met.log, [](const std::string& line) { return line.find("has changed: 1 stream ends") != std::string::npos; }));
  EXPECT_TRUE(met.run_until([&] { return met.meeting->streams() == 1; })) << "the old one has ended";
  met.hub.publish(message(wire::kClock, "after the change"));
  EXPECT_TRUE(
      met.run_until([&] { return !anna.messages.empty() && anna.messages.back().topic.name == wire::kClock.name; }));
}

TEST_F(Meeting, KeepsTheStreamsOfASiteThatComesAgainFromTheSameAddress) {
  const auto key = met.host_key("ward3", {"ward3"});
  met.dialer = met.dial_with(key);
  ASSERT_TRUE(met.run_until([this] { return met.dialer->has_joined(); }));
  Caller anna(met, "ward3", met.ring.key("anna", keys::Role::Doctor));
  ASSERT_TRUE(met.run_until([&] { return anna.connected(); }));
  met.dialer = met.dial_with(key);
  ASSERT_TRUE(met.run_until([this] { return met.dialer->has_joined(); }));
  EXPECT_FALSE(met.run_until([&] { return anna.link.counts().connections > 1 || !anna.connected(); }, 500ms));
  EXPECT_EQ(met.meeting->streams(), 1U);
}

TEST_F(Meeting, TakesNoSiteWithARevokedKeyOrOfAnotherAuthority) {
  met.meeting = met.meet_at(0, {}, [](const keys::Identity&) { return true; });
  met.dialer = met.dial({"ward3"});
  EXPECT_TRUE(met.run_until([&] { return met.site_says("no connection with the meeting point"); }));
  EXPECT_FALSE(met.run_until([&] { return met.dialer->has_joined(); }, 1s));

  met.meeting = met.meet_at(0);
  KeyRing strangers;
  const auto key = KeyRing::read(strangers.authority.server_key(
      {.name = "ward3", .now = strangers.now, .valid = std::chrono::days(1)}, {"ward3"}));
  auto stranger = meet::MeetDialer::start(
      met.io, {.host = "127.0.0.1", .port = met.meeting->port(), .key = key, .on_caller = [](auto, auto&) {}});
  EXPECT_FALSE(met.run_until([&] { return (*stranger)->has_joined(); }, 1s));
  EXPECT_EQ(met.meeting->sites(), 0U);
}

TEST_F(Meeting, TakesNoPersonsKeyForASite) {
  const auto key = met.ring.key("anna", keys::Role::Doctor);
  auto person = meet::MeetDialer::start(
      met.io, {.host = "127.0.0.1", .port = met.meeting->port(), .key = key, .on_caller = [](auto, auto&) {}});
  ASSERT_TRUE(person.ok());
  EXPECT_FALSE(met.run_until([&] { return (*person)->has_joined(); }, 1s));
}

TEST_F(Meeting, LetsASiteAndADoctorInWhileStrangersHoldEachPlace) {
  met.meeting = met.meet_at(0, {.arrivals = 16});
  std::vector<tcp::socket> silent;
  for (int i = 0; i < 64; ++i) {
    tcp::socket& one = silent.emplace_back(met.io);
    one.open(tcp::v4());
    one.bind({asio::ip::make_address("127.0.0.2"), 0});
    one.connect({asio::ip::make_address("127.0.0.1"), met.meeting->port()});
    met.io.poll();
  }
  join();
  Caller anna(met, "ward3", met.ring.key("anna", keys::Role::Doctor));
  EXPECT_TRUE(met.run_until([&] { return anna.connected(); }));
}

/// Strangers whom the site has not thrown out yet.
TEST_F(Meeting, LetsADoctorInWhileStrangersHoldEachStreamOfTheSite) {
  met.meeting = met.meet_at(0, {.calls = {.waiting_per_site = 8, .streams_per_site = 16}});
  join();
  const std::string hello = meet::greeting("ward3");
  std::vector<tcp::socket> silent;
  for (int i = 0; i < 16; ++i) {
    tcp::socket& one = silent.emplace_back(met.io);
    one.open(tcp::v4());
    one.bind({asio::ip::make_address("127.0.0.2"), 0});
    one.connect({asio::ip::make_address("127.0.0.1"), met.meeting->port()});
    asio::write(one, asio::buffer(hello));
    ASSERT_TRUE(met.run_until([&] { return met.meeting->streams() == silent.size(); }));
  }
  Caller anna(met, "ward3", met.ring.key("anna", keys::Role::Doctor));
  EXPECT_TRUE(met.run_until([&] { return anna.connected(); }, 2s)) << "a stranger has lost its place";
  EXPECT_LE(met.meeting->streams(), 17U);
}

TEST_F(Meeting, RefusesACallerRatherThanADoctorWhoHasBeenLetIn) {
  met.meeting = met.meet_at(0, {.calls = {.streams_per_site = 1}});
  join();
  Caller anna(met, "ward3", met.ring.key("anna", keys::Role::Doctor));
  ASSERT_TRUE(met.run_until([&] { return anna.connected(); }));
  EXPECT_FALSE(met.run_until([&] { return !anna.connected(); }, 7500ms)) << "until she is no stranger any more";
  Caller bert(met, "ward3", met.ring.key("bert", keys::Role::Doctor), "viewer");
  ASSERT_TRUE(met.run_until([&] { return met.meeting->counts().refused > 0; }));
  EXPECT_TRUE(anna.connected());
  EXPECT_EQ(anna.link.counts().connections, 1U);
}

TEST_F(Meeting, SaysOnceThatTheMeetingPointCannotBeReached) {
  join();
  met.meeting.reset();
  EXPECT_FALSE(met.run_until([&] { return met.times_said("no connection with the meeting point") > 2; }, 4s))
      << "the end of the connection, and why it cannot be made again; not each of four attempts";
  EXPECT_TRUE(met.site_says("; this server tries again"));
}

TEST_F(Meeting, JoinsNobodyWithAGuessedToken) {
  join();
  tcp::socket guess(met.io);
  guess.connect({asio::ip::make_address("127.0.0.1"), met.meeting->port()});
  asio::write(guess, asio::buffer(std::string(meet::kAnswer) + std::string(meet::kTokenBytes, 'x')));
  bool ended = false;
  char byte = 0;
  guess.async_read_some(asio::buffer(&byte, 1),
                        [&](const boost::system::error_code& failed, std::size_t) { ended = failed.failed(); });
  EXPECT_TRUE(met.run_until([&] { return ended; }));
  EXPECT_EQ(met.meeting->streams(), 0U);
}

TEST_F(Meeting, EndsASiteThatSendsWhatIsNoMessage) {
  const auto key = met.host_key("ward3", {"ward3"});
  const wire::TlsSettings tls = std::move(wire::tls_settings(keys::client_context(*key))).value();
  for (const std::string& words : {std::string("\xff\xff", 2), std::string("\x03\x00\x99\x99\x99", 5)}) {
    asio::ssl::stream<tcp::socket> site(met.io, *tls);
    site.next_layer().connect({asio::ip::make_address("127.0.0.1"), met.meeting->port()});
    bool sent = false, ended = false;
    char byte = 0;
    site.async_handshake(asio::ssl::stream_base::client, [&](const boost::system::error_code& failed) {
      ASSERT_FALSE(failed.failed()) << failed.message();
      asio::async_write(site, asio::buffer(words), [&](const boost::system::error_code&, std::size_t) { sent = true; });
      site.async_read_some(asio::buffer(&byte, 1),
                           [&](const boost::system::error_code& gone, std::size_t) { ended = gone.failed(); });
    });
    EXPECT_TRUE(met.run_until([&] { return sent && ended; }, 3s));
  }
  EXPECT_EQ(met.meeting->sites(), 0U);
}

}  // namespace
}  // namespace telepalp::server
