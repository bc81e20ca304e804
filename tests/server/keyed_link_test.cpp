// A server with keys, over real sockets: who enters, who is refused, and what each is told.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <random>
#include <sstream>

#include "tests/server/delay_relay.h"
#include "tests/server/keyed_site.h"

namespace telepalp::server {
namespace {

using boost::asio::ip::tcp;
using keys::Role;

std::string place_of(keys::Operation operation) {
  return operation == keys::Operation::Touch ? "doctor" : operation == keys::Operation::Record ? "recorder" : "viewer";
}

void expect_refused(Site& site, const KeyedClient& client, const std::string& what, const std::string& fix) {
  ASSERT_TRUE(site.run_until([&] { return client.refused() || client.connected(); })) << what;
  ASSERT_TRUE(client.refused()) << what;
  EXPECT_NE(client.link.refusal().what.find(what), std::string::npos) << to_string(client.link.refusal());
  EXPECT_NE(client.link.refusal().fix.find(fix), std::string::npos) << to_string(client.link.refusal());
  EXPECT_TRUE(client.messages.empty());
  EXPECT_EQ(client.link.counts().connections, 0u);
}

TEST(KeyedLink, EachRoleMayDoWhatTheTableSaysAndNothingElse) {
  for (const Role role : {Role::Technician, Role::Doctor, Role::Viewer, Role::Qa})
    for (const auto operation : {keys::Operation::Watch, keys::Operation::Touch, keys::Operation::Record})
      for (const bool as_token : {false, true}) {
        KeyedSite site;
        KeyedClient client(site, as_token ? site.ring.token("p", role) : site.ring.key("p", role), place_of(operation));
        site.run_until([&] { return client.refused() || client.connected(); });
        EXPECT_EQ(client.connected(), keys::allows(role, operation)) << name(role) << " " << name(operation);
        EXPECT_EQ(client.refused(), !keys::allows(role, operation)) << name(role) << " " << name(operation);
      }
}

TEST(KeyedLink, ADeniedRoleIsToldWhichAndTheAuditLogNamesIt) {
  KeyedSite site;
  KeyedClient vera(site, site.ring.key("vera", Role::Viewer), "doctor");
  expect_refused(site, vera, "the role viewer of vera does not allow to touch", "use a key whose role allows it");
  EXPECT_NE(site.ring.audit().find("event=refused who=viewer vera"), std::string::npos) << site.ring.audit();
}

TEST(KeyedLink, AViewerThatPublishesAHapticCommandIsDenied) {
  KeyedSite site;
  KeyedClient vera(site, site.ring.key("vera", Role::Viewer), "viewer", {wire::kStationState});
  site.run_until([&] { return site.access->counts().refused > 0; });
  EXPECT_NE(site.ring.audit().find("may not publish /station/state"), std::string::npos) << site.ring.audit();
}

TEST(KeyedLink, AKeyOfAnotherAuthorityIsRefusedAtBothEnds) {
  KeyedSite site;
  const KeyRing other;
  KeyedClient stranger(site, other.key("eve", Role::Doctor), "doctor");
  expect_refused(site, stranger, "the server is not of the authority site that made this key", "who answers");
  auto forged = std::make_shared<keys::KeyFile>(*other.key("eve", Role::Doctor));
  forged->authority = site.ring.authority.certificate();  // a client that takes any server
  KeyedClient eve(site, forged, "doctor");
  expect_refused(site, eve, "the server refuses this key: another authority made it", "telepalp-keys client");
}

TEST(KeyedLink, ATokenOfAnotherAuthorityIsRefused) {
  KeyedSite site;
  const KeyRing other;
  auto forged = std::make_shared<keys::KeyFile>(*other.token("eve", Role::Doctor));
  forged->authority = site.ring.authority.certificate();
  KeyedClient eve(site, forged, "doctor");
  expect_refused(site, eve, "this is no token of the server's authority", "telepalp-keys token");
}

TEST(KeyedLink, AnExpiredKeyIsRefused) {
  KeyedSite site;
  KeyedClient late(site, site.ring.key("anna", Role::Doctor, site.ring.now - std::chrono::days(3)), "doctor");
  expect_refused(site, late, "it has expired", "telepalp-keys renew");
}

TEST(KeyedLink, AKeyRevokedBeforeIsRefusedAndOneRevokedMeanwhileEndsTheSession) {
  KeyedSite site;
  const auto anna = site.ring.key("anna", Role::Doctor);
  KeyedClient station(site, anna, "doctor");
  ASSERT_TRUE(site.run_until([&] { return station.connected(); }));
  site.ring.revoke(anna->identity.serial);
  ASSERT_TRUE(site.run_until([&] { return station.refused(); }, 4s));
  EXPECT_NE(station.link.refusal().what.find("revoked"), std::string::npos) << to_string(station.link.refusal());
  KeyedClient again(site, anna, "doctor");
  expect_refused(site, again, "it is revoked", "telepalp-keys client");
}

TEST(KeyedLink, AKeyThatExpiresMeanwhileEndsTheSessionAndFreesTheTouch) {
  KeyedSite site;
  const keys::WallTime made = site.ring.now - std::chrono::days(1) + 6s;  // a key holds for a day
  KeyedClient anna(site, site.ring.key("anna", Role::Doctor, made), "doctor", {wire::kStationState});
  ASSERT_TRUE(site.run_until([&] { return anna.connected(); }));
  ASSERT_TRUE(site.run_until([&] { return anna.refused(); }, 20s));
  EXPECT_NE(anna.link.refusal().what.find("expired"), std::string::npos) << to_string(anna.link.refusal());
  KeyedClient bert(site, site.ring.key("bert", Role::Doctor), "doctor", {wire::kStationState});
  EXPECT_TRUE(site.run_until([&] { return bert.connected(); }, 20s)) << site.ring.audit();
}

TEST(KeyedLink, APlainClientIsToldToGiveAKey) {
  KeyedSite site;
  KeyedClient plain(site, nullptr, "doctor");
  expect_refused(site, plain, "this server accepts only TLS connections with a key", "give --key FILE");
}

TEST(KeyedLink, AKeyIsNotDroppedForAServerWithoutTls) {
  Site site;
  const KeyRing ring;
  KeyedClient client(site, ring.key("anna", Role::Doctor), "doctor");
  expect_refused(site, client, "the server does not speak TLS", "leave out --key");
}

TEST(KeyedLink, AServerThatAnswersUnderAnotherNameIsRefused) {
  KeyedSite site;
  auto made = hub::PeerListener::listen(site.io, site.hub, site.clock, {.address = "127.0.0.2", .access = site.access});
  ASSERT_TRUE(made.ok());
  site.listener = std::move(made).value();
  KeyedClient client(site, site.ring.key("anna", Role::Doctor), "doctor", {}, "127.0.0.2");
  expect_refused(site, client, "the server's key is not for the host 127.0.0.2", "--host 127.0.0.2");
}

TEST(BadInput35, AServersExpiredKeyIsRefusedByTheServerItself) {
  const KeyRing ring;
  const auto opened = access::Access::with_key(
      {.key = ring.server_key(ring.now - std::chrono::days(3)), .revoked = {}, .audit = {}, .say = {}});
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().what.find("expired"), std::string::npos);
  EXPECT_NE(opened.error().fix.find("telepalp-keys renew"), std::string::npos);
}

TEST(KeyedLink, AKeyThatAnybodyMayReadIsRefused) {
  const KeyRing ring;
  const std::filesystem::path file = ring.server_key(ring.now);
  std::filesystem::permissions(file, std::filesystem::perms::others_read, std::filesystem::perm_options::add);
  const auto opened = access::Access::with_key({.key = file, .revoked = {}, .audit = {}, .say = {}});
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.error().fix, "chmod 600 " + file.string());
}

TEST(KeyedLink, OffThisMachineAServerNeedsAKey) {
  const auto without = hub::listening_address("0.0.0.0", false);
  ASSERT_FALSE(without.ok());
  EXPECT_NE(without.error().fix.find("telepalp-keys authority && telepalp-keys server --host"), std::string::npos);
  EXPECT_TRUE(hub::listening_address("0.0.0.0", true).ok());
  EXPECT_TRUE(hub::listening_address("127.0.0.1", false).ok());
}

TEST(KeyedLink, OneDoctorHoldsTheTouchAndTheNextOneWaitsUntilItIsGiven) {
  KeyedSite site;
  auto anna = std::make_unique<KeyedClient>(site, site.ring.key("anna", Role::Doctor), "doctor",
                                            std::vector<wire::Topic>{wire::kStationState});
  ASSERT_TRUE(site.run_until([&] { return anna->connected(); }));
  KeyedClient bert(site, site.ring.key("bert", Role::Doctor), "doctor", {wire::kStationState});
  site.run_until([&] { return site.access->counts().refused > 0; });
  EXPECT_FALSE(bert.connected());
  EXPECT_FALSE(bert.refused()) << "it is no matter of the key: the station waits";
  EXPECT_NE(site.ring.audit().find("doctor anna holds the touch"), std::string::npos) << site.ring.audit();
  anna->link.stop("the examination is over");
  EXPECT_TRUE(site.run_until([&] { return bert.connected(); }));
  EXPECT_NE(site.ring.audit().find("event=gave-touch who=doctor anna"), std::string::npos) << site.ring.audit();
  EXPECT_NE(site.ring.audit().find("event=took-touch who=doctor bert"), std::string::npos) << site.ring.audit();
}

/// anna's station, which holds the touch, and bert's, which waits for it.
struct TwoDoctors {
  KeyedSite site;
  std::unique_ptr<KeyedClient> anna, bert;
  TwoDoctors() {
    anna = std::make_unique<KeyedClient>(site, site.ring.key("anna", Role::Doctor), "doctor",
                                         std::vector<wire::Topic>{wire::kStationState});
    EXPECT_TRUE(site.run_until([&] { return anna->connected(); }));
    bert = std::make_unique<KeyedClient>(site, site.ring.key("bert", Role::Doctor), "doctor",
                                         std::vector<wire::Topic>{wire::kStationState});
    EXPECT_TRUE(site.run_until([&] { return said_to_bert("doctor anna holds the touch"); }));
  }
  [[nodiscard]] bool said_to_bert(const std::string& phrase) const {
    return std::any_of(bert->details.begin(), bert->details.end(),
                       [&](const std::string& detail) { return detail.find(phrase) != std::string::npos; });
  }
  /// The answer to anna's request.
  std::string hand_over(const std::string& to) {
    const std::size_t before = anna->hand_over_answers.size();
    EXPECT_TRUE(anna->link.hand_over(to));
    EXPECT_TRUE(site.run_until([&] { return anna->hand_over_answers.size() > before; }));
    return anna->hand_over_answers.back();
  }
};

TEST(HandOver, TheHolderOffersTheOtherAcceptsAndTheAuditLogHasBoth) {
  TwoDoctors two;
  EXPECT_EQ(two.hand_over("bert"), "done: offered to doctor bert for 60 s: you keep the touch until it is accepted");
  ASSERT_TRUE(two.site.run_until([&] { return two.said_to_bert("doctor anna offers you the touch"); }));
  EXPECT_TRUE(two.anna->connected()) << "an offer alone takes nothing away";
  EXPECT_FALSE(two.bert->connected());
  two.bert->link.accept_touch();
  ASSERT_TRUE(two.site.run_until([&] { return two.bert->connected(); }));
  ASSERT_TRUE(two.site.run_until([&] { return !two.anna->connected(); }));
  const std::string audit = two.site.ring.audit();
  for (const char* event : {"event=offered-touch who=doctor anna", "to=\"bert\"", "event=took-touch who=doctor bert",
                            "by=hand-over from=\"anna\"", "event=gave-touch who=doctor anna", "to=\"doctor bert\""})
    EXPECT_NE(audit.find(event), std::string::npos) << event << "\n" << audit;
  two.site.run_until([&] { return two.anna->connected(); }, 1500ms);
  EXPECT_FALSE(two.anna->connected()) << "anna waits while bert holds the touch";
  two.bert->link.stop("the examination is over");
  EXPECT_TRUE(two.site.run_until([&] { return two.anna->connected(); }));
}

TEST(HandOver, WhatIsNotOfferedToADoctorCannotBeAccepted) {
  TwoDoctors two;
  two.bert->link.accept_touch();
  two.site.run_until([&] { return two.bert->connected(); }, 2500ms);
  EXPECT_FALSE(two.bert->connected()) << "accepting alone takes nothing";
  EXPECT_EQ(two.hand_over("carla").rfind("done: ", 0), 0u);
  two.site.run_until([&] { return two.bert->connected(); }, 2500ms);
  EXPECT_FALSE(two.bert->connected()) << "it is offered to another doctor";
  EXPECT_TRUE(two.anna->connected());
}

TEST(HandOver, AWithdrawnOfferCannotBeAccepted) {
  TwoDoctors two;
  EXPECT_EQ(two.hand_over("bert").rfind("done: ", 0), 0u);
  EXPECT_EQ(two.hand_over("bert"), "refused: the last offer was made just now. fix: wait a second");
  two.site.run_until([] { return false; }, 600ms);
  EXPECT_EQ(two.hand_over(""), "done: the offer is withdrawn: you keep the touch");
  two.bert->link.accept_touch();
  two.site.run_until([&] { return two.bert->connected(); }, 2500ms);
  EXPECT_FALSE(two.bert->connected());
  EXPECT_TRUE(two.anna->connected());
}

TEST(HandOver, OnlyTheHolderMayOffer) {
  KeyedSite site;
  KeyedClient vera(site, site.ring.key("vera", Role::Viewer));
  KeyedClient quinn(site, site.ring.key("quinn", Role::Qa), "qa");
  KeyedClient dora(site, site.ring.key("dora", Role::Doctor));  // a doctor who only watches
  ASSERT_TRUE(site.run_until([&] { return vera.connected() && quinn.connected() && dora.connected(); }));
  for (KeyedClient* client : {&vera, &quinn, &dora}) {
    EXPECT_TRUE(client->link.hand_over("bert"));
    ASSERT_TRUE(site.run_until([&] { return !client->hand_over_answers.empty(); }));
  }
  EXPECT_NE(vera.hand_over_answers.front().find("the role viewer of vera does not allow to hand over"),
            std::string::npos);
  EXPECT_NE(quinn.hand_over_answers.front().find("the role qa of quinn does not allow to hand over"),
            std::string::npos);
  EXPECT_NE(dora.hand_over_answers.front().find("does not hold the touch"), std::string::npos);
  EXPECT_NE(site.ring.audit().find("event=refused who=viewer vera"), std::string::npos) << site.ring.audit();
}

TEST(TouchLease, AnOfferIsTakenByItsDoctorAloneAndEndsByTimeOrWithTheLease) {
  const auto start = std::chrono::steady_clock::now();
  const auto offered = [&] {
    access::TouchLease lease;
    EXPECT_TRUE(lease.take(1, "a", "anna", start));
    EXPECT_FALSE(lease.offer(2, "bert", start)) << "peer 2 holds nothing";
    EXPECT_TRUE(lease.offer(1, "bert", start));
    return lease;
  };
  access::TouchLease lease = offered();
  EXPECT_FALSE(lease.take(2, "b", "bert", start + 1s)) << "an offer alone takes nothing away";
  EXPECT_FALSE(lease.accept(3, "c", "carla", start + 1s));
  EXPECT_EQ(lease.accept(2, "b", "bert", start + 1s), 1u);
  EXPECT_FALSE(lease.renew(1, start + 1s));
  EXPECT_FALSE(lease.accept(2, "b", "bert", start + 1s)) << "it is taken once";

  access::TouchLease late = offered();
  for (auto now = start; now < start + 61s; now += 5s) EXPECT_TRUE(late.renew(1, now));
  EXPECT_FALSE(late.accept(2, "b", "bert", start + 61s)) << "an offer stands for 60 s";

  access::TouchLease silent = offered();
  EXPECT_FALSE(silent.offered_to(start + 11s)) << "the offer ends with the holder's lease";
  EXPECT_TRUE(silent.take(3, "c", "carla", start + 11s)) << "then any doctor may take the touch";

  access::TouchLease left = offered();
  left.leave(1, true, start + 1s);
  EXPECT_FALSE(left.take(3, "c", "carla", start + 2s)) << "anna left the touch to bert";
  EXPECT_FALSE(left.take(1, "a", "anna", start + 2s));
  EXPECT_TRUE(left.take(2, "b", "bert", start + 2s));
}

TEST(TouchLease, AnOfferSurvivesABrokenConnectionOfTheHolder) {
  const auto start = std::chrono::steady_clock::now();
  const auto broken = [&] {
    access::TouchLease lease;
    EXPECT_TRUE(lease.take(1, "a", "anna", start));
    EXPECT_TRUE(lease.offer(1, "bert", start));
    lease.leave(1, false, start + 1s);
    return lease;
  };
  access::TouchLease returned = broken();
  EXPECT_TRUE(returned.take(4, "a", "anna", start + 2s)) << "anna comes back within her lease";
  EXPECT_EQ(returned.offered_to(start + 2s), "bert") << "and her offer stands";
  EXPECT_TRUE(returned.offer(4, "", start + 3s)) << "she may withdraw it";
  EXPECT_FALSE(returned.accept(2, "b", "bert", start + 4s));

  access::TouchLease accepted = broken();
  EXPECT_FALSE(accepted.accept(3, "c", "carla", start + 2s));
  EXPECT_EQ(accepted.accept(2, "b", "bert", start + 2s), 0u) << "bert accepts while no station has the touch";
  EXPECT_FALSE(accepted.take(4, "a", "anna", start + 3s)) << "anna comes back too late";

  access::TouchLease ended = broken();
  EXPECT_FALSE(ended.accept(2, "b", "bert", start + 12s)) << "the offer ends with the holder's lease";
  EXPECT_TRUE(ended.take(3, "c", "carla", start + 12s));
}

TEST(TouchLease, IsLostBySilenceAndKeptForTheSameDoctorOverALostConnection) {
  const auto start = std::chrono::steady_clock::now();
  access::TouchLease lease;
  EXPECT_TRUE(lease.take(1, "a", "anna", start));
  EXPECT_FALSE(lease.take(2, "b", "bert", start + 5s));
  EXPECT_TRUE(lease.renew(1, start + 9s));
  EXPECT_FALSE(lease.take(2, "b", "bert", start + 15s)) << "anna spoke 6 s ago";
  EXPECT_TRUE(lease.take(2, "b", "bert", start + 20s)) << "anna was silent for 11 s";
  EXPECT_FALSE(lease.renew(1, start + 20s)) << "anna's station hears that it lost the touch";
  lease.leave(2, false, start + 21s);
  EXPECT_FALSE(lease.take(3, "a", "anna", start + 22s)) << "bert's connection was lost: it may come back";
  EXPECT_TRUE(lease.take(4, "b", "bert", start + 23s));
  lease.leave(4, true, start + 24s);
  EXPECT_TRUE(lease.take(5, "a", "anna", start + 24s));
}

TEST(TokenBackOff, GuessingIsSlowedDownAndItsMemoryIsBounded) {
  const auto start = std::chrono::steady_clock::now();
  access::TokenBackOff back_off;
  int tried = 0;
  for (int ms = 0; ms < 600'000; ms += 10)
    if (back_off.may_try("10.0.0.9", start + std::chrono::milliseconds(ms))) {
      ++tried;
      back_off.failed("10.0.0.9", start + std::chrono::milliseconds(ms));
    }
  EXPECT_LE(tried, 25) << "in ten minutes";
  EXPECT_TRUE(back_off.may_try("10.0.0.8", start)) << "others are not held up";
  for (int i = 0; i < 5000; ++i) back_off.failed("address " + std::to_string(i), start);
  EXPECT_LE(back_off.addresses(), 1024u);
}

TEST(KeyedLink, AServerThatComesBackIsFoundAgainByItself) {
  KeyedSite site;
  KeyedClient anna(site, site.ring.key("anna", Role::Doctor), "doctor", {wire::kStationState});
  ASSERT_TRUE(site.run_until([&] { return anna.connected(); }));
  const std::uint16_t port = site.listener->port();
  site.listener->close("the server is restarted");
  ASSERT_TRUE(site.run_until([&] { return !anna.connected(); }));
  site.run_until([] { return false; }, 1200ms);
  auto made = hub::PeerListener::listen(site.io, site.hub, site.clock, {.port = port, .access = site.access});
  ASSERT_TRUE(made.ok());
  site.listener = std::move(made).value();
  EXPECT_TRUE(site.run_until([&] { return anna.connected(); })) << "the same key takes the touch again";
  EXPECT_EQ(anna.link.counts().connections, 2u);
}

/// Both ends of a TLS session, and the bytes that they export.
struct Exporting : wire::ConnectionOwner {
  std::shared_ptr<wire::Connection> connection;
  std::optional<std::array<std::byte, 32>> one, other;
  std::string closed;
  bool accepts(const wire::Topic&) override { return true; }
  void on_ready(const msg::Hello&) override {
    one = connection->keying_material("EXPORTER-telepalp-datagrams");
    other = connection->keying_material("EXPORTER-telepalp-other");
  }
  void on_message(wire::Message) override {}
  void on_subscribe(std::vector<std::string>) override {}
  void on_clock(const wire::ClockSample&) override {}
  void on_key_frame_request(const wire::Topic&, SessionTime) override {}
  void on_closed(const std::string& reason) override { closed = reason; }
  std::optional<wire::Message> next_to_send() override { return std::nullopt; }
  SessionTime session_now() override { return session_time(1); }
};

TEST(KeyedLink, BothEndsExportTheSameSecretBytesAndEachSessionItsOwn) {
  boost::asio::io_context io;
  const KeyRing ring;
  const auto server_key = *keys::load_key(ring.server_key(ring.now), ring.now);
  const auto key = ring.key("anna", Role::Doctor);
  const auto at_server =
      *wire::tls_settings(keys::server_context(server_key, [](const std::string&) { return false; }));
  const auto at_client = *wire::tls_settings(keys::client_context(*key));
  std::vector<std::array<std::byte, 32>> seen;
  for (int session = 0; session < 2; ++session) {
    io.restart();
    tcp::acceptor acceptor(io, {boost::asio::ip::make_address("127.0.0.1"), 0});
    tcp::socket client_socket(io);
    client_socket.connect(acceptor.local_endpoint());
    Exporting server, client;
    server.connection = std::make_shared<wire::Connection>(wire::tls_at_server(acceptor.accept(), at_server),
                                                           wire::Connection::Options{}, server);
    client.connection =
        std::make_shared<wire::Connection>(wire::tls_at_client(std::move(client_socket), at_client, "127.0.0.1", key),
                                           wire::Connection::Options{}, client);
    server.connection->start();
    client.connection->start();
    for (int i = 0; i < 500 && !(server.one && client.one); ++i) io.run_one_for(10ms);
    ASSERT_TRUE(server.one && client.one) << server.closed << "; " << client.closed;
    EXPECT_EQ(*server.one, *client.one);
    EXPECT_NE(*server.one, *server.other);
    seen.push_back(*server.one);
    server.connection->abandon();
    client.connection->abandon();
    io.run_for(50ms);
  }
  EXPECT_NE(seen[0], seen[1]);
}

/// Sends `bytes` and reads until the server closes; the time that took.
std::chrono::milliseconds time_to_close(Site& site, const std::string& bytes) {
  const auto begun = std::chrono::steady_clock::now();
  tcp::socket socket(site.io);
  socket.connect({boost::asio::ip::make_address("127.0.0.1"), site.listener->port()});
  boost::asio::write(socket, boost::asio::buffer(bytes));
  std::array<char, 4096> heard{};
  bool closed = false;
  std::function<void()> read = [&] {
    socket.async_read_some(boost::asio::buffer(heard), [&](const boost::system::error_code& code, std::size_t) {
      closed = static_cast<bool>(code);
      if (!closed) read();
    });
  };
  read();
  EXPECT_TRUE(site.run_until([&] { return closed; }, 9s));
  return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begun);
}

/// Whether a listener between a server and its subscriber hears the word "PATIENT" of a camera message.
bool is_overheard(Site& site, std::shared_ptr<const keys::KeyFile> key) {
  DelayRelay relay(site.io, site.listener->port(), 0ms);
  KeyedClient client(site, std::move(key), "viewer", {}, "127.0.0.1", relay.port());
  EXPECT_TRUE(site.run_until([&] { return client.connected(); }));
  site.run_until([] { return false; }, 100ms);  // the subscription arrives
  site.hub.publish(message(wire::kCameraColor, "PATIENT"));
  EXPECT_TRUE(site.run_until([&] { return !client.messages.empty(); }));
  EXPECT_GT(relay.overheard().size(), 500u);
  return relay.overheard().find("PATIENT") != std::string::npos;
}

TEST(KeyedLink, WhoListensOnTheNetworkHearsNothingOfThePatient) {
  Site plain;
  EXPECT_TRUE(is_overheard(plain, nullptr)) << "so that the test can fail";
  KeyedSite sealed;
  EXPECT_FALSE(is_overheard(sealed, sealed.ring.key("vera", Role::Viewer)));
}

/// This process may open `more` further files while it lives.
struct FewDescriptors {
  rlimit before{};
  explicit FewDescriptors(rlim_t more) {
    ::getrlimit(RLIMIT_NOFILE, &before);
    const int next = ::dup(0);
    ::close(next);
    rlimit few = before;
    few.rlim_cur = static_cast<rlim_t>(next) + more;
    ::setrlimit(RLIMIT_NOFILE, &few);
  }
  ~FewDescriptors() { ::setrlimit(RLIMIT_NOFILE, &before); }
};

TEST(BadInput33, WithoutDescriptorsTheServerWaitsAndThenAcceptsAgain) {
  KeyedSite site;
  KeyedClient anna(site, site.ring.key("anna", Role::Doctor), "doctor", {wire::kStationState});
  ASSERT_TRUE(site.run_until([&] { return anna.connected(); }));
  std::vector<tcp::socket> greedy;
  {
    const FewDescriptors few(6);
    boost::system::error_code full;
    while (!full && greedy.size() < 100) {
      greedy.emplace_back(site.io);
      greedy.back().connect({boost::asio::ip::make_address("127.0.0.1"), site.listener->port()}, full);
    }
    EXPECT_TRUE(full);
    std::size_t handlers = 0;
    const auto end = std::chrono::steady_clock::now() + 500ms;
    while (std::chrono::steady_clock::now() < end) handlers += site.io.run_one_for(5ms);
    EXPECT_LT(handlers, 300u) << "it does not spin";
    EXPECT_TRUE(anna.connected());
    EXPECT_GE(site.listener->counts().refused, 1u);
    EXPECT_LE(site.listener->counts().refused, 3u) << "a pause is counted once, however often accepting is tried";
    greedy.clear();
  }
  EXPECT_NE(site.ring.audit().find("accepting pauses"), std::string::npos) << site.ring.audit();
  KeyedClient vera(site, site.ring.key("vera", Role::Viewer));
  EXPECT_TRUE(site.run_until([&] { return vera.connected(); }));
}

TEST(BadInput11, ASlowHandshakeEndsAfterFiveSecondsAndADoctorIsNotDisturbed) {
  KeyedSite site;
  KeyedClient anna(site, site.ring.key("anna", Role::Doctor), "doctor", {wire::kStationState});
  ASSERT_TRUE(site.run_until([&] { return anna.connected(); }));
  const auto took = time_to_close(site, std::string("\x16\x03\x01", 3));
  EXPECT_GT(took, 4s);
  EXPECT_LT(took, 8s);
  EXPECT_TRUE(anna.connected());
}

TEST(BadInput12, AFloodOfHandshakesHoldsNoMorePlacesThanThereAreForStrangers) {
  KeyedSite site;
  std::vector<tcp::socket> flood;
  for (int i = 0; i < 200; ++i) {
    flood.emplace_back(site.io);
    flood.back().connect({boost::asio::ip::make_address("127.0.0.1"), site.listener->port()});
    boost::asio::write(flood.back(), boost::asio::buffer("\x16", 1));
    site.io.poll();
  }
  EXPECT_LE(site.listener->peers(), 40u);
  EXPECT_GE(site.listener->counts().refused, 150u);
  EXPECT_NE(site.ring.audit().find("have not sent their Hello message yet"), std::string::npos) << site.ring.audit();
  KeyedClient anna(site, site.ring.key("anna", Role::Doctor), "doctor");
  EXPECT_TRUE(site.run_until([&] { return anna.connected(); }));
}

TEST(BadInput, DamagedTlsRecordsEndTheirConnectionAndAreAudited) {
  KeyedSite site;
  std::mt19937 random(7);
  for (int i = 0; i < 50; ++i) {
    std::string bytes("\x16\x03\x01\x01\x00", 5);
    for (int n = 0; n < 256; ++n) bytes += static_cast<char>(random());
    EXPECT_LT(time_to_close(site, bytes), 3s) << "seed 7, attempt " << i;
  }
  KeyedClient anna(site, site.ring.key("anna", Role::Doctor), "doctor");
  EXPECT_TRUE(site.run_until([&] { return anna.connected(); }));
  EXPECT_NE(site.ring.audit().find("event=refused who=stranger"), std::string::npos);
}

TEST(BadInput34, ANameWithNewlinesIsEscapedInTheAuditLog) {
  const KeyRing ring;
  const auto log = access::AuditLog::open(ring.folder.path() / "audit.log", [](const std::string&) {});
  ASSERT_TRUE(log.ok());
  (*log)->note(access::AuditEvent::Joined, "program=x\nevent=took-touch\x1b[2J", ring.now);
  EXPECT_NE(ring.audit().find("program=x\\x0aevent=took-touch\\x1b[2J"), std::string::npos) << ring.audit();
}

/// No file may grow beyond `bytes` while it lives, as on a full disk.
struct FullDisk {
  rlimit before{};
  void (*handler)(int) = std::signal(SIGXFSZ, SIG_IGN);
  explicit FullDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before);
    rlimit full = before;
    full.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &full);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
  }
};

TEST(BadInput30, AFullDiskIsAnAlarmAndNeverAnEnd) {
  std::vector<std::string> said;
  const KeyRing ring;
  const auto log =
      access::AuditLog::open(ring.folder.path() / "audit.log", [&](const std::string& text) { said.push_back(text); });
  ASSERT_TRUE(log.ok());
  EXPECT_FALSE(access::AuditLog::open("/dev/full", [](const std::string&) {}).ok()) << "a device is no log";
  (*log)->note(access::AuditEvent::Started, "", ring.now);
  for (const rlim_t bytes_left : {0, 10}) {  // 10: the beginning of a line still fits
    const FullDisk full(ring.audit().size() + bytes_left);
    for (int i = 0; i < 10; ++i) (*log)->note(access::AuditEvent::Joined, "program=x", ring.now);
  }
  EXPECT_EQ((*log)->not_written(), 20u);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said.front().find("ALARM"), std::string::npos);
  (*log)->note(access::AuditEvent::Joined, "program=y", ring.now);
  EXPECT_EQ((*log)->lines(), 2u);
  EXPECT_NE(ring.audit().find("program=y not-written=20"), std::string::npos) << ring.audit();
  std::istringstream written(ring.audit());
  keys::AuditVerifier verifier;
  for (std::string line; std::getline(written, line);)
    EXPECT_TRUE(verifier.add(line).ok()) << "the chain has no break: " << line;
}

TEST(AuditLog, GoesOnWhereItEndedAndPutsAnAlteredOneAside) {
  const KeyRing ring;
  const std::filesystem::path file = ring.folder.path() / "audit.log";
  std::vector<std::string> said;
  const auto open = [&] {
    return access::AuditLog::open(file, [&](const std::string& text) { said.push_back(text); });
  };
  for (int run = 0; run < 3; ++run) (*open())->note(access::AuditEvent::Started, "", ring.now);
  EXPECT_EQ((*open())->lines(), 3u);
  std::string text = ring.audit();
  text[text.size() / 2] ^= 1;
  std::ofstream(file, std::ios::binary) << text;
  EXPECT_EQ((*open())->lines(), 0u);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(std::filesystem::exists(file.string() + ".damaged-1"));
}

TEST(AuditLog, StrangersCannotFillTheDisk) {
  const KeyRing ring;
  const auto log = access::AuditLog::open(ring.folder.path() / "audit.log", [](const std::string&) {});
  for (int i = 0; i < 10'000; ++i) (*log)->note(access::AuditEvent::Refused, "who=stranger", ring.now);
  (*log)->note(access::AuditEvent::Joined, "who=anna", ring.now);
  EXPECT_EQ((*log)->lines(), 21u);
  EXPECT_NE(ring.audit().find("also-refused=9980"), std::string::npos) << ring.audit();
}

}  // namespace
}  // namespace telepalp::server
