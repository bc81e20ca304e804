#include "server/oidc/token/id_token.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "server/oidc/provider.h"
#include "server/oidc/web/web_address.h"
#include "tests/server/oidc/signing_key.h"

namespace telepalp::oidc {
namespace {

using std::chrono::seconds;

const keys::WallTime kNow{seconds(1'900'000'000)};
const Expected kExpected{.issuer = "https://login.example", .client_id = "telepalp", .nonce = "n0", .now = kNow};

std::string header(const std::string& algorithm, const std::string& id = "one", const std::string& more = "") {
  return R"({"alg":")" + algorithm + R"(","kid":")" + id + "\"" + more + "}";
}

/// The claims of a good token, with the values of `changed` where it has some; the value "null" leaves the claim out.
std::string claims(const std::map<std::string, std::string>& changed = {}) {
  std::map<std::string, std::string> all{{"iss", R"("https://login.example")"},
                                         {"sub", R"("248289")"},
                                         {"aud", R"("telepalp")"},
                                         {"nonce", R"("n0")"},
                                         {"exp", "1900000300"},
                                         {"iat", "1900000000"},
                                         {"groups", R"(["ward","doctors"])"},
                                         {"preferred_username", R"("anna")"}};
  for (const auto& [name, value] : changed) all[name] = value;
  std::string json;
  for (const auto& [name, value] : all)
    if (value != "null") json += (json.empty() ? "{" : ",") + ("\"" + name + "\":") + value;
  return json + "}";
}

Claims key_set(const std::vector<std::string>& keys) {
  std::string json = "{\"keys\":[";
  for (const std::string& key : keys) json += (json.ends_with('[') ? "" : ",") + key;
  return *read_claims(json + "]}", "test");
}

const SigningKey& rsa() {
  static const SigningKey key = SigningKey::rsa();
  return key;
}
const SigningKey& curve() {
  static const SigningKey key = SigningKey::p256();
  return key;
}
const Claims& provider_keys() {
  static const Claims keys = key_set({rsa().jwk("one"), curve().jwk("two")});
  return keys;
}

std::string why_refused(const std::string& token, const Claims& keys = provider_keys()) {
  const Result<Claims> checked = check_id_token(token, keys, kExpected);
  return checked ? "" : checked.error().what;
}

TEST(IdToken, IsTakenWithEachOfTheThreeAlgorithms) {
  EXPECT_EQ(why_refused(rsa().sign(header("RS256"), claims())), "");
  EXPECT_EQ(why_refused(rsa().sign(header("PS256"), claims(), true)), "");
  EXPECT_EQ(why_refused(curve().sign(header("ES256", "two"), claims())), "");
  const Result<Claims> checked = check_id_token(rsa().sign(header("RS256"), claims()), provider_keys(), kExpected);
  EXPECT_EQ(text_of(*checked, "sub"), "248289");
}

struct ClaimCase {
  const char* what;
  std::map<std::string, std::string> changed;
  const char* why;  // empty: it is taken
};
const ClaimCase kClaimCases[] = {
    {"another issuer", {{"iss", R"("https://login.example/")"}}, "another issuer"},
    {"no issuer", {{"iss", "null"}}, "another issuer"},
    {"another client", {{"aud", R"("other")"}}, "another client"},
    {"no client", {{"aud", "[]"}}, "another client"},
    {"several clients, made for ours", {{"aud", R"(["other","telepalp"])"}, {"azp", R"("telepalp")"}}, ""},
    {"several clients, none named", {{"aud", R"(["other","telepalp"])"}}, "made for another client"},
    {"made for another client", {{"azp", R"("other")"}}, "made for another client"},
    {"another log-in", {{"nonce", R"("n1")"}}, "another log-in"},
    {"no nonce", {{"nonce", "null"}}, "another log-in"},
    {"just expired, within the clocks' error", {{"exp", "1899999941"}}, ""},
    {"expired", {{"exp", "1899999940"}}, "expired"},
    {"no expiry", {{"exp", "null"}}, "expired"},
    {"expiry that is a text", {{"exp", R"("1900000300")"}}, "expired"},
    {"expiry beyond all numbers", {{"exp", R"("NaN")"}}, "expired"},
    {"of the future", {{"iat", "1900000061"}}, "not valid yet"},
    {"not before the future", {{"nbf", "1900000061"}}, "not valid yet"},
    {"nobody", {{"sub", "null"}}, "names nobody"},
    {"a number for a person", {{"sub", "7"}}, "names nobody"},
    {"a person's number that is too long", {{"sub", '"' + std::string(256, '7') + '"'}}, "names nobody"},
};

TEST(IdToken, EachClaimIsChecked) {
  for (const ClaimCase& one : kClaimCases) {
    const std::string why = why_refused(rsa().sign(header("RS256"), claims(one.changed)));
    EXPECT_EQ(why.empty(), std::string_view(one.why).empty()) << one.what << ": " << why;
    EXPECT_NE(why.find(one.why), std::string::npos) << one.what << ": " << why;
  }
}

TEST(IdToken, ATokenWithoutASignatureOfTheProviderIsRefused) {
  const std::string text = base64url(header("none")) + "." + base64url(claims()) + ".";
  EXPECT_NE(why_refused(text), "");
  EXPECT_NE(why_refused(rsa().sign(header("none"), claims())).find("not signed with RS256"), std::string::npos);
  EXPECT_NE(why_refused(rsa().sign(header("RS512"), claims())).find("not signed with RS256"), std::string::npos);
  EXPECT_NE(why_refused(SigningKey::rsa().sign(header("RS256"), claims())).find("wrong signature"), std::string::npos);
  EXPECT_NE(why_refused(curve().sign(header("RS256"), claims())), "") << "a signature of another kind";
  EXPECT_NE(why_refused(rsa().sign(header("ES256", "two"), claims())), "");
  EXPECT_NE(why_refused(rsa().sign(header("RS256", "one", R"(,"crit":["b64"],"b64":false)"), claims())), "");
}

/// Whoever knows the public key could sign with it, if the key were taken for a shared secret.
TEST(IdToken, ThePublicKeyIsNoSharedSecret) {
  const std::string text = base64url(header("HS256")) + "." + base64url(claims());
  const std::string secret = rsa().jwk("one");
  unsigned char code[32];
  HMAC(EVP_sha256(), secret.data(), static_cast<int>(secret.size()),
       reinterpret_cast<const unsigned char*>(text.data()), text.size(), code, nullptr);
  const std::string token = text + "." + base64url({reinterpret_cast<const char*>(code), sizeof code});
  EXPECT_NE(why_refused(token).find("not signed with RS256"), std::string::npos);
  const Claims shared = key_set({R"({"kty":"oct","kid":"one","k":")" + base64url(secret) + "\"}"});
  EXPECT_NE(why_refused(token, shared), "");
}

TEST(IdToken, TheKeyThatItNamesMustBeKnownAndStrongAndForSignatures) {
  const std::string token = rsa().sign(header("RS256"), claims());
  EXPECT_TRUE(has_key_of(token, provider_keys()));
  const std::string unknown = rsa().sign(header("RS256", "three"), claims());
  EXPECT_FALSE(has_key_of(unknown, provider_keys())) << "the keys are fetched again";
  EXPECT_NE(why_refused(unknown).find("none of the provider's keys"), std::string::npos);
  const std::string unnamed = rsa().sign(R"({"alg":"RS256"})", claims());
  EXPECT_EQ(why_refused(unnamed), "") << "one key can have signed it";
  EXPECT_NE(why_refused(unnamed, key_set({rsa().jwk("one"), SigningKey::rsa().jwk("two")})), "") << "which of the two?";
  EXPECT_NE(why_refused(token, key_set({rsa().jwk("one", R"(,"alg":"PS256")")})), "");
  EXPECT_NE(why_refused(token, key_set({R"({"kty":"RSA","kid":"one","use":"enc"})"})), "");
  const SigningKey weak = SigningKey::rsa(1024);
  EXPECT_NE(why_refused(weak.sign(header("RS256"), claims()), key_set({weak.jwk("one")})), "");
  for (const char* keys : {"{}", R"({"keys":7})", R"({"keys":[7,null,{}]})", R"({"keys":[{"kty":"RSA","kid":"one"}]})",
                           R"({"keys":[{"kty":"RSA","kid":"one","n":"","e":"AQAB"}]})",
                           R"({"keys":[{"kty":"RSA","kid":"one","n":"!!","e":"AQAB"}]})"})
    EXPECT_NE(why_refused(token, *read_claims(keys, "test")), "") << keys;
}

TEST(IdToken, CutShortOrTooLongOrDamagedItIsRefused) {
  const std::string token = curve().sign(header("ES256", "two"), claims());
  for (std::size_t size = 0; size < token.size(); ++size) EXPECT_NE(why_refused(token.substr(0, size)), "") << size;
  EXPECT_NE(why_refused(rsa().sign(header("RS256"), claims({{"groups", '"' + std::string(13'000, 'g') + '"'}}))), "");
  EXPECT_EQ(why_refused(rsa().sign(header("RS256"), claims({{"groups", '"' + std::string(8'000, 'g') + '"'}}))), "");
  EXPECT_NE(why_refused(rsa().sign(header("RS256"), "7")), "");
  EXPECT_NE(why_refused(rsa().sign(header("RS256"), std::string(9'000, '['))), "");
  std::mt19937 random(7);
  for (int i = 0; i < 500; ++i) {
    std::string damaged = token;
    char& letter = damaged[random() % damaged.size()];
    const bool is_last = &letter == &damaged.back();  // its last bits are of no byte
    letter = letter == 'A' ? 'B' : 'A';
    EXPECT_TRUE(is_last || !why_refused(damaged).empty()) << i;
  }
}

Settings settings_of(std::vector<Rule> rules) {
  Settings settings;
  settings.issuer = "https://login.example";
  settings.rules = std::move(rules);
  return settings;
}

TEST(Person, TheFirstRuleThatFitsGivesTheRole) {
  const Claims who = *read_claims(
      claims({{"realm_access", R"({"roles":["qa"]})"}, {"https://x.example/role", R"("technician")"}}), "test");
  const auto role = [&](std::vector<Rule> rules) -> std::optional<keys::Role> {
    const Result<Person> person = person_of(who, settings_of(std::move(rules)), kNow);
    return person ? std::optional(person->who.role) : std::nullopt;
  };
  EXPECT_EQ(role({{"groups", "doctors", keys::Role::Doctor}, {"groups", "ward", keys::Role::Viewer}}),
            keys::Role::Doctor);
  EXPECT_EQ(role({{"groups", "ward", keys::Role::Viewer}, {"groups", "doctors", keys::Role::Doctor}}),
            keys::Role::Viewer);
  EXPECT_EQ(role({{"realm_access.roles", "qa", keys::Role::Qa}}), keys::Role::Qa);
  EXPECT_EQ(role({{"https://x.example/role", "technician", keys::Role::Technician}}), keys::Role::Technician);
  EXPECT_EQ(role({{"groups", "doctor", keys::Role::Doctor}}), std::nullopt) << "a part of a group's name is no group";
  EXPECT_EQ(role({{"group", "doctors", keys::Role::Doctor}}), std::nullopt);
  EXPECT_EQ(role({{"realm_access", "roles", keys::Role::Doctor}}), std::nullopt);
}

TEST(Person, HasANameThatNoLineOfALogConfusesAndANumberOfIssuerAndSubject) {
  const auto named = [](const std::string& name, const std::string& subject = R"("248289")") {
    const Claims who = *read_claims(claims({{"preferred_username", name}, {"sub", subject}}), "test");
    return person_of(who, settings_of({{"groups", "doctors", keys::Role::Doctor}}), kNow)->who;
  };
  EXPECT_EQ(named(R"("anna.b-c@ward")").name, "anna.b-c@ward");
  const std::string serial = named(R"("anna")").serial;
  EXPECT_EQ(serial.size(), 40U);
  EXPECT_EQ(serial.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(named(R"("bob")").serial, serial) << "a person who is renamed stays the same person";
  EXPECT_NE(named(R"("anna")", R"("248290")").serial, serial);
  EXPECT_EQ(named(R"("a b\nevent=\"x\"")").name, "a_b_event__x_-" + serial.substr(0, 6));
  EXPECT_EQ(named("null").name, "person-" + serial.substr(0, 6));
  EXPECT_LE(named('"' + std::string(500, 'n') + '"').name.size(), 64U);
  EXPECT_EQ(named(R"("anna")").expires, kNow + std::chrono::hours(8));
}

TEST(WebAddress, OnlyHttpsOrThisMachineAndNothingThatNeedsAnEscape) {
  for (const char* good : {"https://a.example", "https://a.example:8443/x?y=z", "http://127.0.0.1:9/x",
                           "http://localhost:4000", "http://[::1]:80/"})
    EXPECT_TRUE(is_safe_address(good)) << good;
  for (const char* bad :
       {"", "https://", "https:///x", "http://a.example", "http://127.0.0.1.example", "ftp://a", "file:///etc/passwd",
        "https://a\"><script>", "https://a b", "https://a@b", "https://a\r\nX: y", "http://localhost@evil.example",
        "http://[::1", "http://[", "javascript:alert(1)", "HTTPS://a"})
    EXPECT_FALSE(is_safe_address(bad)) << bad;
  EXPECT_FALSE(is_safe_address("https://" + std::string(1024, 'a')));
  EXPECT_TRUE(is_https_origin("https://a.example:8443"));
  for (const char* bad :
       {"https://a.example/", "http://localhost", "https://a?b", "https://a#b", "https://a:443", "https://A"})
    EXPECT_FALSE(is_https_origin(bad)) << bad;
  EXPECT_EQ(percent_encoded("a b&c=ü/~"), "a%20b%26c%3D%C3%BC%2F~");
}

}  // namespace
}  // namespace telepalp::oidc
