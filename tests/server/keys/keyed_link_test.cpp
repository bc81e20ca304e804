// A server with keys, over real sockets: who enters, who is refused, and what each is told.

#include <gtest/gtest.h>

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
        const bool allowed = keys::allows(role, operation) && !(as_token && operation == keys::Operation::Touch);
        EXPECT_EQ(client.connected(), allowed) << name(role) << " " << name(operation);
        EXPECT_EQ(client.refused(), !allowed) << name(role) << " " << name(operation);
      }
}

TEST(KeyedLink, ADeniedRoleIsToldWhichAndTheAuditLogNamesIt) {
  KeyedSite site;
  KeyedClient vera(site, site.ring.key("vera", Role::Viewer), "doctor");
  expect_refused(site, vera, "the role viewer of vera lacks the right 'touch'", "use a key whose role allows it");
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
  expect_refused(site, stranger, "the server's key was not made by the authority site, which made your key",
                 "connect to the address of the server that your key is for");
  auto forged = std::make_shared<keys::KeyFile>(*other.key("eve", Role::Doctor));
  forged->authority = site.ring.authority.certificate();  // a client that takes any server
  KeyedClient eve(site, forged, "doctor");
  expect_refused(site, eve, "the server refuses your key: another authority made it", "telepalp-keys client");
}

TEST(KeyedLink, ATokenOfAnotherAuthorityIsRefused) {
  KeyedSite site;
  const KeyRing other;
  auto forged = std::make_shared<keys::KeyFile>(*other.token("eve", Role::Doctor));
  forged->authority = site.ring.authority.certificate();
  KeyedClient eve(site, forged, "doctor");
  expect_refused(site, eve, "this is not a token of the server's authority", "telepalp-keys token");
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

TEST(KeyedLink, ARevocationListThatCannotBeReadIsSaidOnceAndTheOneBeforeItHolds) {
  const KeyRing ring;
  ring.revoke("07");
  const std::filesystem::path key = ring.server_key(ring.now);
  std::vector<std::string> said;
  const auto opened = access::Access::with_key(
      {.key = key, .revoked = {}, .audit = {}, .say = [&](const std::string& text) { said.push_back(text); }});
  ASSERT_TRUE(opened.ok()) << to_string(opened.error());
  std::filesystem::resize_file(key.parent_path() / "revoked.crl", std::uintmax_t{17} << 20);
  for (int second = 0; second < 3; ++second) (*opened)->look_at_files();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("the previous list stays valid"), std::string::npos) << said[0];
}

TEST(KeyedLink, AKeyThatExpiresMeanwhileEndsTheSessionAndFreesTheTouch) {
  KeyedSite site;
  const keys::WallTime made = site.ring.now - std::chrono::days(1) + 6s;  // a key holds for a day
  KeyedClient anna(site, site.ring.key("anna", Role::Doctor, made), "doctor", {wire::kStationState});
  ASSERT_TRUE(site.run_until([&] { return anna.connected(); }));
  ASSERT_TRUE(site.run_until([&] { return anna.refused(); }, 20s));
  EXPECT_NE(anna.link.refusal().what.find("expired"), std::string::npos) << to_string(anna.link.refusal());
  KeyedClient bert(site, site.ring.key("bert", Role::Doctor), "doctor", {wire::kStationState});
  bert.link.accept_touch();
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
  expect_refused(site, client, "the server does not use TLS", "leave out --key");
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
  EXPECT_NE(without.error().fix.find("telepalp-keys authority --host HOST && telepalp-keys server --host"),
            std::string::npos);
  EXPECT_TRUE(hub::listening_address("0.0.0.0", true).ok());
  EXPECT_TRUE(hub::listening_address("127.0.0.1", false).ok());
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
      *wire::tls_settings(keys::server_context(server_key, [](const keys::Identity&) { return false; }));
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

}  // namespace
}  // namespace telepalp::server
