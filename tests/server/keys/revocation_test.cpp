// Revoked keys of servers and persons, revoked tokens, and the list of revoked keys.

#include <gtest/gtest.h>

#include "tests/server/keyed_site.h"

namespace telepalp::server {
namespace {

using access::Access;
using keys::Role;

Result<std::shared_ptr<Access>> opened(const KeyRing& ring, std::vector<std::string>* said = nullptr) {
  return Access::with_key(
      {.key = ring.folder.path() / "server.key", .revoked = {}, .audit = {}, .say = [said](const std::string& text) {
         if (said != nullptr) said->push_back(text);
       }});
}

std::string serial_of_server(const KeyRing& ring) {
  return keys::load_key(ring.folder.path() / "server.key", ring.now)->identity.serial;
}

TEST(Revocation, AServerWithARevokedKeyDoesNotStart) {
  const KeyRing ring;
  (void)ring.server_key(ring.now);
  EXPECT_TRUE(opened(ring).ok());
  ring.revoke(serial_of_server(ring));
  const auto revoked = opened(ring);
  ASSERT_FALSE(revoked.ok());
  EXPECT_EQ(revoked.error().what, "the key of this server is revoked");
  EXPECT_NE(revoked.error().fix.find("telepalp-keys server"), std::string::npos);
}

TEST(Revocation, AServerWhoseKeyIsRevokedMeanwhileServesNobody) {
  KeyedSite site;
  int ended = 0;
  site.access->on_revoked([&](const Error&) { ++ended; });
  KeyedClient vera(site, site.ring.key("vera", Role::Viewer));
  ASSERT_TRUE(site.run_until([&] { return vera.connected(); }));
  site.ring.revoke(serial_of_server(site.ring));
  ASSERT_TRUE(site.run_until([&] { return vera.refused(); }, 4s));
  EXPECT_NE(vera.link.refusal().what.find("the server's key is revoked"), std::string::npos)
      << to_string(vera.link.refusal());
  EXPECT_EQ(ended, 1);
  KeyedClient walt(site, site.ring.token("walt", Role::Viewer));
  ASSERT_TRUE(site.run_until([&] { return walt.refused() || walt.connected(); }));
  EXPECT_TRUE(walt.refused());
}

TEST(Revocation, AMissingListIsRefused) {
  const KeyRing ring;
  (void)ring.server_key(ring.now);
  std::filesystem::remove(ring.folder.path() / "revoked.crl");
  const auto without = opened(ring);
  ASSERT_FALSE(without.ok());
  EXPECT_NE(without.error().what.find("the list of revoked keys is missing"), std::string::npos);
  EXPECT_NE(without.error().fix.find("copy the newest revoked.crl"), std::string::npos);
}

TEST(Revocation, AnOlderListIsRefusedWhileTheServerRunsAndAfterItsRestart) {
  const KeyRing ring;
  (void)ring.server_key(ring.now);
  const auto list = [&](std::uint64_t number) {
    ring.lists = number - 1;
    ring.write_list({{"07", ring.now}});
  };
  list(7);
  std::vector<std::string> said;
  {
    const auto access = opened(ring, &said);
    ASSERT_TRUE(access.ok());
    ring.lists = 5;
    ring.write_list({});  // number 6: "07" is no longer revoked
    std::filesystem::last_write_time(ring.folder.path() / "revoked.crl",
                                     std::filesystem::file_time_type::clock::now() + 2s);
    (*access)->look_at_files();
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("is older (number 6) than one that this server has read before (number 7)"),
              std::string::npos)
        << said[0];
    EXPECT_NE(said[0].find("the previous list stays valid"), std::string::npos) << said[0];
    EXPECT_EQ((*access)->revocation_number(), 7u);
  }
  const auto again = opened(ring);
  ASSERT_FALSE(again.ok());
  EXPECT_NE(again.error().what.find("is older (number 6)"), std::string::npos);
  list(8);
  EXPECT_TRUE(opened(ring).ok());
}

TEST(Revocation, AServerThatShowsAnOlderListThanAnotherIsRefusedByTheClient) {
  KeyedSite site;
  auto anna = std::make_shared<keys::KeyFile>(*site.ring.key("anna", Role::Doctor));
  anna->path = site.ring.folder.path() / "anna.key";
  keys::KnownList known(*anna);
  ASSERT_TRUE(known.take(*site.ring.authority.revocation_list({}, site.ring.now, 99)).ok());  // of a server elsewhere
  KeyedClient client(site, anna);
  ASSERT_TRUE(site.run_until([&] { return client.refused() || client.connected(); }));
  ASSERT_TRUE(client.refused());
  EXPECT_NE(client.link.refusal().what.find("is older"), std::string::npos) << to_string(client.link.refusal());
  EXPECT_TRUE(client.messages.empty()) << "nothing of an untrusted server is passed on";
}

TEST(Revocation, ARevokedKeyInUseIsAuditedByNameAndSerial) {
  KeyedSite site;
  const auto anna = site.ring.key("anna", Role::Doctor);
  const auto vera = site.ring.token("vera", Role::Viewer);
  site.ring.write_list({{anna->identity.serial, site.ring.now}, {vera->identity.serial, site.ring.now}});
  site.access->look_at_files();
  KeyedClient key(site, anna, "doctor"), token(site, vera);
  ASSERT_TRUE(site.run_until([&] { return key.refused() && token.refused(); }));
  for (const auto& [who, of] : {std::pair{"doctor anna", anna}, std::pair{"viewer vera", vera}}) {
    const std::string line = std::string("event=refused who=") + who;
    EXPECT_NE(site.ring.audit().find(line), std::string::npos) << site.ring.audit();
    EXPECT_NE(site.ring.audit().find("key=" + of->identity.serial), std::string::npos) << site.ring.audit();
  }
}

TEST(Revocation, AStationNeedsACertificate) {
  KeyedSite site;
  KeyedClient anna(site, site.ring.token("anna", Role::Doctor), "doctor", {wire::kStationState});
  ASSERT_TRUE(site.run_until([&] { return anna.refused() || anna.connected(); }));
  ASSERT_TRUE(anna.refused());
  EXPECT_NE(anna.link.refusal().what.find("a station needs a key"), std::string::npos)
      << to_string(anna.link.refusal());
  KeyedClient watches(site, site.ring.token("anna", Role::Doctor), "viewer", {wire::kStationState});
  site.run_until([&] { return site.access->counts().refused > 1; });
  EXPECT_NE(site.ring.audit().find("may not publish /station/state"), std::string::npos) << "nor by another role";
}

TEST(Revocation, ATokenWithoutItsSecretOpensNothing) {
  KeyedSite site;
  auto overheard = std::make_shared<keys::KeyFile>(*site.ring.token("vera", Role::Viewer));
  overheard->token = keys::prove_token(overheard->token, {}).token;
  KeyedClient thief(site, overheard);
  ASSERT_TRUE(site.run_until([&] { return thief.refused() || thief.connected(); }));
  EXPECT_TRUE(thief.refused());
}

TEST(Revocation, TheFirstBrowserThatSignsInWithATokenKeepsItAlsoAfterARestart) {
  const KeyRing ring;
  (void)ring.server_key(ring.now);
  const std::string token = ring.token("vera", Role::Viewer)->token;
  {
    const auto access = *opened(ring);
    EXPECT_TRUE(access->bearer(token, "10.0.0.7").ok()) << "a program may use it until then";
    const auto vera = access->sign_in(token, "10.0.0.7", "");
    ASSERT_TRUE(vera.ok());
    access->bind_to_browser(*vera, "cookie of the first browser");
    EXPECT_FALSE(access->sign_in(token, "10.0.0.7", "").ok());
  }
  const auto access = *opened(ring);
  EXPECT_TRUE(access->sign_in(token, "10.0.0.7", "cookie of the first browser").ok());
  EXPECT_FALSE(access->sign_in(token, "10.0.0.8", "cookie of a thief").ok());
  EXPECT_FALSE(access->bearer(token, "10.0.0.8").ok());
}

}  // namespace
}  // namespace telepalp::server
