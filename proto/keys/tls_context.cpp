#include "proto/keys/tls_context.h"

#include <openssl/err.h>
#include <openssl/x509v3.h>

#include <utility>

#include "proto/keys/certificate.h"

namespace telepalp::keys {
namespace {

/// AES-128 first: it is the cheapest, and 128 bits are enough.
constexpr const char* kCiphers = "TLS_AES_128_GCM_SHA256:TLS_AES_256_GCM_SHA384:TLS_CHACHA20_POLY1305_SHA256";
constexpr const char* kAskTechnician = "ask the technician for a key: telepalp-keys client --name NAME --role ROLE";

void free_is_revoked(void*, void* kept, CRYPTO_EX_DATA*, int, long, void*) { delete static_cast<IsRevoked*>(kept); }

int revocation_slot() {
  static const int slot =
      CRYPTO_get_ex_new_index(CRYPTO_EX_INDEX_SSL_CTX, 0, nullptr, nullptr, nullptr, free_is_revoked);
  return slot;
}

/// OpenSSL has checked signature, dates and purpose; this adds the revocations.
int check_certificate(int fine, X509_STORE_CTX* store) {
  if (fine == 0 || X509_STORE_CTX_get_error_depth(store) != 0) return fine;
  const auto* session = static_cast<SSL*>(X509_STORE_CTX_get_ex_data(store, SSL_get_ex_data_X509_STORE_CTX_idx()));
  const auto* is_revoked = static_cast<IsRevoked*>(SSL_CTX_get_ex_data(SSL_get_SSL_CTX(session), revocation_slot()));
  X509& certificate = *X509_STORE_CTX_get_current_cert(store);
  const Result<Identity> person = identity_of(certificate);
  Identity who;
  if (person)
    who = *person;
  else
    who.name = common_name(certificate);
  who.serial = serial_of(*X509_get0_serialNumber(&certificate));
  if (is_revoked == nullptr || !(*is_revoked)(who)) return 1;
  X509_STORE_CTX_set_error(store, X509_V_ERR_CERT_REVOKED);
  return 0;
}

/// A context that shows `key`, if it has a certificate, and trusts its authority.
Result<TlsContextPtr> make_context(const SSL_METHOD* method, const KeyFile& key) {
  Result<TlsContextPtr> bare = bare_context(method);
  if (!bare) return bare;
  TlsContextPtr context = std::move(bare).value();
  const std::vector<CertificatePtr> authority = certificates_in(key.authority);
  bool made =
      !authority.empty() && X509_STORE_add_cert(SSL_CTX_get_cert_store(context.get()), authority.front().get()) == 1;
  if (made && !key.certificate.empty()) {
    const std::vector<CertificatePtr> own = certificates_in(key.certificate);
    made = !own.empty() && key.private_key && SSL_CTX_use_certificate(context.get(), own.front().get()) == 1 &&
           SSL_CTX_use_PrivateKey(context.get(), key.private_key.get()) == 1;
  }
  if (!made) return openssl_error("TLS");
  // A person may be called anna.huber, which OpenSSL would compare with the hosts for which the authority may sign.
  X509_VERIFY_PARAM_set_hostflags(SSL_CTX_get0_param(context.get()), X509_CHECK_FLAG_NEVER_CHECK_SUBJECT);
  return context;
}

/// The client refused the server's certificate.
Error bad_server(long verdict, const KeyFile& key, const std::string& host) {
  switch (verdict) {
    case X509_V_ERR_HOSTNAME_MISMATCH:
    case X509_V_ERR_IP_ADDRESS_MISMATCH:
      return error_without_place(
          "the server's key is not for the host " + host,
          "connect to a host that the server's key names, or ask the technician to make the server's key "
          "again with --host " +
              host);
    case X509_V_ERR_PERMITTED_VIOLATION:
      return error_without_place("the server's key names a host for which its authority may not sign",
                                 "ask the technician; this may be a server that pretends to be another one");
    case X509_V_ERR_CERT_HAS_EXPIRED:
      return error_without_place(
          "the server's key has expired",
          "ask the technician to renew it (telepalp-keys renew server.key) and to restart the server");
    case X509_V_ERR_CERT_NOT_YET_VALID:
      return error_without_place(
          "the server's key is not valid yet",
          "set the clock of this computer; if it is right, ask the technician to make the server's key "
          "again, at a computer whose clock is right");
    default:
      return error_without_place(
          "the server's key was not made by the authority " + key.authority_name + ", which made your key (" +
              X509_verify_cert_error_string(verdict) + ")",
          "give a key that the authority of this server made, or connect to the address of the server that "
          "your key is for");
  }
}

/// The server refused the client's certificate.
std::optional<Error> bad_client(int reason) {
  switch (reason) {
    case SSL_R_SSLV3_ALERT_CERTIFICATE_EXPIRED:
      return error_without_place("the server refuses your key: it has expired",
                                 "ask the technician of the server to renew it: telepalp-keys renew FILE");
    case SSL_R_SSLV3_ALERT_CERTIFICATE_REVOKED:
      return error_without_place("the server refuses your key: it is revoked", kAskTechnician);
    case SSL_R_TLSV1_ALERT_UNKNOWN_CA:
      return error_without_place("the server refuses your key: another authority made it", kAskTechnician);
    case SSL_R_TLSV13_ALERT_CERTIFICATE_REQUIRED:
    case SSL_R_SSLV3_ALERT_BAD_CERTIFICATE:
    case SSL_R_SSLV3_ALERT_UNSUPPORTED_CERTIFICATE:
    case SSL_R_SSLV3_ALERT_CERTIFICATE_UNKNOWN:
    case SSL_R_TLSV1_ALERT_DECRYPT_ERROR:
      return error_without_place(
          "the server refuses your key: it is damaged, is not a person's key, or is not valid yet by the server's "
          "clock",
          kAskTechnician);
    default:
      return std::nullopt;
  }
}

}  // namespace

Result<TlsContextPtr> bare_context(const SSL_METHOD* method) {
  TlsContextPtr context(SSL_CTX_new(method));
  if (!context || SSL_CTX_set_min_proto_version(context.get(), TLS1_3_VERSION) != 1 ||
      SSL_CTX_set_ciphersuites(context.get(), kCiphers) != 1)
    return openssl_error("TLS");
  SSL_CTX_set_session_cache_mode(context.get(), SSL_SESS_CACHE_OFF);
  SSL_CTX_set_num_tickets(context.get(), 0);
  SSL_CTX_set_options(context.get(), SSL_OP_NO_TICKET | SSL_OP_NO_RENEGOTIATION);
  return context;
}

Result<TlsContextPtr> server_context(const KeyFile& key, IsRevoked is_revoked) {
  Result<TlsContextPtr> context = make_context(TLS_server_method(), key);
  if (!context) return context;
  SSL_CTX* const made = context->get();
  SSL_CTX_set_ex_data(made, revocation_slot(), new IsRevoked(std::move(is_revoked)));
  SSL_CTX_set_verify(made, SSL_VERIFY_PEER, check_certificate);  // a peer without a certificate brings a token
  const std::vector<CertificatePtr> authority = certificates_in(key.authority);
  SSL_CTX_add_client_CA(made, authority.front().get());
  return context;
}

Result<TlsContextPtr> web_server_context(const KeyFile& key) { return make_context(TLS_server_method(), key); }

Result<TlsContextPtr> client_context(const KeyFile& key) {
  Result<TlsContextPtr> context = make_context(TLS_client_method(), key);
  if (context) SSL_CTX_set_verify(context->get(), SSL_VERIFY_PEER, nullptr);
  return context;
}

namespace {

/// Refuses each certificate, as one of another host.
int refuse_host(int, X509_STORE_CTX* checked) {
  X509_STORE_CTX_set_error(checked, X509_V_ERR_HOSTNAME_MISMATCH);
  return 0;
}

/// OpenSSL's macro SSL_set_tlsext_host_name, without its cast.
bool name_in_greeting(SSL& session, std::string name) {
  return SSL_ctrl(&session, SSL_CTRL_SET_TLSEXT_HOSTNAME, TLSEXT_NAMETYPE_host_name, name.data()) == 1;
}

}  // namespace

void expect_host(SSL& session, const std::string& host) {
  X509_VERIFY_PARAM* const checks = SSL_get0_param(&session);
  X509_VERIFY_PARAM_set_hostflags(checks, X509_CHECK_FLAG_NO_WILDCARDS | X509_CHECK_FLAG_NEVER_CHECK_SUBJECT);
  if (X509_VERIFY_PARAM_set1_ip_asc(checks, host.c_str()) == 1) return;
  ERR_clear_error();
  // Security: OpenSSL checks no name at all when none is set, which an empty name does, too.
  if (!host.empty() && X509_VERIFY_PARAM_set1_host(checks, host.c_str(), host.size()) == 1 &&
      name_in_greeting(session, host))
    return;
  ERR_clear_error();
  SSL_set_verify(&session, SSL_VERIFY_PEER, refuse_host);
}

std::optional<Identity> identity_of_peer(SSL& session) {
  X509* const certificate = SSL_get0_peer_certificate(&session);
  if (certificate == nullptr || SSL_get_verify_result(&session) != X509_V_OK) return std::nullopt;
  Result<Identity> identity = identity_of(*certificate);
  if (!identity) return std::nullopt;
  return std::move(identity).value();
}

HostCertificate host_certificate_of_peer(SSL& session) {
  X509* const certificate = SSL_get0_peer_certificate(&session);
  if (certificate == nullptr || SSL_get_verify_result(&session) != X509_V_OK) return {};
  return {.hosts = host_names(*certificate), .serial = serial_of(*X509_get0_serialNumber(certificate))};
}

std::optional<ServerCertificate> certificate_of_server(SSL& session) {
  X509* const certificate = SSL_get0_peer_certificate(&session);
  if (certificate == nullptr || SSL_get_verify_result(&session) != X509_V_OK) return std::nullopt;
  return ServerCertificate{.serial = serial_of(*X509_get0_serialNumber(certificate)),
                           .promises_list = promises_list(*certificate)};
}

std::optional<std::array<std::byte, 32>> keying_material(SSL& session, std::string_view label) {
  std::array<std::byte, 32> bytes{};
  if (SSL_is_init_finished(&session) != 1 ||
      SSL_export_keying_material(&session, reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), label.data(),
                                 label.size(), nullptr, 0, 0) != 1)
    return std::nullopt;
  return bytes;
}

std::optional<Error> refusal_of(SSL& session, unsigned long code, const KeyFile& key, const std::string& host) {
  const int reason = ERR_GET_REASON(code);
  if (reason == SSL_R_CERTIFICATE_VERIFY_FAILED) return bad_server(SSL_get_verify_result(&session), key, host);
  if (reason == SSL_R_WRONG_VERSION_NUMBER || reason == SSL_R_HTTP_REQUEST || reason == SSL_R_UNSUPPORTED_PROTOCOL)
    return error_without_place(
        "the server does not use TLS 1.3, so it cannot check a key",
        "start the server with --key; or leave out --key of this program, if the server is on this machine");
  return bad_client(reason);
}

}  // namespace telepalp::keys
