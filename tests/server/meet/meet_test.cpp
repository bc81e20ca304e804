// The meeting point with real sites and real callers, on one io_context and loopback.
#include "server/meet/meet.h"

#include <gtest/gtest.h>

#include <boost/asio/read.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/write.hpp>

#include "server/meet/relay/relay_credentials.h"
#include "server/meet/site/meet_dialer.h"
#include "server/meet/words/meet_frames.h"
#include "tests/server/keyed_site.h"

namespace telepalp::server {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

/// A meeting point, and a site that is reached through it alone.
struct MetSite : KeyedSite {
  std::vector<std::string> log;  // of the meeting point
  std::vector<std::string> site_log;
  meet::RelayDoor relay;
  std::unique_ptr<meet::Meet> meeting = meet_at(0);
  std::unique_ptr<meet::MeetDialer> dialer;
  bool takes = true;
  std::size_t browsers = 0;

  std::unique_ptr<meet::Meet> meet_at(
      std::uint16_t port, meet::Meet::Limits limits = {},
      keys::IsRevoked is_revoked = [](const keys::Identity&) { return false; }) {
    auto made = meet::Meet::listen(io, {.address = "127.0.0.1",
                                        .port = port,
                                        .key = *host_key("meet", {"127.0.0.1", "meet.example"}),
                                        .is_revoked = std::move(is_revoked),
                                        .relay = relay,
                                        .log = [this](const std::string& text) { log.push_back(text); },
                                        .limits = limits});
    EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
    return std::move(made).value();
  }
  std::shared_ptr<const keys::KeyFile> host_key(const std::string& name, const std::vector<std::string>& hosts) const {
    return KeyRing::read(
        ring.authority.server_key({.name = name, .now = ring.now, .valid = std::chrono::days(1)}, hosts));
  }
  std::unique_ptr<meet::MeetDialer> dial(const std::vector<std::string>& names) {
    auto started = meet::MeetDialer::start(io, {.host = "127.0.0.1",
                                                .port = meeting->port(),
                                                .key = host_key(names.front(), names),
                                                .on_caller =
                                                    [this](tcp::socket socket, const meet::MeetDialer::Caller& caller) {
                                                      browsers += caller.is_browser ? 1 : 0;
                                                      listener->admit(std::move(socket));
                                                    },
                                                .takes = [this](const meet::MeetDialer::Caller&) { return takes; },
                                                .log = [this](const std::string& text) { site_log.push_back(text); }});
    EXPECT_TRUE(started.ok());
    return std::move(started).value();
  }
  bool site_says(const std::string& words) const {
    return std::ranges::any_of(site_log,
                               [&](const std::string& line) { return line.find(words) != std::string::npos; });
  }
};

/// A doctor's program that knows the site's name, and the meeting point's address.
struct Caller {
  std::vector<wire::Message> messages;
  std::vector<std::string> details;
  wire::ClientLink link;

  Caller(MetSite& met, std::string site, std::shared_ptr<const keys::KeyFile> key)
      : link(met.io,
             {.host = "127.0.0.1",
              .port = met.meeting->port(),
              .site = std::move(site),
              .name = "test",
              .role = "doctor",
              .key = std::move(key),
              .subscribes = {"*"}},
             {.on_message = [this](const wire::Message& message) { messages.push_back(message); },
              .on_state = [this](wire::LinkState, const std::string& detail) { details.push_back(detail); }}) {
    link.start();
  }
  [[nodiscard]] bool connected() const { return link.state() == wire::LinkState::Connected; }
};

/// The site's server has the key of the name `ward3`.
struct Meeting : testing::Test {
  MetSite met;
  void SetUp() override {
    met.listener.reset();  // the audit log is locked while the one before it lives
    met.access.reset();
    auto opened = access::Access::with_key(
        {.key = met.ring.server_key(met.ring.now, {"ward3", "ward3.example"}), .revoked = {}, .audit = {}, .say = {}});
    ASSERT_TRUE(opened.ok());
    met.access = std::move(opened).value();
    auto made = hub::PeerListener::listen(met.io, met.hub, met.clock, {.port = 0, .access = met.access});
    ASSERT_TRUE(made.ok());
    met.listener = std::move(made).value();
  }
  void join(const std::vector<std::string>& names = {"ward3", "ward3.example"}) {
    met.dialer = met.dial(names);
    ASSERT_TRUE(met.run_until([this] { return met.dialer->has_joined(); }));
  }
};

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
  met.relay = {.address = "127.0.0.1", .port = 3478, .secret = "0123456789abcdef"};
  met.dialer.reset();
  met.meeting.reset();
  met.meeting = met.meet_at(0);
  join();
  ASSERT_TRUE(met.run_until([this] { return !met.dialer->relays().empty(); }));
  const msg::IceRelay told = met.dialer->relays().front();
  EXPECT_EQ(told.address(), "127.0.0.1");
  EXPECT_EQ(told.port(), 3478U);
  EXPECT_EQ(told.tcp_port(), met.meeting->port());
  EXPECT_EQ(told.password().size(), 28U) << "20 bytes in Base64";
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
