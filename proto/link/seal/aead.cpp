#include "proto/link/seal/aead.h"

#include <openssl/evp.h>

#include <algorithm>

#include "proto/link/seal/packet_format.h"
#include "proto/words/demand.h"

namespace telepalp::link {
namespace {

const unsigned char* for_openssl(const std::byte* data) noexcept {
  return reinterpret_cast<const unsigned char*>(data);
}
unsigned char* for_openssl(std::byte* data) noexcept { return reinterpret_cast<unsigned char*>(data); }
int size_of(std::span<const std::byte> data) noexcept { return static_cast<int>(data.size()); }

void must(int done) { demand(done == 1, "OpenSSL encrypts and decrypts a datagram without an internal error"); }

}  // namespace

void Aead::Free::operator()(evp_cipher_ctx_st* context) const noexcept { EVP_CIPHER_CTX_free(context); }

Aead::Aead(Cipher cipher, const PacketKey& key, Use use) : context_(EVP_CIPHER_CTX_new()), salt_(key.salt) {
  const EVP_CIPHER* const algorithm = cipher == Cipher::Aes256Gcm ? EVP_aes_256_gcm() : EVP_chacha20_poly1305();
  must(EVP_CipherInit_ex(context_.get(), algorithm, nullptr, for_openssl(key.key.bytes().data()), nullptr,
                         use == Use::Seal ? 1 : 0));
}

void Aead::start(std::uint64_t sequence, std::span<const std::byte> header) {
  std::array<std::byte, 12> nonce = salt_;
  for (std::size_t i = 0; i < 8; ++i) nonce[4 + i] ^= static_cast<std::byte>(sequence >> (8 * i));
  must(EVP_CipherInit_ex(context_.get(), nullptr, nullptr, nullptr, for_openssl(nonce.data()), -1));
  int written = 0;
  must(EVP_CipherUpdate(context_.get(), nullptr, &written, for_openssl(header.data()), size_of(header)));
}

void Aead::seal(std::uint64_t sequence, std::span<const std::byte> header, const PlainParts& plain, std::byte* out) {
  start(sequence, header);
  for (const std::span<const std::byte> part : plain) {
    if (part.empty()) continue;
    int written = 0;
    must(EVP_CipherUpdate(context_.get(), for_openssl(out), &written, for_openssl(part.data()), size_of(part)));
    demand(written == size_of(part), "a stream cipher writes as many bytes as it reads");
    out += part.size();
  }
  int rest = 0;
  must(EVP_CipherFinal_ex(context_.get(), for_openssl(out), &rest));
  must(EVP_CIPHER_CTX_ctrl(context_.get(), EVP_CTRL_AEAD_GET_TAG, kTagBytes, out));
}

bool Aead::open(std::uint64_t sequence, std::span<const std::byte> header, std::span<const std::byte> sealed,
                std::byte* out) {
  const std::span<const std::byte> cipher_text = sealed.first(sealed.size() - kTagBytes);
  std::array<std::byte, kTagBytes> tag;
  std::copy_n(sealed.data() + cipher_text.size(), tag.size(), tag.begin());
  start(sequence, header);
  int written = 0;
  if (!cipher_text.empty())
    must(EVP_CipherUpdate(context_.get(), for_openssl(out), &written, for_openssl(cipher_text.data()),
                          size_of(cipher_text)));
  must(EVP_CIPHER_CTX_ctrl(context_.get(), EVP_CTRL_AEAD_SET_TAG, kTagBytes, tag.data()));
  if (EVP_CipherFinal_ex(context_.get(), for_openssl(out) + written, &written) == 1) return true;
  std::fill_n(out, cipher_text.size(), std::byte{0});
  return false;
}

}  // namespace telepalp::link
