#pragma once

#include <openssl/bn.h>
#include <openssl/core_names.h>
#include <openssl/ec.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <openssl/rsa.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace telepalp::oidc {

inline std::string base64url(std::string_view bytes) {
  std::vector<unsigned char> text(4 * (bytes.size() / 3 + 1) + 1);
  const int size = EVP_EncodeBlock(text.data(), reinterpret_cast<const unsigned char*>(bytes.data()),
                                   static_cast<int>(bytes.size()));
  std::string encoded(reinterpret_cast<const char*>(text.data()), static_cast<std::size_t>(size));
  while (encoded.ends_with('=')) encoded.pop_back();
  for (char& letter : encoded) letter = letter == '+' ? '-' : letter == '/' ? '_' : letter;
  return encoded;
}

/// A provider's key, made and used by OpenSSL alone: the tests' oracle for the library that checks its signatures.
class SigningKey {
 public:
  static SigningKey rsa(unsigned bits = 2048) { return SigningKey(EVP_RSA_gen(bits)); }
  static SigningKey p256() { return SigningKey(EVP_EC_gen("P-256")); }

  /// As a JSON Web Key (RFC 7517). `more`: further members, each with a comma before it.
  std::string jwk(const std::string& id, const std::string& more = "") const {
    const std::string begin = R"({"kid":")" + id + R"(","use":"sig")" + more;
    if (is_rsa()) return begin + R"(,"kty":"RSA","n":")" + number("n") + R"(","e":")" + number("e") + "\"}";
    return begin + R"(,"kty":"EC","crv":"P-256","x":")" + number("qx") + R"(","y":")" + number("qy") + "\"}";
  }

  /// A token of `header` and `claims` (JSON) in the compact form (RFC 7515). `pss`: PS256 instead of RS256.
  std::string sign(const std::string& header, const std::string& claims, bool pss = false) const {
    const std::string text = base64url(header) + "." + base64url(claims);
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
    EVP_PKEY_CTX* settings = nullptr;
    EVP_DigestSignInit(context.get(), &settings, EVP_sha256(), nullptr, key_.get());
    if (pss) {
      EVP_PKEY_CTX_set_rsa_padding(settings, RSA_PKCS1_PSS_PADDING);
      EVP_PKEY_CTX_set_rsa_pss_saltlen(settings, 32);
    }
    std::string signature(1024, '\0');
    std::size_t size = signature.size();
    EVP_DigestSign(context.get(), reinterpret_cast<unsigned char*>(signature.data()), &size,
                   reinterpret_cast<const unsigned char*>(text.data()), text.size());
    signature.resize(size);
    return text + "." + base64url(is_rsa() ? signature : raw(signature));
  }

 private:
  explicit SigningKey(EVP_PKEY* key) : key_(key, &EVP_PKEY_free) {}
  bool is_rsa() const { return EVP_PKEY_get_base_id(key_.get()) == EVP_PKEY_RSA; }

  std::string number(const char* name) const {
    BIGNUM* value = nullptr;
    EVP_PKEY_get_bn_param(key_.get(), name, &value);
    const std::unique_ptr<BIGNUM, decltype(&BN_free)> owned(value, &BN_free);
    std::string bytes(static_cast<std::size_t>(is_rsa() ? BN_num_bytes(value) : 32), '\0');
    BN_bn2binpad(value, reinterpret_cast<unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
    return base64url(bytes);
  }

  /// The two numbers of an ECDSA signature, 32 bytes each, instead of OpenSSL's DER.
  static std::string raw(const std::string& der) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(der.data());
    const std::unique_ptr<ECDSA_SIG, decltype(&ECDSA_SIG_free)> read(
        d2i_ECDSA_SIG(nullptr, &bytes, static_cast<long>(der.size())), &ECDSA_SIG_free);
    std::string both(64, '\0');
    BN_bn2binpad(ECDSA_SIG_get0_r(read.get()), reinterpret_cast<unsigned char*>(both.data()), 32);
    BN_bn2binpad(ECDSA_SIG_get0_s(read.get()), reinterpret_cast<unsigned char*>(both.data()) + 32, 32);
    return both;
  }

  std::shared_ptr<EVP_PKEY> key_;
};

}  // namespace telepalp::oidc
