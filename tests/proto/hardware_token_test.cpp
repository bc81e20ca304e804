// A private key in a PKCS#11 token, here SoftHSM (package softhsm2), through OpenSSL's engine (package
// libengine-pkcs11-openssl).

#include <openssl/pem.h>

#include <cstdlib>

#include "proto/keys/authority.h"
#include "proto/keys/key_file.h"
#include "proto/keys/secret/private_key.h"
#include "proto/keys/x509/openssl.h"
#include "tests/proto/handshake.h"
#include "tests/proto/keys_program.h"

namespace telepalp::keys {
namespace {

constexpr const char* kDriver = "/usr/lib/softhsm/libsofthsm2.so";
constexpr const char* kTool = "/usr/bin/softhsm2-util";

struct HardwareToken : KeysProgram {
  fs::path home = temporary.path() / "home";
  const std::string address = "pkcs11:token=ward;object=anna?module-path=" + std::string(kDriver);

  void SetUp() override {
    if (!fs::exists(kDriver) || !fs::exists(kTool)) GTEST_SKIP() << "apt install softhsm2 libengine-pkcs11-openssl";
    fs::create_directories(temporary.path() / "tokens");
    std::ofstream(temporary.path() / "softhsm2.conf")
        << "directories.tokendir = " << (temporary.path() / "tokens").string() << "\nlog.level = ERROR\n";
    ::setenv("SOFTHSM2_CONF", (temporary.path() / "softhsm2.conf").c_str(), 1);
    std::ofstream(temporary.path() / "key.pem") << make_private_key("")->text;
    ASSERT_EQ(softhsm({"--init-token", "--free", "--label", "ward", "--so-pin", "87654321", "--pin", "12345678"}), 0);
    ASSERT_EQ(softhsm({"--import", (temporary.path() / "key.pem").string(), "--token", "ward", "--label", "anna",
                       "--id", "01", "--pin", "12345678"}),
              0);
    fs::remove(temporary.path() / "key.pem");
    ::setenv("TELEPALP_PASSPHRASE", "12345678", 1);
  }
  ~HardwareToken() override { ::unsetenv("TELEPALP_PASSPHRASE"); }

  int softhsm(const std::vector<std::string>& words) const {
    return support::ChildProcess(kTool, words, log).wait(std::chrono::seconds(30)).value_or(-1);
  }
  int keys_at_home(std::vector<std::string> words) const {
    words.insert(words.end(), {"--dir", home.string()});
    return support::ChildProcess(fs::path(TELEPALP_BINARY_DIR "/bin/telepalp-keys"), words, log)
        .wait(std::chrono::seconds(30))
        .value_or(-1);
  }
};

TEST_F(HardwareToken, HoldsTheKeyOfAPersonWhoSignsInWithIt) {
  ASSERT_EQ(run({"authority", "--host", "10.0.0.5"}), 0) << text_of(log);
  ASSERT_EQ(run({"server", "--host", "10.0.0.5"}), 0) << text_of(log);
  ASSERT_EQ(keys_at_home({"request", "--name", "anna", "--key", address}), 0) << text_of(log);
  EXPECT_EQ(text_of(home / "anna.key").find("PRIVATE KEY"), std::string::npos) << "the key stays in the token";
  ASSERT_EQ(run({"sign", (home / "anna.request").string(), "--role", "doctor"}), 0) << text_of(log);
  fs::copy_file(folder / "anna.crt", home / "anna.crt");
  const WallTime now = std::chrono::system_clock::now();
  const Result<KeyFile> anna = load_key(home / "anna.key", now);
  ASSERT_TRUE(anna.ok()) << to_string(anna.error());
  EXPECT_EQ(anna->secret, Secret::Token);
  const KeyFile server = *load_key(folder / "server.key", now);
  EXPECT_TRUE(shake_hands(server, *anna, "10.0.0.5"));
  // The same by its address alone: the certificates are then in the working folder.
  const fs::path before = fs::current_path();
  fs::current_path(home);
  const Result<KeyFile> by_address = load_key(address, now);
  fs::current_path(before);
  ASSERT_TRUE(by_address.ok()) << to_string(by_address.error());
  EXPECT_TRUE(shake_hands(server, *by_address, "10.0.0.5"));
}

TEST_F(HardwareToken, RefusesAWrongPinAndAKeyThatItDoesNotHave) {
  const std::string driver = "?module-path=" + std::string(kDriver);
  const auto refuses = [&](const std::string& where) {
    return keys_at_home({"request", "--name", "bert", "--key", where}) == 1 && !fs::exists(home / "bert.key");
  };
  const auto says = [&](const std::string& text) { return text_of(log).find(text) != std::string::npos; };
  ::setenv("TELEPALP_PASSPHRASE", "11111111", 1);
  EXPECT_TRUE(refuses(address) && says("the token has no such key, or the PIN is wrong")) << text_of(log);
  ::setenv("TELEPALP_PASSPHRASE", "12345678", 1);
  EXPECT_TRUE(refuses("pkcs11:token=ward;object=bert" + driver) && says("no such key")) << text_of(log);
  EXPECT_TRUE(refuses("pkcs11:token=ward;object=anna?module-path=/none.so")) << text_of(log);
  EXPECT_TRUE(refuses("pkcs11:token=ward;object=anna?pin-value=12345678") && says("must not have the PIN"))
      << text_of(log);
}

}  // namespace
}  // namespace telepalp::keys
