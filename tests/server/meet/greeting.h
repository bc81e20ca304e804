#pragma once

#include <openssl/ssl.h>

#include <memory>
#include <string>

namespace telepalp::meet {

/// The greeting that OpenSSL's client sends. `alpn`: protocols, each after its length.
inline std::string greeting(std::string name, const std::string& alpn = {}, int padding = 0) {
  const std::unique_ptr<SSL_CTX, decltype(&SSL_CTX_free)> context(SSL_CTX_new(TLS_client_method()), SSL_CTX_free);
  const std::unique_ptr<SSL, decltype(&SSL_free)> session(SSL_new(context.get()), SSL_free);
  BIO* const out = BIO_new(BIO_s_mem());
  SSL_set_bio(session.get(), BIO_new(BIO_s_mem()), out);
  if (!name.empty()) SSL_ctrl(session.get(), SSL_CTRL_SET_TLSEXT_HOSTNAME, TLSEXT_NAMETYPE_host_name, name.data());
  std::string offered = alpn;
  for (int i = 0; i < padding; ++i) offered += '\x04' + std::string("junk");
  SSL_set_alpn_protos(session.get(), reinterpret_cast<const unsigned char*>(offered.data()),
                      static_cast<unsigned>(offered.size()));
  SSL_connect(session.get());
  char* bytes = nullptr;
  const long length = BIO_ctrl(out, BIO_CTRL_INFO, 0, static_cast<void*>(&bytes));
  return {bytes, static_cast<std::size_t>(length)};
}

}  // namespace telepalp::meet
