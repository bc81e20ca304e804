#include "proto/keys/request/key_request.h"

#include <openssl/core_names.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <array>
#include <optional>

#include "proto/keys/audit_chain.h"
#include "proto/keys/x509/names.h"
#include "proto/keys/x509/openssl.h"

namespace telepalp::keys {
namespace {

using RequestPtr = std::unique_ptr<X509_REQ, Freed<X509_REQ_free>>;

Error request_refused(std::string what, const std::string& file, std::string fix) {
  return {.what = std::move(what), .where = file, .fix = std::move(fix)};
}

/// OpenSSL reads PEM of any kind up to the first of the wanted kind; here nothing but one request may be inside.
bool has_one_block(std::string_view text) {
  const std::size_t first = text.find("-----BEGIN ");
  return first != std::string_view::npos && text.find("-----BEGIN ", first + 1) == std::string_view::npos;
}

/// A curve that is described by its parameters may be a weak one.
bool is_p256(EVP_PKEY& key) {
  std::array<char, 32> group{};
  std::size_t size = 0;
  int by_parameters = 0;
  return EVP_PKEY_is_a(&key, "EC") == 1 && EVP_PKEY_get_group_name(&key, group.data(), group.size(), &size) == 1 &&
         std::string_view(group.data(), size) == "prime256v1" &&
         EVP_PKEY_get_int_param(&key, OSSL_PKEY_PARAM_EC_DECODED_FROM_EXPLICIT_PARAMS, &by_parameters) == 1 &&
         by_parameters == 0;
}

/// The one common name; nullopt: there is none, or several, or one with a zero inside.
std::optional<std::string> one_name(X509_REQ& request) {
  X509_NAME* const subject = X509_REQ_get_subject_name(&request);
  const int at = X509_NAME_get_index_by_NID(subject, NID_commonName, -1);
  if (at < 0 || X509_NAME_get_index_by_NID(subject, NID_commonName, at) >= 0) return std::nullopt;
  unsigned char* bytes = nullptr;
  const int size = ASN1_STRING_to_UTF8(&bytes, X509_NAME_ENTRY_get_data(X509_NAME_get_entry(subject, at)));
  if (size < 0) return std::nullopt;
  std::string name(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  OPENSSL_free(bytes);
  return name;
}

RequestPtr parsed(std::string_view text) {
  RequestPtr request(has_one_block(text) ? PEM_read_bio_X509_REQ(reader_of(text).get(), nullptr, nullptr, nullptr)
                                         : nullptr);
  ERR_clear_error();
  return request;
}

}  // namespace

Result<std::string> make_request(const std::string& name, EVP_PKEY& key) {
  if (const Result<void> fine = check_name(name); !fine) return fine.error();
  const RequestPtr request(X509_REQ_new());
  const auto* bytes = reinterpret_cast<const unsigned char*>(name.c_str());
  const BytesPtr text(BIO_new(BIO_s_mem()));
  const bool made = X509_REQ_set_version(request.get(), X509_REQ_VERSION_1) == 1 &&
                    X509_NAME_add_entry_by_NID(X509_REQ_get_subject_name(request.get()), NID_commonName, MBSTRING_UTF8,
                                               bytes, static_cast<int>(name.size()), -1, 0) == 1 &&
                    X509_REQ_set_pubkey(request.get(), &key) == 1 &&
                    X509_REQ_sign(request.get(), &key, EVP_sha256()) != 0 &&
                    PEM_write_bio_X509_REQ(text.get(), request.get()) == 1;
  if (!made) return openssl_error("request for the key of " + name);
  return "telepalp: a request for a certificate of " + name + ". It holds no secret. Its key: " + fingerprint(key) +
         "\n" + text_in(*text);
}

Result<KeyRequest> read_request(std::string_view text, const std::string& file) {
  const std::string another = "ask for the file that `telepalp-keys request` wrote";
  if (text.size() > kMaxRequestBytes)
    return request_refused("the request has more than " + std::to_string(kMaxRequestBytes) + " B", file, another);
  const RequestPtr request = parsed(text);
  EVP_PKEY* const key = request ? X509_REQ_get0_pubkey(request.get()) : nullptr;
  if (key == nullptr) {
    ERR_clear_error();
    return request_refused("this file does not hold exactly one request for a certificate", file, another);
  }
  if (!is_p256(*key)) {
    ERR_clear_error();
    return request_refused("the key of this request is not on the curve P-256, which all telepalp keys use", file,
                           "make the key by `telepalp-keys request`; in a hardware token, make a key EC prime256v1");
  }
  const bool proves =
      X509_REQ_get_signature_nid(request.get()) == NID_ecdsa_with_SHA256 && X509_REQ_verify(request.get(), key) == 1;
  ERR_clear_error();
  if (!proves)
    return request_refused("the request is not signed with its own key, so its sender may not have the private key",
                           file, another);
  const std::optional<std::string> name = one_name(*request);
  if (!name || !check_name(*name).ok())
    return request_refused("the request does not state exactly one name that a key may have", file,
                           "make it by telepalp-keys request --name NAME");
  EVP_PKEY_up_ref(key);
  return KeyRequest{.name = *name, .key = PublicKey(key, EVP_PKEY_free)};
}

PublicKey public_key_of(const KeyFile& key) {
  const std::vector<CertificatePtr> certificates = certificates_in(key.certificate);
  return certificates.empty() ? nullptr : PublicKey(X509_get_pubkey(certificates.front().get()), EVP_PKEY_free);
}

std::string fingerprint(EVP_PKEY& key) {
  unsigned char* bytes = nullptr;
  const int size = i2d_PUBKEY(&key, &bytes);
  if (size <= 0) return "";
  const std::string encoded(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  OPENSSL_free(bytes);
  return "SHA256:" + sha256_hex(encoded);
}

}  // namespace telepalp::keys
