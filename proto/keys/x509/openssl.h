#pragma once

#include <openssl/bio.h>
#include <openssl/evp.h>
#include <openssl/x509.h>

#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::keys {

/// Deleter of a unique_ptr to an OpenSSL object. `kFree`: the function of OpenSSL that frees this type.
template <auto kFree>
struct Freed {
  template <class T>
  void operator()(T* object) const noexcept {
    kFree(object);
  }
};

using CertificatePtr = std::unique_ptr<X509, Freed<X509_free>>;
using PrivateKeyPtr = std::unique_ptr<EVP_PKEY, Freed<EVP_PKEY_free>>;
using RevocationListPtr = std::unique_ptr<X509_CRL, Freed<X509_CRL_free>>;
using BytesPtr = std::unique_ptr<BIO, Freed<BIO_free_all>>;
using DigestPtr = std::unique_ptr<EVP_MD_CTX, Freed<EVP_MD_CTX_free>>;

[[nodiscard]] PrivateKeyPtr new_private_key();  ///< ECDSA on P-256: browsers take no Ed25519 certificates
[[nodiscard]] std::string random_serial();      ///< 80 bits in hexadecimal, 78 of them random

[[nodiscard]] std::string random_hexadecimal(std::size_t bytes);
[[nodiscard]] std::string in_hexadecimal(std::span<const unsigned char> bytes);

/// `text` as OpenSSL's functions take it.
[[nodiscard]] inline const unsigned char* bytes_of(std::string_view text) noexcept {
  return reinterpret_cast<const unsigned char*>(text.data());
}

[[nodiscard]] BytesPtr reader_of(std::string_view text);
[[nodiscard]] std::string text_in(BIO& bytes);  ///< what was written to a memory BIO
[[nodiscard]] std::string to_pem(X509& certificate);
[[nodiscard]] std::string to_pem(EVP_PKEY& key);
/// At most 8, up to the first that cannot be read or whose public key is of a kind that OpenSSL does not know: callers
/// may rely on X509_get0_pubkey.
[[nodiscard]] std::vector<CertificatePtr> certificates_in(std::string_view pem);
[[nodiscard]] PrivateKeyPtr private_key_in(std::string_view pem);  ///< null: `pem` has none

[[nodiscard]] std::string serial_of(const ASN1_INTEGER& number);
[[nodiscard]] std::chrono::system_clock::time_point time_of(const ASN1_TIME& time);
/// The error of a failed OpenSSL call: no memory, no entropy, or wrong arguments.
[[nodiscard]] Error openssl_error(std::string where);

}  // namespace telepalp::keys
