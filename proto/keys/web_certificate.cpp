#include "proto/keys/web_certificate.h"

#include <openssl/err.h>
#include <openssl/x509v3.h>

#include <optional>

#include "proto/keys/certificate.h"
#include "proto/keys/key_file.h"
#include "proto/keys/secret/small_file.h"

namespace telepalp::keys {
namespace {

Error certificate_refused(std::string what, const std::filesystem::path& file, std::string fix) {
  return {.what = std::move(what), .where = file.string(), .fix = std::move(fix)};
}

Result<std::string> text_of(const std::filesystem::path& file) {
  const std::optional<std::string> text = read_small_file(file, kMaxKeyFileBytes);
  if (text && text->size() <= kMaxKeyFileBytes) return *text;
  return certificate_refused(text ? "the file is larger than 64 KiB" : "the file cannot be read", file,
                             "give a file in PEM that this program may read");
}

Result<void> check_server(X509& certificate, WallTime now, const std::filesystem::path& file) {
  if (time_of(*X509_get0_notAfter(&certificate)) <= now)
    return certificate_refused("this certificate expired on " + in_words(time_of(*X509_get0_notAfter(&certificate))),
                               file, "get a new one from the authority that issued it");
  const bool is_for_servers = X509_check_purpose(&certificate, X509_PURPOSE_SSL_SERVER, 0) == 1;
  ERR_clear_error();
  if (is_for_servers && !host_names(certificate).empty()) return {};
  return certificate_refused("the first certificate of this file is not for a web server, or names no host", file,
                             "put the server's certificate first, then those of the authorities between");
}

}  // namespace

Result<WebCertificate> load_web_certificate(const std::filesystem::path& certificate, const std::filesystem::path& key,
                                            WallTime now, const AskPassphrase& ask) {
  const Result<std::string> chain = text_of(certificate);
  if (!chain) return chain.error();
  const std::vector<CertificatePtr> certificates = certificates_in(*chain);
  if (certificates.empty())
    return certificate_refused("this file holds no certificate in PEM", certificate, "give one in PEM");
  X509& own = *certificates.front();
  if (const Result<void> fine = check_server(own, now, certificate); !fine) return fine.error();
  const Result<std::string> secret = text_of(key);
  if (!secret) return secret.error();
  if (secret_in(*secret) == Secret::None)
    return certificate_refused("this file holds no private key in PEM", key,
                               "give the private key of the certificate, in PEM");
  if (const Result<void> hidden = check_private(key); !hidden) return hidden.error();
  const Result<OwnKey> opened = open_private_key(*secret, key.string(), ask);
  if (!opened) return opened.error();
  const bool belong = X509_check_private_key(&own, opened->key.get()) == 1;
  ERR_clear_error();
  if (!belong)
    return certificate_refused("the private key is not that of the certificate " + certificate.string(), key,
                               "give the key for which this certificate was issued");
  std::string whole;
  for (const CertificatePtr& one : certificates) whole += to_pem(*one);
  return WebCertificate{.chain = whole,
                        .private_key = opened->key,
                        .hosts = host_names(own),
                        .expires = time_of(*X509_get0_notAfter(&own))};
}

Result<TlsContextPtr> web_server_context(const WebCertificate& certificate) {
  const std::vector<CertificatePtr> chain = certificates_in(certificate.chain);
  Result<TlsContextPtr> context = bare_context(TLS_server_method());
  if (!context) return context;
  SSL_CTX* const made = context->get();
  bool shown = SSL_CTX_use_certificate(made, chain.front().get()) == 1 &&
               SSL_CTX_use_PrivateKey(made, certificate.private_key.get()) == 1;
  for (std::size_t at = 1; at < chain.size(); ++at)
    shown = shown && SSL_CTX_add1_chain_cert(made, chain[at].get()) == 1;
  if (!shown) return openssl_error("TLS of the web port");
  return context;
}

}  // namespace telepalp::keys
