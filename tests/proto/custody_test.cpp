// A private key stays with its holder, behind a passphrase, and an authority signs for its own hosts alone: what each
// of these refuses.

#include <gtest/gtest.h>
#include <openssl/core_names.h>
#include <openssl/ec.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <random>

#include "proto/keys/authority.h"
#include "proto/keys/certificate.h"
#include "proto/keys/key_file.h"
#include "proto/keys/request/key_request.h"
#include "proto/keys/secret/pkcs11.h"
#include "proto/keys/web_certificate.h"
#include "tests/proto/handshake.h"
#include "tests/support/child_process.h"

namespace telepalp::keys {
namespace {

using std::chrono::days;
const WallTime kToday = std::chrono::system_clock::now();

// --- requests ---

using RequestPtr = std::unique_ptr<X509_REQ, Freed<X509_REQ_free>>;

/// What a stranger may put into a request.
struct Forged {
  std::vector<std::string> names{"anna"};
  std::string alt_names{};
  const EVP_MD* digest = EVP_sha256();
  EVP_PKEY* signs = nullptr;  ///< null: the key itself
};

std::string forge(EVP_PKEY& key, const Forged& what = {}) {
  const RequestPtr request(X509_REQ_new());
  X509_NAME* const subject = X509_REQ_get_subject_name(request.get());
  for (const std::string& name : what.names)
    X509_NAME_add_entry_by_NID(subject, NID_commonName, MBSTRING_UTF8,
                               reinterpret_cast<const unsigned char*>(name.data()), static_cast<int>(name.size()), -1,
                               0);
  if (!what.alt_names.empty()) {
    STACK_OF(X509_EXTENSION)* all = sk_X509_EXTENSION_new_null();
    sk_X509_EXTENSION_push(all, X509V3_EXT_conf_nid(nullptr, nullptr, NID_subject_alt_name, what.alt_names.c_str()));
    X509_REQ_add_extensions(request.get(), all);
    sk_X509_EXTENSION_pop_free(all, X509_EXTENSION_free);
  }
  X509_REQ_set_pubkey(request.get(), &key);
  X509_REQ_sign(request.get(), what.signs == nullptr ? &key : what.signs, what.digest);
  const BytesPtr bytes(BIO_new(BIO_s_mem()));
  PEM_write_bio_X509_REQ(bytes.get(), request.get());
  return text_in(*bytes);
}

PrivateKeyPtr key_on(const char* curve) { return PrivateKeyPtr(EVP_EC_gen(curve)); }

/// P-256 by its parameters instead of its name.
PrivateKeyPtr key_by_parameters() {
  PrivateKeyPtr key = key_on("P-256");
  EXPECT_EQ(EVP_PKEY_set_utf8_string_param(key.get(), OSSL_PKEY_PARAM_EC_ENCODING, "explicit"), 1);
  return key;
}

std::string refusal(const std::string& text) {
  const Result<KeyRequest> read = read_request(text, "anna.request");
  return read ? "" : read.error().what;
}

TEST(KeyRequests, StateANameAndAKey) {
  const OwnKey own = *make_private_key("");
  const std::string text = *make_request("anna", *own.key);
  const Result<KeyRequest> read = read_request(text, "anna.request");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->name, "anna");
  EXPECT_EQ(EVP_PKEY_eq(read->key.get(), own.key.get()), 1);
  EXPECT_NE(text.find(fingerprint(*own.key)), std::string::npos) << "two people compare it";
  EXPECT_EQ(secret_in(text), Secret::None);
}

TEST(KeyRequests, OnlyTheHolderOfTheKeyCanMakeOne) {
  const PrivateKeyPtr hers = key_on("P-256"), mine = key_on("P-256");
  EXPECT_NE(refusal(forge(*hers, {.signs = mine.get()})).find("not signed with its own key"), std::string::npos);
  EXPECT_NE(refusal(forge(*hers, {.digest = EVP_sha1()})).find("not signed with its own key"), std::string::npos);
}

TEST(KeyRequests, OtherKindsOfKeysAreRefused) {
  const PrivateKeyPtr rsa(EVP_RSA_gen(2048)), ed(EVP_PKEY_Q_keygen(nullptr, nullptr, "ED25519"));
  const PrivateKeyPtr p384 = key_on("P-384"), described = key_by_parameters();
  for (EVP_PKEY* const key : {rsa.get(), p384.get(), described.get()})
    EXPECT_NE(refusal(forge(*key)).find("not on the curve P-256"), std::string::npos);
  EXPECT_NE(refusal(forge(*ed, {.digest = nullptr})).find("not on the curve P-256"), std::string::npos);
}

TEST(KeyRequests, DoNotCarryNamesThatAKeyCannotHave) {
  const PrivateKeyPtr key = key_on("P-256");
  const std::vector<std::vector<std::string>> wrong{
      {}, {"anna", "bert"}, {"a/b"}, {"a b"}, {std::string("anna\0x", 6)}, {std::string(64, 'x') + "y"}};
  for (const auto& names : wrong) EXPECT_NE(refusal(forge(*key, {.names = names})), "") << names.size();
}

TEST(KeyRequests, AreOneBlockOfBoundedSize) {
  const PrivateKeyPtr key = key_on("P-256");
  const std::string good = forge(*key);
  EXPECT_EQ(refusal(good), "");
  EXPECT_NE(refusal(good + good).find("exactly one request"), std::string::npos);
  EXPECT_NE(refusal(to_pem(*key)).find("exactly one request"), std::string::npos);
  EXPECT_NE(refusal("").find("exactly one request"), std::string::npos);
  EXPECT_NE(refusal(good + std::string(kMaxRequestBytes, ' ')).find("more than"), std::string::npos);
}

TEST(KeyRequests, NoAlteredByteMakesAnotherRequest) {
  const PrivateKeyPtr key = key_on("P-256");
  const std::string good = forge(*key);
  std::mt19937 random(31);
  for (int round = 0; round < 300; ++round) {
    std::string altered = good;
    altered[random() % altered.size()] ^= static_cast<char>(1U << (random() % 7));
    const Result<KeyRequest> read = read_request(altered, "anna.request");
    EXPECT_TRUE(!read || (read->name == "anna" && EVP_PKEY_eq(read->key.get(), key.get()) == 1)) << "round " << round;
  }
}

TEST(KeyRequests, RolesAndHostsThatTheyAskForAreIgnored) {
  const PrivateKeyPtr key = key_on("P-256");
  const Authority by = *Authority::create("test", kToday, days(30), {"10.0.0.5"});
  const auto request =
      read_request(forge(*key, {.alt_names = "URI:telepalp:role:technician,DNS:bank.example,IP:10.0.0.5"}), "r");
  ASSERT_TRUE(request.ok());
  const std::string answer =
      *by.client_key({.name = request->name, .role = Role::Viewer, .now = kToday, .key = request->key});
  const Result<KeyFile> signed_key = read_public_part(answer, "anna.crt");
  ASSERT_TRUE(signed_key.ok());
  EXPECT_EQ(describe(signed_key->identity), "viewer anna");
  EXPECT_TRUE(signed_key->hosts.empty());
  EXPECT_EQ(signed_key->secret, Secret::None) << "the site never has the private key";
  EXPECT_FALSE(read_key(answer, "anna.crt").ok()) << "and nobody connects with the certificate alone";
}

// --- two files ---

struct Folder {
  support::TemporaryFolder temporary;
  std::filesystem::path write(const std::string& name, const std::string& text, mode_t mode = 0600) const {
    const std::filesystem::path file = temporary.path() / name;
    std::ofstream(file) << text;
    EXPECT_EQ(::chmod(file.c_str(), mode), 0);
    return file;
  }
};

TEST(KeyFiles, APrivateKeyIsUsedWithTheCertificateBesideItAndNoOther) {
  const Folder folder;
  const Authority by = *Authority::create("test", kToday, days(30));
  const OwnKey anna = *make_private_key(""), bert = *make_private_key("");
  const auto answer = [&](const OwnKey& key) {
    return *by.client_key({.name = "anna", .role = Role::Doctor, .now = kToday, .key = key.key});
  };
  const auto file = folder.write("anna.key", anna.text);
  const Result<KeyFile> waits = load_key(file, kToday);
  ASSERT_FALSE(waits.ok());
  EXPECT_NE(waits.error().what.find("has no certificate yet"), std::string::npos) << waits.error().what;
  folder.write("anna.crt", answer(anna));
  const Result<KeyFile> key = load_key(file, kToday);
  ASSERT_TRUE(key.ok()) << key.error().what;
  EXPECT_EQ(describe(key->identity), "doctor anna");
  const KeyFile server = *read_key(*by.server_key({.name = "s", .now = kToday}, {"10.0.0.5"}), "server.key");
  EXPECT_TRUE(shake_hands(server, *key, "10.0.0.5"));
  folder.write("anna.crt", answer(bert));
  const Result<KeyFile> mixed = load_key(file, kToday);
  ASSERT_FALSE(mixed.ok());
  EXPECT_NE(mixed.error().what.find("do not belong together"), std::string::npos) << mixed.error().what;
}

// --- passphrases ---

AskPassphrase typing(std::vector<std::string> typed, int* asked = nullptr) {
  return [typed = std::move(typed), asked](const std::string&, int attempt) -> Result<std::string> {
    if (asked != nullptr) ++*asked;
    if (static_cast<std::size_t>(attempt) < typed.size()) return typed[static_cast<std::size_t>(attempt)];
    return Error{.what = "no more", .where = "", .fix = ""};
  };
}

TEST(Passphrases, OpenAKeyAndNothingElseDoes) {
  const Authority by = *Authority::create("test", kToday, days(30));
  const OwnKey own = *make_private_key("correct horse battery");
  const std::string text = *by.client_key({.name = "anna", .role = Role::Doctor, .now = kToday, .own = own});
  EXPECT_NE(text.find("BEGIN ENCRYPTED PRIVATE KEY"), std::string::npos);
  EXPECT_FALSE(read_key(text, "anna.key").ok());
  EXPECT_EQ(read_key(text, "anna.key", typing({"wrong", "Correct horse battery"})).error().what, "no more");
  int asked = 0;
  const Result<KeyFile> key = read_key(text, "anna.key", typing({"wrong", "correct horse battery"}, &asked));
  ASSERT_TRUE(key.ok());
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(EVP_PKEY_eq(key->private_key.get(), own.key.get()), 1);
  const Result<KeyFile> shown = read_public_part(text, "anna.key");
  ASSERT_TRUE(shown.ok()) << "whoever forgot the passphrase can still revoke the key";
  EXPECT_NE(in_words(*shown).find("protection: a passphrase"), std::string::npos) << in_words(*shown);
}

TEST(Passphrases, AnAuthoritysFileIsOpenedByItsOwn) {
  const Authority by = *Authority::create("test", kToday, days(30), {"10.0.0.5"}, *make_private_key("correct horse"));
  EXPECT_FALSE(Authority::read(by.file_text(), "authority.key").ok());
  EXPECT_FALSE(Authority::read(by.file_text(), "authority.key", typing({"wrong"})).ok());
  const Result<Authority> read = Authority::read(by.file_text(), "authority.key", typing({"correct horse"}));
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->file_text(), by.file_text()) << "it stays encrypted";
}

struct PassphraseVariables : testing::Test {
  Folder folder;
  ~PassphraseVariables() override {
    for (const char* name : {"TELEPALP_PASSPHRASE", "TELEPALP_PASSPHRASE_FILE", "TELEPALP_NEW_PASSPHRASE"})
      ::unsetenv(name);
  }
};

TEST_F(PassphraseVariables, GiveThePassphraseOfAService) {
  ::setenv("TELEPALP_PASSPHRASE_FILE", folder.write("passphrase", "correct horse\nsecond line\n").c_str(), 1);
  EXPECT_EQ(*passphrase_of_environment("server.key", 0), "correct horse");
  const Result<std::string> again = passphrase_of_environment("server.key", 1);
  ASSERT_FALSE(again.ok()) << "a wrong one is not tried for ever";
  EXPECT_NE(again.error().what.find("is wrong"), std::string::npos) << again.error().what;
  ::setenv("TELEPALP_PASSPHRASE_FILE", folder.write("open", "correct horse\n", 0644).c_str(), 1);
  EXPECT_NE(passphrase_of_environment("server.key", 0).error().what.find("every user"), std::string::npos);
  ::setenv("TELEPALP_PASSPHRASE_FILE", folder.write("empty", "\n").c_str(), 1);
  EXPECT_FALSE(passphrase_of_environment("server.key", 0).ok());
  ::setenv("TELEPALP_PASSPHRASE_FILE", folder.write("long", std::string(300, 'x')).c_str(), 1);
  EXPECT_FALSE(passphrase_of_environment("server.key", 0).ok());
  ::setenv("TELEPALP_NEW_PASSPHRASE", "too short", 1);
  EXPECT_NE(new_passphrase("server.key").error().what.find("shorter than 12"), std::string::npos);
}

// --- the limits of an authority ---

/// A server's certificate that somebody made with a stolen `authority.key`, without telepalp-keys.
KeyFile forged_server(const Authority& by, const std::string& names, const std::string& usage = "serverAuth") {
  const OwnKey thief = *open_private_key(by.file_text(), "authority.key", {});
  const CertificatePtr authority = std::move(certificates_in(by.certificate()).front());
  const OwnKey own = *make_private_key("");
  const CertificatePtr made = *make_certificate({.name = "bank",
                                                 .alt_names = names,
                                                 .usage = usage,
                                                 .serial = random_serial(),
                                                 .from = kToday - days(1),
                                                 .until = kToday + days(1)},
                                                *own.key, authority.get(), *thief.key);
  return *read_key(to_pem(*made) + own.text + by.certificate(), "bank");
}

TEST(LimitedAuthority, IsNotBelievedForAnotherName) {
  const Authority by = *Authority::create("test", kToday, days(30), {"hospital.example", "10.0.0.0/8", "fd00::/8"});
  EXPECT_EQ(by.hosts(),
            (std::vector<std::string>{"hospital.example", "10.0.0.0/8", "fd00::/8", "localhost", "127.0.0.1", "::1"}));
  const KeyFile client = *read_key(*by.client_key({.name = "anna.huber", .role = Role::Viewer, .now = kToday}), "a");
  struct Row {
    const char* names;
    const char* host;
    bool believed;
  };
  for (const Row& row :
       {Row{"DNS:ward.hospital.example", "ward.hospital.example", true},
        Row{"DNS:hospital.example", "hospital.example", true}, Row{"IP:10.1.2.3", "10.1.2.3", true},
        Row{"IP:fd00::5", "fd00::5", true}, Row{"DNS:localhost,IP:127.0.0.1", "127.0.0.1", true},
        Row{"DNS:bank.example", "bank.example", false}, Row{"DNS:nothospital.example", "nothospital.example", false},
        Row{"DNS:hospital.example.evil", "hospital.example.evil", false}, Row{"IP:11.0.0.1", "11.0.0.1", false},
        Row{"IP:2001:db8::1", "2001:db8::1", false},
        Row{"DNS:hospital.example,DNS:bank.example", "hospital.example", false}})
    EXPECT_EQ(shake_hands(forged_server(by, row.names), client, row.host), row.believed) << row.names;
}

TEST(LimitedAuthority, RefusesToSignForAnotherNameAndSaysItsLimits) {
  const Authority by = *Authority::create("test", kToday, days(30), {"10.0.0.5"});
  const Result<std::string> refused = by.server_key({.name = "s", .now = kToday}, {"bank.example"});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().what.find("limited to 10.0.0.5, localhost, 127.0.0.1, ::1"), std::string::npos)
      << refused.error().what;
  EXPECT_TRUE(by.server_key({.name = "s", .now = kToday}, {"10.0.0.5"}).ok());
}

TEST(LimitedAuthority, TakesNoLimitThatIsNone) {
  for (const char* wrong : {"", "*", "*.example", ".example", "10.0.0.0/0", "10.0.0.0/33", "10.0.0.0/", "::/0", "a/8",
                            "10.0.0.5,DNS:bank.example", "10.0.0.0/8/8", "::1/129"})
    EXPECT_FALSE(Authority::create("test", kToday, days(30), {wrong}).ok()) << wrong;
}

TEST(LimitedAuthority, APersonsNameWithADotIsNoHost) {
  const Authority by = *Authority::create("test", kToday, days(30), {"10.0.0.5"});
  const KeyFile server = *read_key(*by.server_key({.name = "s.t", .now = kToday}, {"10.0.0.5"}), "server.key");
  const KeyFile anna = *read_key(*by.client_key({.name = "anna.huber", .role = Role::Doctor, .now = kToday}), "a");
  EXPECT_TRUE(shake_hands(server, anna, "10.0.0.5"));
}

TEST(LimitedAuthority, AnOlderOneIsLimitedByRenewalAndItsKeysStayValid) {
  const Authority before = *Authority::create("test", kToday, days(30));
  EXPECT_TRUE(before.hosts().empty());
  const KeyFile server = *read_key(*before.server_key({.name = "s", .now = kToday}, {"10.0.0.5"}), "server.key");
  const KeyFile anna = *read_key(*before.client_key({.name = "anna", .role = Role::Doctor, .now = kToday}), "a");
  const Authority after = *before.renewed(kToday, days(30), {"10.0.0.5"});
  EXPECT_TRUE(after.has_signed(server) && after.has_signed(anna));
  const KeyFile bert = *read_key(*after.client_key({.name = "bert", .role = Role::Doctor, .now = kToday}), "b");
  EXPECT_TRUE(shake_hands(server, bert, "10.0.0.5")) << "an older server and a newer client";
  const KeyFile newer = *read_key(*after.server_key({.name = "s", .now = kToday}, {"10.0.0.5"}), "server.key");
  EXPECT_TRUE(shake_hands(newer, anna, "10.0.0.5"));
  const KeyFile bank = forged_server(before, "DNS:bank.example");
  EXPECT_TRUE(shake_hands(bank, anna, "bank.example")) << "this is why it must be renewed";
  EXPECT_FALSE(shake_hands(bank, bert, "bank.example"));
}

// --- the certificate that browsers see ---

std::string web_refusal(const std::filesystem::path& certificate, const std::filesystem::path& key) {
  const Result<WebCertificate> read = load_web_certificate(certificate, key, kToday);
  return read ? "" : read.error().what;
}

TEST(WebCertificates, AreThoseOfAServerWithItsKeyAndNothingElse) {
  const Folder folder;
  const Authority hospital = *Authority::create("hospital", kToday, days(30));
  const KeyFile good = *read_key(*hospital.server_key({.name = "w", .now = kToday}, {"tele.hospital.example"}), "w");
  const KeyFile old = *read_key(
      *hospital.server_key({.name = "w", .now = kToday - days(60), .valid = days(30)}, {"tele.hospital.example"}), "w");
  const KeyFile person = *read_key(*hospital.client_key({.name = "p", .role = Role::Viewer, .now = kToday}), "p");
  const auto certificate = folder.write("web.crt", good.certificate + good.authority, 0644);
  const auto key = folder.write("web.pem", to_pem(*good.private_key));
  EXPECT_EQ(web_refusal(certificate, key), "");
  EXPECT_EQ(load_web_certificate(certificate, key, kToday)->hosts.front(), "tele.hospital.example");
  const auto refused = [&](const std::filesystem::path& c, const std::filesystem::path& k, const char* why) {
    EXPECT_NE(web_refusal(c, k).find(why), std::string::npos) << why << ": " << web_refusal(c, k);
  };
  refused(folder.temporary.path() / "none", key, "cannot be read");
  refused(key, key, "no certificate");
  refused(certificate, certificate, "no private key");
  refused(folder.write("old.crt", old.certificate), folder.write("old.pem", to_pem(*old.private_key)), "expired on");
  refused(certificate, folder.write("other.pem", to_pem(*old.private_key)), "is not that of the certificate");
  refused(folder.write("p.crt", person.certificate), folder.write("p.pem", to_pem(*person.private_key)),
          "not for a web server");
  refused(folder.write("a.crt", good.authority + good.certificate), key, "not for a web server");
  refused(certificate, folder.write("open.pem", to_pem(*good.private_key), 0644), "other than its owner");
  refused(folder.write("large.crt", std::string(70'000, 'x')), key, "larger than");
}

// --- addresses of hardware tokens ---

TEST(HardwareTokens, AddressesThatWouldShowAPinOrNameNoKeyAreRefused) {
  const auto read = read_pkcs11("pkcs11:token=ward%203;object=anna?module-path=/usr/lib/a%20b.so");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->key, "pkcs11:token=ward%203;object=anna");
  EXPECT_EQ(read->object, "anna");
  EXPECT_EQ(read->module, "/usr/lib/a b.so");
  for (const char* wrong : {"", "pkcs11:", "pkcs11:token=a", "pkcs11:object=a?pin-value=1234", "pkcs11:object=a%2",
                            "pkcs11:object=a%zz", "pkcs11:object=a b", "file:object=a", "pkcs11:object="})
    EXPECT_FALSE(read_pkcs11(wrong).ok()) << wrong;
  EXPECT_FALSE(read_pkcs11("pkcs11:object=" + std::string(600, 'a')).ok());
}

}  // namespace
}  // namespace telepalp::keys
