#include "proto/keys/authority.h"

#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include <utility>

#include "proto/keys/certificate.h"
#include "proto/keys/key_file.h"
#include "proto/keys/token.h"
#include "proto/keys/x509/names.h"
#include "proto/words/demand.h"

namespace telepalp::keys {
namespace {

/// Role::Local is for peers on a server without keys: no key or token may state it.
Result<void> check_person(const Authority::Issue& asked) {
  if (Result<void> fine = check_name(asked.name); !fine) return fine;
  if (asked.role != Role::Local) return {};
  return Error{.what = "the role " + std::string(keys::name(asked.role)) +
                       " is only for programs that connect to a server without keys",
               .where = "--role",
               .fix = "give technician, doctor, viewer or qa"};
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
  OwnKey own;
};

Authority::Authority(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Authority::Authority(Authority&&) noexcept = default;
Authority& Authority::operator=(Authority&&) noexcept = default;
Authority::~Authority() = default;

namespace {

/// The self-signed certificate of an authority.
Result<CertificatePtr> self_signed(const std::string& name, WallTime now, std::chrono::days valid,
                                   const std::vector<std::string>& hosts, EVP_PKEY& key) {
  const Result<std::string> limits = hosts.empty() ? Result<std::string>("") : name_limits(hosts);
  if (!limits) return limits.error();
  return make_certificate({.name = name,
                           .alt_names = {},
                           .usage = {},
                           .limits = *limits,
                           .serial = random_serial(),
                           .from = now - kBackdated,
                           .until = now + valid},
                          key, nullptr, key);
}

}  // namespace

Result<Authority> Authority::create(const std::string& name, WallTime now, std::chrono::days valid,
                                    const std::vector<std::string>& hosts, OwnKey own) {
  if (const Result<void> fine = check_name(name); !fine) return fine.error();
  if (!own.key) {
    Result<OwnKey> made = make_private_key("");
    if (!made) return made.error();
    own = std::move(made).value();
  }
  Result<CertificatePtr> certificate = self_signed(name, now, valid, hosts, *own.key);
  if (!certificate) return certificate.error();
  return Authority(std::make_unique<Parts>(Parts{std::move(certificate).value(), std::move(own)}));
}

Result<Authority> Authority::renewed(WallTime now, std::chrono::days valid,
                                     const std::vector<std::string>& hosts) const {
  return create(name(), now, valid, hosts, parts_->own);
}

Result<Authority> Authority::read(std::string_view file_text, const std::string& file, const AskPassphrase& ask) {
  std::vector<CertificatePtr> certificates = certificates_in(file_text);
  const Error not_one{.what = "this is not the file of an authority, or it is damaged",
                      .where = file,
                      .fix =
                          "give by --dir the folder in which `telepalp-keys authority` wrote authority.key, or restore "
                          "that file from a backup"};
  if (certificates.size() != 1 || !is_authority(*certificates.front()) || secret_in(file_text) == Secret::None)
    return not_one;
  Result<OwnKey> own = open_private_key(file_text, file, ask);
  if (!own) return own.error();
  if (X509_check_private_key(certificates.front().get(), own->key.get()) != 1) return not_one;
  return Authority(std::make_unique<Parts>(Parts{std::move(certificates.front()), std::move(own).value()}));
}

std::string Authority::file_text() const {
  return "telepalp: the authority " + name() +
         ". Anyone with this file can make keys of every role: keep it on one machine, and never send it.\n" +
         certificate() + parts_->own.text;
}

std::string Authority::certificate() const { return to_pem(*parts_->certificate); }
std::string Authority::name() const { return common_name(*parts_->certificate); }
std::vector<std::string> Authority::hosts() const { return permitted_hosts(*parts_->certificate); }

bool Authority::has_signed(const KeyFile& key) const {
  if (key.kind == KeyFile::Kind::Token) return read_token(key.token, *parts_->own.key, WallTime{}).ok();
  const std::vector<CertificatePtr> certificates = certificates_in(key.certificate);
  const bool is_ours = !certificates.empty() && X509_verify(certificates.front().get(), parts_->own.key.get()) == 1;
  ERR_clear_error();
  return is_ours;
}

namespace {

Error not_permitted(X509& authority) {
  std::string hosts;
  for (const std::string& host : permitted_hosts(authority)) hosts += (hosts.empty() ? "" : ", ") + host;
  return {.what = "this authority may not sign for one of these hosts: it is limited to " + hosts,
          .where = "--host",
          .fix =
              "give hosts within these limits, or widen them: telepalp-keys renew DIR/authority.key --host HOST, "
              "with each host or network"};
}

/// A certificate as the text of a key file, with its private key if that is made here.
Result<std::string> issue(const CertificateRequest& request, const std::string& preamble, const Authority::Issue& asked,
                          X509& authority, EVP_PKEY& authority_key) {
  OwnKey own = asked.own;
  if (!asked.key && !own.key) {
    Result<OwnKey> made = make_private_key("");
    if (!made) return made.error();
    own = std::move(made).value();
  }
  EVP_PKEY& key = asked.key ? *asked.key : *own.key;
  const Result<CertificatePtr> certificate = make_certificate(request, key, &authority, authority_key);
  if (!certificate) return certificate.error();
  if (!is_permitted(**certificate, authority)) return not_permitted(authority);
  const std::string about = asked.key ? "telepalp: the certificate of " + asked.name +
                                            ". It holds no secret, and works only with the private key that " +
                                            asked.name + " has.\n"
                                      : preamble;
  return about + to_pem(**certificate) + (asked.key ? "" : own.text) + to_pem(authority);
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
               "telepalp: the key of the server " + asked.name + ". Use it only for telepalp-server --key.\n", asked,
               *parts_->certificate, *parts_->own.key);
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
               asked, *parts_->certificate, *parts_->own.key);
}

Result<std::string> Authority::token(const Issue& asked) const {
  if (const Result<void> fine = check_person(asked); !fine) return fine.error();
  const Identity bearer{
      .name = asked.name, .role = asked.role, .serial = random_serial(), .expires = asked.now + asked.valid};
  const Result<std::string> token = sign_token(bearer, *parts_->own.key);
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
  made = made && X509_CRL_sort(list.get()) == 1 && X509_CRL_sign(list.get(), parts_->own.key.get(), EVP_sha256()) != 0;
  const BytesPtr bytes(BIO_new(BIO_s_mem()));
  if (!made || PEM_write_bio_X509_CRL(bytes.get(), list.get()) != 1) return openssl_error("revocation list");
  return text_in(*bytes);
}

}  // namespace telepalp::keys
