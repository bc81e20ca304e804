#include "proto/keys/x509/openssl.h"

#include <openssl/bn.h>
#include <openssl/ec.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/rand.h>

#include <cstdio>
#include <ctime>

#include "proto/words/demand.h"

namespace telepalp::keys {
namespace {

constexpr std::size_t kMostCertificates = 8;
constexpr std::size_t kSerialBytes = 10;

std::vector<unsigned char> demanded_random_bytes(std::size_t count) {
  std::vector<unsigned char> bytes(count);
  demand(RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) == 1, "OpenSSL generates random bytes");
  return bytes;
}

/// Without it, OpenSSL would stop at a terminal and ask. Passphrases are asked for elsewhere (passphrase.h).
int no_password(char*, int, int, void*) { return -1; }

}  // namespace

std::string in_hexadecimal(std::span<const unsigned char> bytes) {
  std::string text;
  for (const unsigned char byte : bytes) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", byte);
    text += digits;
  }
  return text;
}

PrivateKeyPtr new_private_key() { return PrivateKeyPtr(EVP_EC_gen("P-256")); }

std::string random_serial() {
  std::vector<unsigned char> bytes = demanded_random_bytes(kSerialBytes);
  bytes[0] = static_cast<unsigned char>((bytes[0] & 0x7f) | 0x40);  // positive, and of a fixed length
  return in_hexadecimal(bytes);
}

std::string random_hexadecimal(std::size_t bytes) {
  const std::vector<unsigned char> made = demanded_random_bytes(bytes);
  return in_hexadecimal(made);
}

BytesPtr reader_of(std::string_view text) {
  return BytesPtr(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}

std::string text_in(BIO& bytes) {
  char* data = nullptr;
  const long size = BIO_get_mem_data(&bytes, &data);
  return {data, static_cast<std::size_t>(size)};
}

std::string to_pem(X509& certificate) {
  const BytesPtr bytes(BIO_new(BIO_s_mem()));
  demand(PEM_write_bio_X509(bytes.get(), &certificate) == 1, "OpenSSL writes a certificate as PEM text");
  return text_in(*bytes);
}

std::string to_pem(EVP_PKEY& key) {
  const BytesPtr bytes(BIO_new(BIO_s_mem()));
  demand(PEM_write_bio_PrivateKey(bytes.get(), &key, nullptr, nullptr, 0, nullptr, nullptr) == 1,
         "OpenSSL writes a private key as PEM text");
  return text_in(*bytes);
}

std::vector<CertificatePtr> certificates_in(std::string_view pem) {
  const BytesPtr bytes = reader_of(pem);
  std::vector<CertificatePtr> found;
  while (found.size() < kMostCertificates) {
    CertificatePtr one(PEM_read_bio_X509(bytes.get(), nullptr, no_password, nullptr));
    if (!one || X509_get0_pubkey(one.get()) == nullptr) break;
    found.push_back(std::move(one));
  }
  ERR_clear_error();
  return found;
}

PrivateKeyPtr private_key_in(std::string_view pem) {
  const BytesPtr bytes = reader_of(pem);
  PrivateKeyPtr key(PEM_read_bio_PrivateKey(bytes.get(), nullptr, no_password, nullptr));
  ERR_clear_error();
  return key;
}

std::string serial_of(const ASN1_INTEGER& number) {
  const std::unique_ptr<BIGNUM, Freed<BN_free>> value(ASN1_INTEGER_to_BN(&number, nullptr));
  char* const digits = value ? BN_bn2hex(value.get()) : nullptr;
  std::string text = digits == nullptr ? "" : digits;
  OPENSSL_free(digits);
  for (char& letter : text)
    if (letter >= 'A' && letter <= 'F') letter = static_cast<char>(letter - 'A' + 'a');
  return text;
}

std::chrono::system_clock::time_point time_of(const ASN1_TIME& time) {
  std::tm parts{};
  if (ASN1_TIME_to_tm(&time, &parts) != 1) return {};
  return std::chrono::system_clock::from_time_t(timegm(&parts));
}

Error openssl_error(std::string where) {
  char text[160] = "";
  ERR_error_string_n(ERR_get_error(), text, sizeof text);
  ERR_clear_error();
  return {.what = "OpenSSL failed: " + std::string(text),
          .where = std::move(where),
          .fix = "check that `openssl version` names 3.0 or later, and that no key file is cut off"};
}

}  // namespace telepalp::keys
