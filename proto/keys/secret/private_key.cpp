#include "proto/keys/secret/private_key.h"

#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/pkcs12.h>
#include <openssl/x509.h>

#include <algorithm>
#include <cstring>

#include "proto/keys/secret/pkcs11.h"
#include "proto/keys/x509/openssl.h"

namespace telepalp::keys {
namespace {

constexpr int kRounds = 600'000;
constexpr int kSaltBytes = 16;

/// The address after the line's beginning; empty: there is no such line.
std::string_view key_line(std::string_view text) {
  std::size_t at = text.find("\n" + std::string(kKeyLine));
  at = text.starts_with(kKeyLine) ? 0 : at == std::string_view::npos ? at : at + 1;
  if (at == std::string_view::npos) return {};
  const std::string_view rest = text.substr(at + kKeyLine.size());
  return rest.substr(0, rest.find_first_of("\r\n"));
}

Error damaged(const std::string& file) {
  return {.what = "this file has no private key, or the key is damaged",
          .where = file,
          .fix = "give a file that telepalp-keys wrote; replace a damaged file with a copy of the original"};
}

int give_passphrase(char* into, int most, int, void* kept) {
  const auto& passphrase = *static_cast<const std::string*>(kept);
  if (passphrase.size() > static_cast<std::size_t>(most)) return -1;
  std::memcpy(into, passphrase.data(), passphrase.size());
  return static_cast<int>(passphrase.size());
}

PrivateKey decrypted(std::string_view pem, std::string passphrase) {
  PrivateKeyPtr key(PEM_read_bio_PrivateKey(reader_of(pem).get(), nullptr, give_passphrase, &passphrase));
  ERR_clear_error();
  return key;
}

/// The whole block of the private key in PEM.
std::string block_in(std::string_view text) {
  const std::string_view end = "PRIVATE KEY-----";
  const std::size_t named = text.find(end);
  const std::size_t from = text.rfind("-----BEGIN ", named);
  const std::size_t last = text.find(end, named + end.size());
  if (named == std::string_view::npos || from == std::string_view::npos || last == std::string_view::npos) return {};
  return std::string(text.substr(from, last + end.size() - from)) + "\n";
}

Result<OwnKey> open_encrypted(std::string_view text, const std::string& file, const AskPassphrase& ask) {
  if (!ask)
    return Error{.what = "a passphrase protects this key", .where = file, .fix = "give a key without a passphrase"};
  constexpr int kMostAttempts = 10;
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    const Result<std::string> passphrase = ask(file, attempt);
    if (!passphrase) return passphrase.error();
    if (PrivateKey key = decrypted(text, *passphrase)) return OwnKey{std::move(key), block_in(text)};
  }
  return Error{.what = "the passphrase is wrong", .where = file, .fix = "give the passphrase of this key"};
}

using EncodedKeyPtr = std::unique_ptr<PKCS8_PRIV_KEY_INFO, Freed<PKCS8_PRIV_KEY_INFO_free>>;
using EncryptedKeyPtr = std::unique_ptr<X509_SIG, Freed<X509_SIG_free>>;

EncryptedKeyPtr encrypted(EVP_PKEY& key, const std::string& passphrase) {
  const EncodedKeyPtr encoded(EVP_PKEY2PKCS8(&key));
  X509_ALGOR* const method =
      PKCS5_pbe2_set_iv(EVP_aes_256_cbc(), kRounds, nullptr, kSaltBytes, nullptr, NID_hmacWithSHA256);
  if (!encoded || method == nullptr) return nullptr;
  EncryptedKeyPtr made(PKCS8_set0_pbe(passphrase.data(), static_cast<int>(passphrase.size()), encoded.get(), method));
  if (!made) X509_ALGOR_free(method);  // else `made` owns it
  return made;
}

}  // namespace

Secret secret_in(std::string_view text) {
  if (!key_line(text).empty()) return Secret::Token;
  for (const char* closed : {"-----BEGIN ENCRYPTED PRIVATE KEY-----", "Proc-Type: 4,ENCRYPTED"})
    if (text.find(closed) != std::string_view::npos) return Secret::Encrypted;
  return text.find("PRIVATE KEY-----") != std::string_view::npos ? Secret::Plain : Secret::None;
}

Result<OwnKey> open_private_key(std::string_view text, const std::string& file, const AskPassphrase& ask) {
  switch (secret_in(text)) {
    case Secret::None:
      return damaged(file);
    case Secret::Encrypted:
      return open_encrypted(text, file, ask);
    case Secret::Plain: {
      PrivateKey key = private_key_in(text);
      if (!key) return damaged(file);
      return OwnKey{std::move(key), block_in(text)};
    }
    case Secret::Token:
      break;
  }
  return private_key_in_token(key_line(text), ask);
}

Result<OwnKey> make_private_key(const std::string& passphrase) {
  PrivateKey key = new_private_key();
  if (!key) return openssl_error("new key");
  const Result<std::string> text = locked(*key, passphrase);
  if (!text) return text.error();
  return OwnKey{std::move(key), *text};
}

Result<OwnKey> private_key_in_token(std::string_view address, const AskPassphrase& ask) {
  const Result<Pkcs11Address> read = read_pkcs11(address);
  if (!read) return read.error();
  Result<PrivateKey> key = open_pkcs11(*read, ask);
  if (!key) return key.error();
  return OwnKey{std::move(key).value(), std::string(kKeyLine) + std::string(address) + "\n"};
}

Result<std::string> locked(EVP_PKEY& key, const std::string& passphrase) {
  if (passphrase.empty()) return to_pem(key);
  const EncryptedKeyPtr closed = encrypted(key, passphrase);
  const BytesPtr bytes(BIO_new(BIO_s_mem()));
  if (!closed || PEM_write_bio_PKCS8(bytes.get(), closed.get()) != 1) return openssl_error("private key");
  return text_in(*bytes);
}

}  // namespace telepalp::keys
