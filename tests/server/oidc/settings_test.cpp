#include "server/oidc/settings.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/child_process.h"

namespace telepalp::oidc {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGood = R"(issuer: "https://login.hospital.example/staff"
client_id: "telepalp"
client_secret_file: "secret"
page: "https://tele.hospital.example:8443"
scope: "groups"
rule { claim: "groups" value: "palpation-doctors" role: "doctor" }
rule { claim: "realm_access.roles" value: "it" role: "technician" }
)";

class SettingsFile : public ::testing::Test {
 protected:
  Result<Settings> read(const std::string& text) {
    std::ofstream(file_) << text;
    return read_settings(file_);
  }
  /// kGood with `from` replaced.
  Result<Settings> read(const std::string& from, const std::string& to) {
    std::string text = kGood;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return read(text.replace(at, from.size(), to));
  }
  void write_secret(const std::string& text, fs::perms mode = fs::perms::owner_read | fs::perms::owner_write) {
    const fs::path file = folder_.path() / "secret";
    std::ofstream(file) << text;
    fs::permissions(file, mode);
  }
  void SetUp() override { write_secret("s3cret\n"); }

  support::TemporaryFolder folder_;
  fs::path file_ = folder_.path() / "hospital.sign_in.textproto";
};

TEST_F(SettingsFile, SaysAllThatASignInNeeds) {
  const Result<Settings> settings = read(kGood);
  ASSERT_TRUE(settings) << to_string(settings.error());
  EXPECT_EQ(settings->issuer, "https://login.hospital.example/staff");
  EXPECT_EQ(settings->client_secret, "s3cret");
  EXPECT_EQ(settings->back(), "https://tele.hospital.example:8443/sign-in/back");
  EXPECT_EQ(settings->scope, "openid profile groups");
  EXPECT_EQ(settings->name_claim, "preferred_username");
  EXPECT_EQ(settings->longest, std::chrono::hours(8));
  ASSERT_EQ(settings->rules.size(), 2U);
  EXPECT_EQ(settings->rules[1].claim, "realm_access.roles");
  EXPECT_EQ(settings->rules[1].role, keys::Role::Technician);
  EXPECT_TRUE(read("client_secret_file: \"secret\"\n", "")->client_secret.empty());
  EXPECT_EQ(read("scope:", "longest_hours: 0.5\nscope:")->longest, std::chrono::minutes(30));
}

struct BadCase {
  const char* from;
  const char* to;
  const char* where;  // after the file's name
  const char* what;
};
const BadCase kBadCases[] = {
    {"issuer:", "isuer:", ":1:", "isuer"},
    {"https://login", "http://login", ":1:", "issuer is not an address"},
    {"/staff", "/staff?x", ":1:", "issuer is not an address"},
    {"/staff", "/st aff", ":1:", "issuer is not an address"},
    {"\"telepalp\"", "\"\"", "", "no client_id"},
    {"client_id: \"telepalp\"", "", "", "no client_id"},
    {":8443", "/", ":4:", "the page is not https://"},
    {"https://tele", "http://tele", ":4:", "the page is not https://"},
    {"\"groups\"\n", "\"two words\"\n", "", "'two words' is no scope"},
    {"scope:", "longest_hours: 13\nscope:", ":5:", "longest_hours is 13"},
    {"scope:", "longest_hours: nan\nscope:", ":5:", "longest_hours is nan"},
    {"scope:", "longest_hours: -1\nscope:", ":5:", "longest_hours is -1"},
    {"role: \"doctor\"", "role: \"surgeon\"", ":6:", "'surgeon' is no role"},
    {"role: \"doctor\"", "role: \"local\"", ":6:", "'local' is no role"},
    {"role: \"doctor\"", "", ":6:", "'' is no role"},
    {"value: \"it\"", "", ":7:", "no claim or no value"},
    {"claim: \"realm_access.roles\"", "", ":7:", "no claim or no value"},
    {"scope:", "authority_file: \"none.pem\"\nscope:", ":5:", "none.pem cannot be read"},
    {"rule {", "rule", ":6:", ""},
};

TEST_F(SettingsFile, EachMistakeIsNamedWithItsPlace) {
  for (const BadCase& bad : kBadCases) {
    const Result<Settings> settings = read(bad.from, bad.to);
    ASSERT_FALSE(settings) << bad.to;
    const Error& error = settings.error();
    EXPECT_TRUE(error.where.starts_with(file_.string() + bad.where)) << bad.to << ": " << to_string(error);
    EXPECT_NE(error.what.find(bad.what), std::string::npos) << bad.to << ": " << to_string(error);
    EXPECT_FALSE(error.fix.empty()) << bad.to;
  }
  EXPECT_FALSE(read(std::string(kGood).substr(0, std::string(kGood).find("rule")))) << "nobody could sign in";
  EXPECT_FALSE(read_settings(folder_.path() / "none"));
}

TEST_F(SettingsFile, TheSecretIsOneLineThatOthersCannotRead) {
  for (const std::string& bad :
       {std::string(), std::string("\n"), std::string("two\nlines"), std::string("\x01\x02"), std::string(1025, 's')}) {
    write_secret(bad);
    EXPECT_FALSE(read(kGood)) << bad.substr(0, 20);
  }
  write_secret(std::string(1024, 's'));
  EXPECT_TRUE(read(kGood));
  write_secret("s3cret", fs::perms::owner_read | fs::perms::others_read);
  EXPECT_NE(to_string(read(kGood).error()).find("users other than its owner"), std::string::npos);
  fs::remove(folder_.path() / "secret");
  EXPECT_FALSE(read(kGood));
}

}  // namespace
}  // namespace telepalp::oidc
