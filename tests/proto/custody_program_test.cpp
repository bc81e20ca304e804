// Requests, signatures, passphrases and the authority's limits, as users of telepalp-keys meet them. `folder` is the
// computer that makes keys, `home` the doctor's.

#include <cstdlib>

#include "proto/keys/key_file.h"
#include "proto/keys/request/key_request.h"
#include "proto/keys/revocations.h"
#include "tests/proto/keys_program.h"
#include "tests/support/terminal.h"

namespace telepalp::keys {
namespace {

struct Custody : KeysProgram {
  fs::path home = temporary.path() / "home";

  ~Custody() override {
    for (const char* name : {"TELEPALP_PASSPHRASE", "TELEPALP_NEW_PASSPHRASE"}) ::unsetenv(name);
  }
  int run_at_home(const std::vector<std::string>& words) { return run_in(home, words); }
  bool says(const std::string& text) const { return text_of(log).find(text) != std::string::npos; }
  std::string request() const { return (home / "anna.request").string(); }
  void begin() {
    ASSERT_EQ(run({"authority", "--host", "10.0.0.5"}), 0) << text_of(log);
    ASSERT_EQ(run_at_home({"request", "--name", "anna"}), 0) << text_of(log);
  }
};

TEST_F(Custody, ADoctorMakesAKeyOfHerOwnAndTheSiteSignsIt) {
  begin();
  const std::string own = text_of(home / "anna.key");
  EXPECT_EQ(text_of(request()).find("PRIVATE"), std::string::npos) << "nothing secret travels";
  ASSERT_EQ(run({"sign", request(), "--role", "doctor"}), 0) << text_of(log);
  EXPECT_TRUE(says(fingerprint(*read_request(text_of(request()), "r")->key))) << text_of(log);
  EXPECT_FALSE(load_key(home / "anna.key", std::chrono::system_clock::now()).ok()) << "not signed yet";
  fs::copy_file(folder / "anna.crt", home / "anna.crt");
  const Result<KeyFile> key = load_key(home / "anna.key", std::chrono::system_clock::now());
  ASSERT_TRUE(key.ok()) << key.error().what;
  EXPECT_EQ(describe(key->identity), "doctor anna");
  EXPECT_EQ(text_of(home / "anna.key"), own);
  EXPECT_EQ(run_at_home({"show", (home / "anna.key").string()}), 0) << text_of(log);
  EXPECT_TRUE(says("key of doctor anna")) << text_of(log);
  EXPECT_EQ(run_at_home({"request", "--name", "anna"}), 1) << "a second request must not overwrite the key";
  EXPECT_EQ(text_of(home / "anna.key"), own);
}

TEST_F(Custody, AServerMakesItsKeyItselfToo) {
  ASSERT_EQ(run({"authority", "--host", "10.0.0.5"}), 0);
  ASSERT_EQ(run_at_home({"request", "--name", "server"}), 0);
  const std::string request = (home / "server.request").string();
  EXPECT_EQ(run({"sign", request, "--host", "10.0.0.6"}), 1);
  EXPECT_TRUE(says("limited to 10.0.0.5, localhost")) << text_of(log);
  EXPECT_FALSE(fs::exists(folder / "server.crt"));
  ASSERT_EQ(run({"sign", request, "--host", "10.0.0.5"}), 0) << text_of(log);
  fs::copy_file(folder / "server.crt", home / "server.crt");
  const Result<KeyFile> key = load_key(home / "server.key", std::chrono::system_clock::now());
  ASSERT_TRUE(key.ok()) << key.error().what;
  EXPECT_EQ(key->kind, KeyFile::Kind::Server);
  EXPECT_EQ(key->hosts.front(), "10.0.0.5");
}

TEST_F(Custody, TheSiteSignsOnlyWhatItIsSureOf) {
  begin();
  EXPECT_EQ(run({"sign", request()}), 2);
  EXPECT_EQ(run({"sign", request(), "--role", "doctor", "--host", "10.0.0.5"}), 2);
  EXPECT_EQ(run({"sign", request(), "--role", "boss"}), 2);
  EXPECT_EQ(run({"sign", request(), "--role", "doctor", "--name", "bert"}), 1);
  EXPECT_TRUE(says("the request is for the name anna, not for bert")) << text_of(log);
  EXPECT_EQ(run({"sign", (folder / "authority.crt").string(), "--role", "doctor"}), 1);
  EXPECT_TRUE(says("exactly one request")) << text_of(log);
  EXPECT_EQ(run_at_home({"sign", request(), "--role", "doctor"}), 1) << "the doctor's computer has no authority";
  EXPECT_TRUE(says("on the computer that makes keys")) << text_of(log);
  ASSERT_EQ(run({"sign", request(), "--role", "doctor"}), 0);
  EXPECT_EQ(run({"sign", request(), "--role", "technician"}), 1) << "one request, one certificate";
}

TEST_F(Custody, ACertificateIsRenewedForTheSameKeyButNotForARevokedOne) {
  begin();
  ASSERT_EQ(run({"sign", request(), "--role", "doctor"}), 0);
  const std::string certificate = (folder / "anna.crt").string(), first = text_of(certificate);
  ASSERT_EQ(run({"renew", certificate}), 0) << text_of(log);
  EXPECT_NE(text_of(certificate), first);
  fs::copy_file(certificate, home / "anna.crt");
  EXPECT_TRUE(load_key(home / "anna.key", std::chrono::system_clock::now()).ok());
  ASSERT_EQ(run({"revoke", certificate}), 0) << text_of(log);
  const auto revoked = Revocations::read(text_of(folder / "revoked.crl"), text_of(folder / "authority.crt"), "r");
  for (const std::string& one : {first, text_of(certificate)})
    EXPECT_TRUE(revoked->contains(read_public_part(one, "anna.crt")->identity.serial))
        << "the older certificate of a stolen key is as good as the newer one";
  EXPECT_EQ(run({"renew", certificate}), 1);
  EXPECT_TRUE(says("was revoked, so the key may be in wrong hands")) << text_of(log);
  fs::remove(certificate);
  EXPECT_EQ(run({"sign", request(), "--role", "doctor"}), 1) << "nor by the old request";
  EXPECT_TRUE(says("was revoked, so the key may be in wrong hands")) << text_of(log);
}

TEST_F(Custody, WhatNeedsNoPrivateKeyWorksWithoutTheAuthoritysFile) {
  begin();
  ASSERT_EQ(run({"sign", request(), "--role", "doctor"}), 0);
  fs::rename(folder / "authority.key", temporary.path() / "elsewhere");
  EXPECT_EQ(run({"list"}), 0) << text_of(log);
  EXPECT_TRUE(says("doctor anna")) << text_of(log);
  EXPECT_EQ(run({"show", (folder / "anna.crt").string()}), 0) << text_of(log);
  EXPECT_EQ(run({"revoke", (folder / "anna.crt").string()}), 1);
  EXPECT_TRUE(says("on the computer that makes keys")) << text_of(log);
}

TEST_F(Custody, APassphraseProtectsTheAuthorityAndEachKey) {
  ::setenv("TELEPALP_NEW_PASSPHRASE", "correct horse battery", 1);
  ASSERT_EQ(run({"authority", "--host", "10.0.0.5", "--passphrase"}), 0) << text_of(log);
  ::setenv("TELEPALP_PASSPHRASE", "wrong", 1);
  EXPECT_EQ(run({"client", "--name", "anna", "--role", "doctor"}), 1);
  EXPECT_TRUE(says("TELEPALP_PASSPHRASE or TELEPALP_PASSPHRASE_FILE gives is wrong")) << text_of(log);
  ::setenv("TELEPALP_PASSPHRASE", "correct horse battery", 1);
  ::setenv("TELEPALP_NEW_PASSPHRASE", "another long one", 1);
  ASSERT_EQ(run({"client", "--name", "anna", "--role", "doctor", "--passphrase"}), 0) << text_of(log);
  const fs::path anna = folder / "anna.key";
  EXPECT_FALSE(load_key(anna, std::chrono::system_clock::now(), passphrase_of_environment).ok());
  ::setenv("TELEPALP_PASSPHRASE", "another long one", 1);
  EXPECT_TRUE(load_key(anna, std::chrono::system_clock::now(), passphrase_of_environment).ok());
  ::setenv("TELEPALP_NEW_PASSPHRASE", "a third, longer one", 1);
  ASSERT_EQ(run({"passphrase", anna.string()}), 0) << text_of(log);
  EXPECT_FALSE(load_key(anna, std::chrono::system_clock::now(), passphrase_of_environment).ok());
  ::setenv("TELEPALP_PASSPHRASE", "a third, longer one", 1);
  EXPECT_TRUE(load_key(anna, std::chrono::system_clock::now(), passphrase_of_environment).ok());
  EXPECT_EQ(mode_of("anna.key"), 0600U);
}

TEST_F(Custody, APassphraseIsAskedForInTheTerminalAndNotShown) {
  ASSERT_EQ(run({"authority", "--host", "10.0.0.5"}), 0);
  const std::string program = TELEPALP_BINARY_DIR "/bin/telepalp-keys", file = (folder / "authority.key").string();
  const auto patience = std::chrono::seconds(120);
  const auto asks = [&](support::Terminal& terminal, const char* prompt) {
    return terminal.await_text(prompt, patience) && terminal.await_hidden_typing(patience);
  };
  const auto token = [&](const char* name) {
    return std::vector<std::string>{program, "token", "--name", name, "--role", "viewer", "--dir", folder.string()};
  };
  support::Terminal changed({program, "passphrase", file});
  ASSERT_TRUE(asks(changed, "new passphrase for")) << changed.shown();
  changed.type("correct horse battery\n");
  ASSERT_TRUE(asks(changed, "Verifying")) << changed.shown();
  changed.type("correct horse battery\n");
  EXPECT_EQ(changed.wait(patience), 0) << changed.shown();
  support::Terminal used(token("vera"));
  ASSERT_TRUE(asks(used, "passphrase of")) << used.shown();
  used.type("wrong horse\n");
  ASSERT_TRUE(asks(used, "wrong. passphrase of")) << used.shown();
  used.type("correct horse battery\n");
  EXPECT_EQ(used.wait(patience), 0) << used.shown();
  EXPECT_EQ((changed.shown() + used.shown()).find("horse"), std::string::npos) << changed.shown() << used.shown();
  support::Terminal left(token("walt"));
  ASSERT_TRUE(asks(left, "passphrase of")) << left.shown();
  left.type(support::kCtrlC);
  EXPECT_EQ(left.wait(patience), 1) << left.shown();
  EXPECT_FALSE(left.await_hidden_typing(std::chrono::milliseconds(50))) << "the terminal shows again what is typed";
}

TEST_F(Custody, AnAuthorityIsRenewedWithNewLimits) {
  ASSERT_EQ(run({"authority", "--host", "10.0.0.5"}), 0);
  ASSERT_EQ(run({"server", "--host", "10.0.0.5"}), 0);
  EXPECT_EQ(run({"server", "--name", "b", "--host", "patient.example"}), 1);
  const std::string file = (folder / "authority.key").string();
  EXPECT_EQ(run({"renew", file}), 1) << "without --host";
  ASSERT_EQ(run({"renew", file, "--host", "10.0.0.5", "--host", "patient.example"}), 0) << text_of(log);
  EXPECT_EQ(run({"server", "--name", "b", "--host", "patient.example"}), 0) << text_of(log);
  EXPECT_EQ(run({"renew", (folder / "server.key").string()}), 0) << "a key from before: " << text_of(log);
  EXPECT_EQ(run({"list"}), 0) << "revoked.crl stays valid: " << text_of(log);
}

}  // namespace
}  // namespace telepalp::keys
