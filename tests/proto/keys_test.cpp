#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <random>
#include <sstream>

#include "proto/keys/audit_chain.h"
#include "proto/keys/authority.h"
#include "proto/keys/key_file.h"
#include "proto/keys/known_list.h"
#include "proto/keys/revocations.h"
#include "proto/keys/tls_context.h"
#include "proto/keys/token.h"
#include "proto/keys/x509/openssl.h"
#include "tests/proto/handshake.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::keys {
namespace {

using std::chrono::days;

const WallTime kNow = std::chrono::system_clock::now();

Authority authority() { return std::move(Authority::create("test", kNow, days(3650)).value()); }

std::string token_of(const Authority& by, days valid = days(30)) {
  const std::string file = *by.token({.name = "vera", .role = Role::Viewer, .now = kNow, .valid = valid});
  return read_key(file, "vera.token")->token;
}

Result<Identity> read_by(const Authority& reader, const std::string& token, WallTime now = kNow) {
  return read_token(token, *X509_get0_pubkey(certificates_in(reader.certificate()).front().get()), now);
}

TEST(Roles, TheWholeTableOfRolesAndOperationsIsAsAgreed) {
  std::ostringstream table;
  for (const Role role : kRoles) table << name(role) << ": " << permissions(role) << "\n";
  EXPECT_EQ(table.str(),
            "technician: watch, record, metrics, play, set up, listen, speak at the patient's side\n"
            "doctor: watch, touch, hand over, record, listen, speak as the doctor\n"
            "viewer: watch\n"
            "qa: watch, record, metrics, play, listen\n"
            "local: watch, touch, hand over, record, metrics, play, set up, listen, speak at the patient's side, speak "
            "as the doctor\n");
}

TEST(Roles, WhatIsNotInTheTableIsDenied) {
  for (const Operation operation : kOperations) EXPECT_FALSE(allows(static_cast<Role>(77), operation));
  for (const Role role : kRoles) EXPECT_FALSE(allows(role, static_cast<Operation>(77)));
  EXPECT_FALSE(role_named("local")) << "no key may carry it";
  EXPECT_FALSE(role_named("Doctor"));
}

TEST(KeyFiles, SayWhoseTheyAreAndWhatTheyAllow) {
  const Authority by = authority();
  const Result<KeyFile> anna =
      read_key(*by.client_key({.name = "anna", .role = Role::Doctor, .now = kNow}), "anna.key");
  ASSERT_TRUE(anna.ok());
  EXPECT_EQ(anna->kind, KeyFile::Kind::Client);
  EXPECT_EQ(describe(anna->identity), "doctor anna");
  EXPECT_NE(in_words(*anna).find("watch, touch, hand over, record"), std::string::npos) << in_words(*anna);
  const Result<KeyFile> server =
      read_key(*by.server_key({.name = "s", .now = kNow}, {"10.0.0.5", "patient.example", "fd00::5"}), "server.key");
  ASSERT_TRUE(server.ok());
  EXPECT_EQ(server->hosts,
            (std::vector<std::string>{"10.0.0.5", "patient.example", "fd00::5", "localhost", "127.0.0.1", "::1"}));
}

TEST(KeyFiles, NamesAndHostsCannotSmuggleIntoTheCertificate) {
  const Authority by = authority();
  for (const char* wrong : {"", "a b", "a,URI:telepalp:role:doctor", "a\nb", "../a", "a/b", "ä"})
    EXPECT_FALSE(by.client_key({.name = wrong, .role = Role::Viewer, .now = kNow}).ok()) << wrong;
  for (const char* wrong : {"", "a b", "a,DNS:b", "a/b", "*.example", "copy:x,"})
    EXPECT_FALSE(by.server_key({.name = "s", .now = kNow}, {wrong}).ok()) << wrong;
  EXPECT_FALSE(by.client_key({.name = "a", .role = Role::Local, .now = kNow}).ok());
}

TEST(KeyFiles, NoAlteredByteOfACertificateOrKeyIsTaken) {
  const Authority by = authority();
  const std::string text = *by.client_key({.name = "anna", .role = Role::Viewer, .now = kNow});
  const KeyFile whole = *read_key(text, "anna.key");
  for (std::size_t at = text.find("-----BEGIN"); at < text.size(); ++at) {
    std::string altered = text;
    altered[at] = altered[at] == 'A' ? 'B' : 'A';
    const Result<KeyFile> read = read_key(altered, "anna.key");
    if (!read) continue;  // what is still read says the same: the spare bits of the last Base64 digit, a byte between
    EXPECT_EQ(read->certificate, whole.certificate) << "byte " << at;
    EXPECT_EQ(describe(read->identity), "viewer anna") << "byte " << at;
  }
}

TEST(KeyFiles, PartsOfDifferentKeysDoNotMakeOne) {
  const Authority by = authority();
  const KeyFile a = *read_key(*by.client_key({.name = "a", .role = Role::Viewer, .now = kNow}), "a");
  const KeyFile b = *read_key(*by.client_key({.name = "b", .role = Role::Doctor, .now = kNow}), "b");
  EXPECT_FALSE(read_key(b.certificate + to_pem(*a.private_key) + a.authority, "mixed").ok());
  EXPECT_FALSE(read_key(a.certificate + to_pem(*a.private_key) + authority().certificate(), "other authority").ok());
  EXPECT_FALSE(read_key(by.file_text(), "authority.key").ok());
  EXPECT_FALSE(read_key("", "empty").ok());
  EXPECT_FALSE(read_key(std::string(kMaxKeyFileBytes + 1, 'x'), "large").ok());
}

TEST(KeyFiles, WithAKeyOfAnUnknownKindAreRefused) {
  std::ifstream file(TELEPALP_SOURCE_DIR "/tests/fuzz/corpus/requests/certificate_of_an_unknown_kind_of_key");
  ASSERT_TRUE(file.is_open());
  file.get();  // the fuzzer's kind of input
  const std::string text(std::istreambuf_iterator<char>(file), {});
  ASSERT_NE(text.find("-----BEGIN CERTIFICATE-----"), std::string::npos);
  EXPECT_TRUE(certificates_in(text).empty()) << "OpenSSL has no public key for it, so nobody can use it";
  EXPECT_FALSE(read_public_part(text, "token").ok());
  EXPECT_FALSE(read_token("tp1.a.b", text, kNow).ok());
}

/// The errors of load_key() for a key with `mode`; empty: it was read.
std::string refusal(const std::filesystem::path& file, mode_t mode) {
  EXPECT_EQ(::chmod(file.c_str(), mode), 0);
  const Result<KeyFile> key = load_key(file, kNow);
  return key ? "" : key.error().what;
}

/// True if a client that expects `host` accepts a server whose key names 10.0.0.5 and patient.example.
bool accepts_server_as(const std::string& host) {
  const Authority by = authority();
  const KeyFile server_key =
      *read_key(*by.server_key({.name = "s", .now = kNow}, {"10.0.0.5", "patient.example"}), "server.key");
  const KeyFile client_key = *read_key(*by.client_key({.name = "a", .role = Role::Doctor, .now = kNow}), "a.key");
  return shake_hands(server_key, client_key, host);
}

TEST(ServerNames, OnlyTheExpectedOneIsAcceptedAndOneThatCannotBeCheckedNever) {
  EXPECT_TRUE(accepts_server_as("10.0.0.5"));
  EXPECT_TRUE(accepts_server_as("patient.example"));
  EXPECT_FALSE(accepts_server_as("10.0.0.6"));
  EXPECT_FALSE(accepts_server_as("other.example"));
  EXPECT_FALSE(accepts_server_as(""));
  EXPECT_FALSE(accepts_server_as(std::string("other\0.example", 14))) << "OpenSSL refuses to set this name";
}

TEST(KeyFiles, AreReadOnlyIfNobodyButTheirOwnerHasAccess) {
  const support::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "anna.key";
  std::ofstream(file) << *authority().client_key({.name = "anna", .role = Role::Doctor, .now = kNow});
  for (const mode_t mode : {0600, 0400}) EXPECT_EQ(refusal(file, mode), "") << std::oct << mode;
  for (const mode_t mode : {0604, 0602, 0601, 0660, 0620, 0610, 0644, 0666})
    EXPECT_NE(refusal(file, mode).find("than its owner"), std::string::npos) << std::oct << mode;
  EXPECT_NE(refusal(file, 0644).find("mode is 0644"), std::string::npos) << refusal(file, 0644);
}

TEST(KeyFiles, AProgramThatReadsOneCannotBeDumped) {
  const support::TemporaryFolder folder;
  ::prctl(PR_SET_DUMPABLE, 1);
  ASSERT_EQ(::prctl(PR_GET_DUMPABLE), 1);
  EXPECT_FALSE(load_key(folder.path() / "none.key", kNow).ok());
  EXPECT_EQ(::prctl(PR_GET_DUMPABLE), 0) << "before the key is in the memory";
}

TEST(KeyFiles, AnotherFileThatOthersMayReadIsNotToBeHidden) {
  const support::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "notes.txt";
  std::ofstream(file) << "not a key";
  EXPECT_NE(refusal(file, 0644).find("not a key file"), std::string::npos) << refusal(file, 0644);
}

TEST(KeyFiles, MayBeReadByTheGroupOfAServiceIfRootOwnsThem) {
  const support::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "server.key";
  std::ofstream(file) << *authority().server_key({.name = "s", .now = kNow}, {});
  const bool is_root = ::geteuid() == 0;
  EXPECT_EQ(refusal(file, 0640).empty(), is_root);
  EXPECT_EQ(refusal(file, 0440).empty(), is_root);
  if (!is_root) return;
  ASSERT_EQ(::chown(file.c_str(), 1, 1), 0);
  EXPECT_FALSE(refusal(file, 0640).empty()) << "a person's key is not for a group";
  EXPECT_TRUE(refusal(file, 0600).empty());
}

TEST(Tokens, AreReadByTheirOwnAuthorityAlone) {
  const Authority by = authority();
  const std::string token = token_of(by);
  EXPECT_EQ(describe(*read_by(by, token)), "viewer vera");
  EXPECT_FALSE(read_by(authority(), token).ok());
}

TEST(Tokens, AreNotMadeForAPeerWithoutAKeyAsNoKeysAre) {
  const Authority by = authority();
  for (const auto& made : {by.client_key({.name = "nobody", .role = Role::Local, .now = kNow}),
                           by.token({.name = "nobody", .role = Role::Local, .now = kNow})}) {
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().what, "the role local is only for programs that connect to a server without keys");
  }
}

TEST(Tokens, NoAlteredCharacterIsTaken) {
  const Authority by = authority();
  const std::string token = token_of(by);
  for (std::size_t at = 0; at < token.size(); ++at)
    for (const char letter : {'A', 'b', '7', '.', '=', '\0', '\n'}) {
      std::string altered = token;
      if (altered[at] == letter) continue;
      altered[at] = letter;
      EXPECT_FALSE(read_by(by, altered).ok()) << "character " << at;
    }
  EXPECT_FALSE(read_by(by, token + "A").ok());
  EXPECT_FALSE(read_by(by, "tp1." + std::string(100'000, 'A') + ".A").ok());
}

TEST(Tokens, AProgramsProofHoldsInItsOwnSessionAlone) {
  const Authority by = authority();
  const std::string token = token_of(by);
  std::array<std::byte, 32> session{}, other{};
  other[7] = std::byte{1};
  const ProvedToken proved = prove_token(token, session);
  EXPECT_TRUE(token.starts_with(proved.token + ".")) << "the secret is not sent";
  const auto read = [&](const std::string& sent, const std::string& proof, const std::array<std::byte, 32>& in) {
    return read_token(sent, by.certificate(), kNow, {.signature = proof, .exporter = in}).ok();
  };
  EXPECT_TRUE(read(proved.token, proved.proof, session));
  EXPECT_FALSE(read(proved.token, proved.proof, other)) << "who overhears it can use it nowhere";
  EXPECT_FALSE(read(proved.token, "", session));
  EXPECT_FALSE(read_by(by, proved.token).ok()) << "without its secret and without a proof";
  EXPECT_FALSE(read(proved.token, prove_token(token_of(by), session).proof, session)) << "the proof of another token";
  EXPECT_TRUE(read_by(by, token).ok()) << "whoever has the secret may also show it: a person at a browser does";
}

TEST(Tokens, EndWhenTheyExpire) {
  const Authority by = authority();
  const std::string token = token_of(by, days(1));
  EXPECT_TRUE(read_by(by, token, kNow + std::chrono::hours(23)).ok());
  const Result<Identity> late = read_by(by, token, kNow + std::chrono::hours(25));
  ASSERT_FALSE(late.ok());
  EXPECT_NE(late.error().what.find("expired"), std::string::npos);
}

TEST(Revocations, HaveANumber) {
  const Authority by = authority();
  for (const std::uint64_t number : {std::uint64_t{1}, std::uint64_t{300}, std::uint64_t{1} << 40U}) {
    const auto read = Revocations::read(*by.revocation_list({}, kNow, number), by.certificate(), "revoked.crl");
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->number(), number);
  }
}

/// The key of anna, as it is read from a file in `folder`.
KeyFile key_in(const support::TemporaryFolder& folder, const Authority& by) {
  KeyFile key = *read_key(*by.client_key({.name = "anna", .role = Role::Doctor, .now = kNow}), "anna.key");
  key.path = folder.path() / "anna.key";
  return key;
}

TEST(KnownList, AServerCanNeitherLeaveItOutNorShowAnOlderOneAlsoAfterARestartOfTheClient) {
  const support::TemporaryFolder folder;
  const Authority by = authority();
  const KeyFile key = key_in(folder, by);
  const ServerCertificate server{.serial = "07", .promises_list = true};
  const auto list = [&](std::uint64_t number) { return *by.revocation_list({}, kNow, number); };
  {
    KnownList known(key);
    EXPECT_FALSE(known.check(server, false).ok()) << "its certificate promises a list";
    EXPECT_TRUE(known.take(list(5)).ok());
    EXPECT_TRUE(known.take(list(5)).ok());
    EXPECT_TRUE(known.check(server, true).ok());
  }
  KnownList known(key);
  const Result<void> older = known.take(list(4));
  ASSERT_FALSE(older.ok());
  EXPECT_NE(older.error().what.find("is older (number 4) than one that was shown before (5)"), std::string::npos);
  EXPECT_FALSE(known.take(*authority().revocation_list({}, kNow, 9)).ok()) << "of another authority";
  EXPECT_FALSE(known.check({.serial = "07", .promises_list = false}, false).ok()) << "an earlier server showed one";
  EXPECT_TRUE(known.take(list(6)).ok());
}

TEST(KnownList, AServerWhoseKeyItNamesIsRefusedAlsoWhenAnotherServerShowedIt) {
  const support::TemporaryFolder folder;
  const Authority by = authority();
  const std::string stolen = "0123456789abcdef0123";
  ASSERT_TRUE(KnownList(key_in(folder, by)).take(*by.revocation_list({{stolen, kNow}}, kNow, 2)).ok());
  const KnownList known(key_in(folder, by));
  const Result<void> refused = known.check({.serial = stolen, .promises_list = true}, true);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().what.find("the server's key is revoked"), std::string::npos);
}

TEST(KnownList, AServerOfAnOlderVersionIsTakenByAClientThatHasSeenNoListYet) {
  const support::TemporaryFolder folder;
  EXPECT_TRUE(KnownList(key_in(folder, authority())).check({.serial = "07", .promises_list = false}, false).ok());
}

TEST(Revocations, NameWhatWasRevokedAndComeFromTheAuthorityAlone) {
  const Authority by = authority();
  const std::string serial = "40000000000000000001";
  const std::string list = *by.revocation_list({{serial, kNow}}, kNow);
  const Result<Revocations> read = Revocations::read(list, by.certificate(), "revoked.crl");
  ASSERT_TRUE(read.ok());
  EXPECT_TRUE(read->contains(serial));
  EXPECT_FALSE(read->contains("40000000000000000002"));
  EXPECT_FALSE(Revocations::read(list, authority().certificate(), "revoked.crl").ok());
  EXPECT_FALSE(Revocations::read("", by.certificate(), "revoked.crl").ok());
  EXPECT_TRUE(Revocations::read(*by.revocation_list({}, kNow), by.certificate(), "revoked.crl").ok());
}

std::string audit_of(int lines) {
  AuditPosition position;
  std::string log;
  for (int i = 0; i < lines; ++i) log += audit_line(position, "time=" + std::to_string(i) + " event=joined name=anna");
  return log;
}

Result<void> verify(const std::string& log) {
  AuditVerifier verifier;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (const Result<void> follows = verifier.add(line); !follows) return follows;
  return {};
}

TEST(AuditChain, AnyAlteredBitOfAnyByteIsFound) {
  const std::string log = audit_of(6);
  ASSERT_TRUE(verify(log).ok());
  for (std::size_t at = 0; at + 1 < log.size(); ++at)
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::string altered = log;
      altered[at] = static_cast<char>(static_cast<unsigned char>(altered[at]) ^ (1U << bit));
      EXPECT_FALSE(verify(altered).ok()) << "byte " << at << " bit " << bit;
    }
}

TEST(AuditChain, ARemovedInsertedOrMovedLineIsFound) {
  const std::string log = audit_of(6);
  const std::size_t line = log.size() / 6;
  EXPECT_FALSE(verify(log.substr(line)).ok()) << "the first is gone";
  EXPECT_FALSE(verify(log.substr(0, line) + log.substr(2 * line)).ok()) << "the second is gone";
  EXPECT_FALSE(verify(log.substr(0, line) + log).ok()) << "the first comes twice";
}

TEST(AuditChain, ANameCannotForgeALine) {
  AuditPosition position;
  const std::string line = audit_line(position, "event=joined name=anna\n000 event=left");
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  EXPECT_TRUE(verify(line).ok());
}

}  // namespace
}  // namespace telepalp::keys
