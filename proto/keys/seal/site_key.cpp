#include "proto/keys/seal/site_key.h"

#include <openssl/core_names.h>
#include <openssl/evp.h>
#include <openssl/kdf.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/sha.h>
#include <openssl/x509.h>

#include <cstdlib>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

#include "proto/keys/key_file.h"
#include "proto/keys/secret/small_file.h"
#include "proto/keys/x509/openssl.h"

namespace telepalp::keys {
namespace {

constexpr std::size_t kPointBytes = 65;  // of P-256, uncompressed
constexpr std::size_t kNonceBytes = 12;
constexpr std::size_t kTagBytes = 16;
constexpr const char* kVariable = "TELEPALP_SITE_KEYS";

using CipherPtr = std::unique_ptr<EVP_CIPHER_CTX, Freed<EVP_CIPHER_CTX_free>>;
using KeyContextPtr = std::unique_ptr<EVP_PKEY_CTX, Freed<EVP_PKEY_CTX_free>>;

unsigned char* bytes_of(std::string& text) noexcept { return reinterpret_cast<unsigned char*>(text.data()); }

/// The public part as a point; empty: it is not on P-256.
std::string point_of(EVP_PKEY& key) {
  unsigned char* bytes = nullptr;
  const std::size_t size = EVP_PKEY_get1_encoded_public_key(&key, &bytes);
  std::string point(reinterpret_cast<const char*>(bytes), bytes == nullptr ? 0 : size);
  OPENSSL_free(bytes);
  return point.size() == kPointBytes ? point : std::string();
}

/// The public key at `point`; null: the point is not on P-256.
PrivateKeyPtr key_at(std::string_view point, const EVP_PKEY& same_curve) {
  PrivateKeyPtr key(EVP_PKEY_new());
  if (!key || EVP_PKEY_copy_parameters(key.get(), &same_curve) != 1 ||
      EVP_PKEY_set1_encoded_public_key(key.get(), keys::bytes_of(point), point.size()) != 1)
    return nullptr;
  return key;
}

/// ECDH, then HKDF-SHA-256 with both public parts; nullopt: OpenSSL or the token failed.
std::optional<FileKey> shared_key(EVP_PKEY& own, EVP_PKEY& other, std::string_view once_point,
                                  std::string_view site_id) {
  const KeyContextPtr derives(EVP_PKEY_CTX_new(&own, nullptr));
  std::size_t size = 0;
  if (!derives || EVP_PKEY_derive_init(derives.get()) != 1 || EVP_PKEY_derive_set_peer(derives.get(), &other) != 1 ||
      EVP_PKEY_derive(derives.get(), nullptr, &size) != 1)
    return std::nullopt;
  std::string secret(size, '\0');
  if (EVP_PKEY_derive(derives.get(), bytes_of(secret), &size) != 1) return std::nullopt;
  secret.resize(size);
  const std::string salt = std::string(once_point) + std::string(site_id);
  constexpr std::string_view kUse = "telepalp sealed recording 1";
  const KeyContextPtr hkdf(EVP_PKEY_CTX_new_id(EVP_PKEY_HKDF, nullptr));
  FileKey key{};
  size = key.size();
  const bool done =
      hkdf && EVP_PKEY_derive_init(hkdf.get()) == 1 && EVP_PKEY_CTX_set_hkdf_md(hkdf.get(), EVP_sha256()) == 1 &&
      EVP_PKEY_CTX_set1_hkdf_salt(hkdf.get(), keys::bytes_of(salt), static_cast<int>(salt.size())) == 1 &&
      EVP_PKEY_CTX_set1_hkdf_key(hkdf.get(), keys::bytes_of(secret), static_cast<int>(secret.size())) == 1 &&
      EVP_PKEY_CTX_add1_hkdf_info(hkdf.get(), keys::bytes_of(kUse), static_cast<int>(kUse.size())) == 1 &&
      EVP_PKEY_derive(hkdf.get(), key.data(), &size) == 1;
  OPENSSL_cleanse(secret.data(), secret.size());
  return done ? std::optional(key) : std::nullopt;
}

/// AES-256-GCM in one direction. Returns the context when all of `from` is in `into`, which has its size.
CipherPtr run_cipher(bool encrypts, const FileKey& key, const unsigned char* nonce, std::string_view about,
                     std::string_view from, unsigned char* into) {
  CipherPtr cipher(EVP_CIPHER_CTX_new());
  int size = 0;
  const bool done =
      cipher &&
      EVP_CipherInit_ex2(cipher.get(), EVP_aes_256_gcm(), key.data(), nonce, encrypts ? 1 : 0, nullptr) == 1 &&
      EVP_CipherUpdate(cipher.get(), nullptr, &size, keys::bytes_of(about), static_cast<int>(about.size())) == 1 &&
      EVP_CipherUpdate(cipher.get(), into, &size, keys::bytes_of(from), static_cast<int>(from.size())) == 1;
  return done ? std::move(cipher) : nullptr;
}

Error not_a_site_key(const std::filesystem::path& file) {
  return {.what = "is not a site's key",
          .where = file.string(),
          .fix = std::string("name files that telepalp-keys site-key made in ") + kVariable};
}

}  // namespace

Result<FileKey> new_file_key() {
  FileKey key{};
  if (RAND_bytes(key.data(), static_cast<int>(key.size())) != 1) return openssl_error("a file's key");
  return key;
}

Result<std::string> random_bytes(std::size_t count) {
  std::string bytes(count, '\0');
  if (RAND_bytes(bytes_of(bytes), static_cast<int>(count)) != 1) return openssl_error("random bytes");
  return bytes;
}

bool seal_block(const FileKey& key, std::string_view about, std::string_view block, std::string& into) {
  const std::size_t before = into.size();
  into.resize(before + block.size() + kSealBytes);
  unsigned char* const nonce = bytes_of(into) + before;
  unsigned char* const body = nonce + kNonceBytes;
  int none = 0;
  if (RAND_bytes(nonce, kNonceBytes) == 1)
    if (const CipherPtr cipher = run_cipher(true, key, nonce, about, block, body))
      if (EVP_CipherFinal_ex(cipher.get(), body + block.size(), &none) == 1 &&
          EVP_CIPHER_CTX_ctrl(cipher.get(), EVP_CTRL_AEAD_GET_TAG, kTagBytes, body + block.size()) == 1)
        return true;
  into.resize(before);
  return false;
}

bool open_block(const FileKey& key, std::string_view about, std::string_view sealed, std::string& into) {
  if (sealed.size() < kSealBytes) return false;
  const std::size_t before = into.size();
  const std::string_view body = sealed.substr(kNonceBytes, sealed.size() - kSealBytes);
  std::string tag(sealed.substr(sealed.size() - kTagBytes));
  into.resize(before + body.size());
  int none = 0;
  unsigned char last = 0;
  const CipherPtr cipher = run_cipher(false, key, keys::bytes_of(sealed), about, body, bytes_of(into) + before);
  if (cipher && EVP_CIPHER_CTX_ctrl(cipher.get(), EVP_CTRL_AEAD_SET_TAG, kTagBytes, tag.data()) == 1 &&
      EVP_CipherFinal_ex(cipher.get(), &last, &none) == 1)
    return true;
  into.resize(before);
  return false;
}

Result<std::string> public_text(EVP_PKEY& key) {
  const BytesPtr bytes(BIO_new(BIO_s_mem()));
  if (point_of(key).empty() || !bytes || PEM_write_bio_PUBKEY(bytes.get(), &key) != 1)
    return Error{.what = "the key is not on the curve P-256",
                 .where = "a site's key",
                 .fix = "make the token's key with EC:prime256v1, and let it derive"};
  return text_in(*bytes);
}

std::string in_hexadecimal_digits(std::string_view id) {
  return in_hexadecimal(std::span(keys::bytes_of(id), id.size()));
}

Result<SiteKey> SiteKey::load(const std::filesystem::path& file) {
  const std::optional<std::string> text = read_small_file(file, kMaxKeyFileBytes);
  if (!text) return Error{.what = "cannot be read", .where = file.string(), .fix = std::string("check ") + kVariable};
  if (text->size() > kMaxKeyFileBytes) return not_a_site_key(file);
  SiteKey key;
  key.file_ = file;
  key.text_ = *text;
  key.secret_ = secret_in(*text);
  key.public_ = PublicKey(PEM_read_bio_PUBKEY(reader_of(*text).get(), nullptr, nullptr, nullptr), EVP_PKEY_free);
  const std::string point = key.public_ ? point_of(*key.public_) : std::string();
  if (point.empty()) return not_a_site_key(file);
  if (key.secret_ != Secret::None)
    if (const Result<void> own = check_private(file); !own) return own.error();
  std::string digest(SHA256_DIGEST_LENGTH, '\0');
  SHA256(keys::bytes_of(point), point.size(), bytes_of(digest));
  key.id_ = digest.substr(0, kIdBytes);
  return key;
}

Result<std::string> SiteKey::close(const FileKey& key, std::string_view about) const {
  const PrivateKeyPtr once = new_private_key();
  if (!once) return openssl_error("a key for one file");
  std::string closed = point_of(*once);
  const std::optional<FileKey> shared = shared_key(*once, *public_, closed, id_);
  constexpr unsigned char kNoNonce[kNonceBytes] = {};  // the shared key is used once
  std::string body(key.size() + kTagBytes, '\0');
  int none = 0;
  if (!shared) return openssl_error("a file's key");
  const std::string_view bytes(reinterpret_cast<const char*>(key.data()), key.size());
  const CipherPtr cipher = run_cipher(true, *shared, kNoNonce, about, bytes, bytes_of(body));
  if (!cipher || EVP_CipherFinal_ex(cipher.get(), bytes_of(body) + key.size(), &none) != 1 ||
      EVP_CIPHER_CTX_ctrl(cipher.get(), EVP_CTRL_AEAD_GET_TAG, kTagBytes, bytes_of(body) + key.size()) != 1)
    return openssl_error("a file's key");
  return closed + body;
}

Result<FileKey> SiteKey::open(std::string_view closed, std::string_view about, const AskPassphrase& ask) const {
  if (secret_ == Secret::None)
    return Error{.what = "this is the public part of the site's key, which decrypts nothing",
                 .where = file_.string(),
                 .fix = std::string("name the private part, NAME.key, in ") + kVariable};
  const std::scoped_lock lock(private_->mutex);
  if (!private_->key) {
    forbid_dumps();
    Result<OwnKey> own = open_private_key(text_, file_.string(), ask);
    if (!own) return own.error();
    private_->key = std::move(own->key);
  }
  const Error altered{.what = "the key in the file's header was altered, or is not for this site's key",
                      .where = file_.string(),
                      .fix = "replace the file with a copy of the original"};
  if (closed.size() != kClosedKeyBytes) return altered;
  const std::string_view point = closed.substr(0, kPointBytes);
  const std::string_view body = closed.substr(kPointBytes, sizeof(FileKey));
  std::string tag(closed.substr(kPointBytes + sizeof(FileKey)));
  const PrivateKeyPtr once = key_at(point, *public_);
  const std::optional<FileKey> shared = once ? shared_key(*private_->key, *once, point, id_) : std::nullopt;
  if (!shared) return altered;
  constexpr unsigned char kNoNonce[kNonceBytes] = {};
  FileKey key{};
  int none = 0;
  unsigned char last = 0;
  const CipherPtr cipher = run_cipher(false, *shared, kNoNonce, about, body, key.data());
  if (cipher && EVP_CIPHER_CTX_ctrl(cipher.get(), EVP_CTRL_AEAD_SET_TAG, kTagBytes, tag.data()) == 1 &&
      EVP_CipherFinal_ex(cipher.get(), &last, &none) == 1)
    return key;
  return altered;
}

Result<std::vector<SiteKey>> site_keys_of_environment() {
  static std::mutex mutex;  // programs open sessions on several threads
  static std::string read_from;
  static std::vector<SiteKey> keys;
  const char* const value = std::getenv(kVariable);
  const std::string files = value == nullptr ? "" : value;
  const std::scoped_lock lock(mutex);
  if (files == read_from) return keys;
  std::vector<SiteKey> read;
  for (std::string_view rest = files; !rest.empty();) {
    const std::size_t colon = rest.find(':');
    const std::string_view file = rest.substr(0, colon);
    rest.remove_prefix(colon == rest.npos ? rest.size() : colon + 1);
    if (file.empty()) continue;
    Result<SiteKey> key = SiteKey::load(file);
    if (!key) return key.error();
    read.push_back(*std::move(key));
  }
  keys = std::move(read);
  read_from = files;
  return keys;
}

}  // namespace telepalp::keys
