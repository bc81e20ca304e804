#include "proto/keys/authority.h"

#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include <algorithm>
#include <utility>

#include "proto/keys/certificate.h"
#include "proto/keys/key_file.h"
#include "proto/keys/token.h"
#include "proto/words/demand.h"

namespace telepalp::keys {
namespace {

constexpr std::size_t kMostHosts = 16;

bool is_plain(std::string_view text, std::string_view also) {
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), [&](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
           also.find(letter) != std::string_view::npos;
  });
}

Result<void> check_name(const std::string& name) {
  if (is_plain(name, "._@-")) return {};
  return Error{.what = "'" + name + "' cannot be the name of a key",
               .where = "--name",
               .fix = "use 1 to 64 letters, digits, dots, hyphens, underscores and @"};
}

/// Role::Local is for peers on a server without keys: no key or token may state it.
Result<void> check_person(const Authority::Issue& asked) {
  if (Result<void> fine = check_name(asked.name); !fine) return fine;
  if (asked.role != Role::Local) return {};
  return Error{.what = "the role " + std::string(keys::name(asked.role)) +
                       " is only for programs that connect to a server without keys",
               .where = "--role",
               .fix = "give technician, doctor, viewer or qa"};
}

/// "DNS:patient.example,IP:10.0.0.1": an entry of digits and dots, or with a colon, is an address.
Result<std::string> alt_names(std::vector<std::string> hosts) {
  for (const char* own : {"localhost", "127.0.0.1", "::1"})
    if (std::find(hosts.begin(), hosts.end(), own) == hosts.end()) hosts.emplace_back(own);
  if (hosts.size() > kMostHosts)
    return Error{.what = "more than 13 hosts are given", .where = "--host", .fix = "give at most 13"};
  std::string text;
  for (const std::string& host : hosts) {
    if (!is_plain(host, ".-:"))
      return Error{.what = "'" + host + "' is not a host name or address",
                   .where = "--host",
                   .fix = "give the host that clients write after --connect, such as patient.example or 10.0.0.1"};
    const bool address =
        host.find(':') != std::string::npos || host.find_first_not_of("0123456789.") == std::string::npos;
    text += (text.empty() ? "" : ",") + std::string(address ? "IP:" : "DNS:") + host;
  }
  return text;
}

bool add_revoked(X509_CRL& list, const std::string& serial_text, WallTime revoked) {
  const std::unique_ptr<X509_REVOKED, Freed<X509_REVOKED_free>> entry(X509_REVOKED_new());
  BIGNUM* number = nullptr;
  if (BN_hex2bn(&number, serial_text.c_str()) != static_cast<int>(serial_text.size())) {
    BN_free(number);
    return false;
  }
  const std::unique_ptr<BIGNUM, Freed<BN_free>> owned(number);
  const std::unique_ptr<ASN1_INTEGER, Freed<ASN1_INTEGER_free>> serial(BN_to_ASN1_INTEGER(number, nullptr));
  const std::unique_ptr<ASN1_TIME, Freed<ASN1_STRING_free>> when(
      ASN1_TIME_set(nullptr, std::chrono::system_clock::to_time_t(revoked)));
  return X509_REVOKED_set_serialNumber(entry.get(), serial.get()) == 1 &&
         X509_REVOKED_set_revocationDate(entry.get(), when.get()) == 1 &&
         X509_CRL_add0_revoked(&list, X509_REVOKED_dup(entry.get())) == 1;
}

}  // namespace

struct Authority::Parts {
  CertificatePtr certificate;
  PrivateKeyPtr key;
};

Authority::Authority(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Authority::Authority(Authority&&) noexcept = default;
Authority& Authority::operator=(Authority&&) noexcept = default;
Authority::~Authority() = default;

Result<Authority> Authority::create(const std::string& name, WallTime now, std::chrono::days valid) {
  if (const Result<void> fine = check_name(name); !fine) return fine.error();
  PrivateKeyPtr key = new_private_key();
  if (!key) return openssl_error("new key");
  Result<CertificatePtr> certificate = make_certificate({.name = name,
                                                         .alt_names = {},
                                                         .usage = {},
                                                         .serial = random_serial(),
                                                         .from = now - kBackdated,
                                                         .until = now + valid},
                                                        *key, nullptr, *key);
  if (!certificate) return certificate.error();
  return Authority(std::make_unique<Parts>(Parts{std::move(certificate).value(), std::move(key)}));
}

Result<Authority> Authority::read(std::string_view file_text, const std::string& file) {
  std::vector<CertificatePtr> certificates = certificates_in(file_text);
  PrivateKeyPtr key = private_key_in(file_text);
  if (!key || certificates.size() != 1 || !is_authority(*certificates.front()) ||
      X509_check_private_key(certificates.front().get(), key.get()) != 1)
    return Error{.what = "this is not the file of an authority, or it is damaged",
                 .where = file,
                 .fix =
                     "give by --dir the folder in which `telepalp-keys authority` wrote authority.key, or restore that "
                     "file from a backup"};
  return Authority(std::make_unique<Parts>(Parts{std::move(certificates.front()), std::move(key)}));
}

std::string Authority::file_text() const {
  return "telepalp: the authority " + name() +
         ". Anyone with this file can make keys of every role: keep it on one machine, and never send it.\n" +
         certificate() + to_pem(*parts_->key);
}

std::string Authority::certificate() const { return to_pem(*parts_->certificate); }
std::string Authority::name() const { return common_name(*parts_->certificate); }

namespace {

/// A certificate with a new private key, as the text of a key file.
Result<std::string> issue(const CertificateRequest& request, const std::string& preamble, X509& authority,
                          EVP_PKEY& authority_key) {
  const PrivateKeyPtr key = new_private_key();
  if (!key) return openssl_error("new key");
  const Result<CertificatePtr> certificate = make_certificate(request, *key, &authority, authority_key);
  if (!certificate) return certificate.error();
  return preamble + to_pem(**certificate) + to_pem(*key) + to_pem(authority);
}

}  // namespace

Result<std::string> Authority::server_key(const Issue& asked, const std::vector<std::string>& hosts) const {
  if (const Result<void> fine = check_name(asked.name); !fine) return fine.error();
  const Result<std::string> names = alt_names(hosts);
  if (!names) return names.error();
  return issue({.name = asked.name,
                .alt_names = *names + ",URI:" + std::string(kListUri),
                .usage = "serverAuth",
                .serial = random_serial(),
                .from = asked.now - kBackdated,
                .until = asked.now + asked.valid},
               "telepalp: the key of the server " + asked.name + ". Use it only for telepalp-server --key.\n",
               *parts_->certificate, *parts_->key);
}

Result<std::string> Authority::client_key(const Issue& asked) const {
  if (const Result<void> fine = check_person(asked); !fine) return fine.error();
  return issue({.name = asked.name,
                .alt_names = "URI:" + std::string(kRoleUri) + std::string(keys::name(asked.role)),
                .usage = "clientAuth",
                .serial = random_serial(),
                .from = asked.now - kBackdated,
                .until = asked.now + asked.valid},
               "telepalp: the key of " + std::string(keys::name(asked.role)) + " " + asked.name +
                   ". It allows: " + permissions(asked.role) + ". Only this person may use it.\n",
               *parts_->certificate, *parts_->key);
}

Result<std::string> Authority::token(const Issue& asked) const {
  if (const Result<void> fine = check_person(asked); !fine) return fine.error();
  const Identity bearer{
      .name = asked.name, .role = asked.role, .serial = random_serial(), .expires = asked.now + asked.valid};
  const Result<std::string> token = sign_token(bearer, *parts_->key);
  if (!token) return token.error();
  return "telepalp: a token of " + describe(bearer) + ". It allows: " + permissions(asked.role) +
         ". Anyone who has the next line may do this.\n" + std::string(kTokenLine) + *token + "\n" + certificate();
}

namespace {

bool set_number(X509_CRL& list, std::uint64_t number) {
  const std::unique_ptr<ASN1_INTEGER, Freed<ASN1_INTEGER_free>> value(ASN1_INTEGER_new());
  return value && ASN1_INTEGER_set_uint64(value.get(), number) == 1 &&
         X509_CRL_add1_ext_i2d(&list, NID_crl_number, value.get(), 0, 0) == 1;
}

}  // namespace

Result<std::string> Authority::revocation_list(const std::map<std::string, WallTime>& revoked, WallTime now,
                                               std::uint64_t number) const {
  const RevocationListPtr list(X509_CRL_new());
  const std::unique_ptr<ASN1_TIME, Freed<ASN1_STRING_free>> when(
      ASN1_TIME_set(nullptr, std::chrono::system_clock::to_time_t(now)));
  bool made = X509_CRL_set_version(list.get(), 1) == 1 &&
              X509_CRL_set_issuer_name(list.get(), X509_get_subject_name(parts_->certificate.get())) == 1 &&
              X509_CRL_set1_lastUpdate(list.get(), when.get()) == 1 &&
              X509_CRL_set1_nextUpdate(list.get(), X509_get0_notAfter(parts_->certificate.get())) == 1;
  made = made && set_number(*list, number);
  for (const auto& [serial, at] : revoked) made = made && add_revoked(*list, serial, at);
  made = made && X509_CRL_sort(list.get()) == 1 && X509_CRL_sign(list.get(), parts_->key.get(), EVP_sha256()) != 0;
  const BytesPtr bytes(BIO_new(BIO_s_mem()));
  if (!made || PEM_write_bio_X509_CRL(bytes.get(), list.get()) != 1) return openssl_error("revocation list");
  char* text = nullptr;
  const long size = BIO_get_mem_data(bytes.get(), &text);
  return std::string(text, static_cast<std::size_t>(size));
}

}  // namespace telepalp::keys
