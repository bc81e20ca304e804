#include "proto/keys/certificate.h"

#include <arpa/inet.h>
#include <openssl/err.h>
#include <openssl/x509v3.h>

#include <array>
#include <bit>

namespace telepalp::keys {
namespace {

using NamesPtr = std::unique_ptr<GENERAL_NAMES, Freed<GENERAL_NAMES_free>>;
using ExtensionPtr = std::unique_ptr<X509_EXTENSION, Freed<X509_EXTENSION_free>>;

bool add_extension(X509& certificate, X509& issuer, int kind, const std::string& value) {
  X509V3_CTX context;
  X509V3_set_ctx(&context, &issuer, &certificate, nullptr, nullptr, 0);
  const ExtensionPtr extension(X509V3_EXT_conf_nid(nullptr, &context, kind, value.c_str()));
  return extension && X509_add_ext(&certificate, extension.get(), -1) == 1;
}

bool add_extensions(X509& certificate, X509& issuer, const CertificateRequest& request) {
  const bool authority = request.usage.empty();
  bool added = add_extension(certificate, issuer, NID_basic_constraints,
                             authority ? "critical,CA:TRUE,pathlen:0" : "critical,CA:FALSE");
  added = added && add_extension(certificate, issuer, NID_key_usage,
                                 authority ? "critical,keyCertSign,cRLSign" : "critical,digitalSignature");
  added = added && add_extension(certificate, issuer, NID_subject_key_identifier, "hash");
  if (!authority) {
    added = added && add_extension(certificate, issuer, NID_authority_key_identifier, "keyid:always");
    added = added && add_extension(certificate, issuer, NID_ext_key_usage, request.usage);
  }
  if (!request.limits.empty()) {  // such an authority is for TLS alone: it signs neither programs nor mail
    added = added && add_extension(certificate, issuer, NID_name_constraints, request.limits);
    added = added && add_extension(certificate, issuer, NID_ext_key_usage, "serverAuth,clientAuth");
  }
  if (!request.alt_names.empty())
    added = added && add_extension(certificate, issuer, NID_subject_alt_name, request.alt_names);
  return added;
}

bool set_serial(X509& certificate, const std::string& serial) {
  BIGNUM* number = nullptr;
  if (BN_hex2bn(&number, serial.c_str()) == 0) return false;
  const std::unique_ptr<BIGNUM, Freed<BN_free>> owned(number);
  return BN_to_ASN1_INTEGER(number, X509_get_serialNumber(&certificate)) != nullptr;
}

bool set_validity(X509& certificate, WallTime from, WallTime until) {
  return ASN1_TIME_set(X509_getm_notBefore(&certificate), std::chrono::system_clock::to_time_t(from)) != nullptr &&
         ASN1_TIME_set(X509_getm_notAfter(&certificate), std::chrono::system_clock::to_time_t(until)) != nullptr;
}

bool set_subject(X509& certificate, const std::string& name) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(name.c_str());
  return X509_NAME_add_entry_by_NID(X509_get_subject_name(&certificate), NID_commonName, MBSTRING_UTF8, bytes,
                                    static_cast<int>(name.size()), -1, 0) == 1;
}

NamesPtr alt_names_of(X509& certificate) {
  return NamesPtr(static_cast<GENERAL_NAMES*>(X509_get_ext_d2i(&certificate, NID_subject_alt_name, nullptr, nullptr)));
}

std::string text_of(const ASN1_STRING& text) {
  return {reinterpret_cast<const char*>(ASN1_STRING_get0_data(&text)),
          static_cast<std::size_t>(ASN1_STRING_length(&text))};
}

std::string address_of(const ASN1_OCTET_STRING& bytes) {
  const std::string octets = text_of(bytes);
  std::array<char, INET6_ADDRSTRLEN> text{};
  const int family = octets.size() == 4 ? AF_INET : AF_INET6;
  if (octets.size() != 4 && octets.size() != 16) return {};
  return inet_ntop(family, octets.data(), text.data(), text.size()) == nullptr ? "" : text.data();
}

}  // namespace

Result<CertificatePtr> make_certificate(const CertificateRequest& request, EVP_PKEY& key, X509* issuer,
                                        EVP_PKEY& issuer_key) {
  CertificatePtr certificate(X509_new());
  X509& made = *certificate;
  X509& signer = issuer == nullptr ? made : *issuer;
  const bool filled = X509_set_version(&made, 2) == 1 && set_serial(made, request.serial) &&
                      set_validity(made, request.from, request.until) && set_subject(made, request.name) &&
                      X509_set_issuer_name(&made, X509_get_subject_name(&signer)) == 1 &&
                      X509_set_pubkey(&made, &key) == 1 && add_extensions(made, signer, request) &&
                      X509_sign(&made, &issuer_key, EVP_sha256()) != 0;
  if (!filled) return openssl_error("certificate of " + request.name);
  return certificate;
}

Result<Identity> identity_of(X509& certificate) {
  const Error no_role{.what = "the certificate of '" + common_name(certificate) + "' names no role",
                      .where = "key",
                      .fix = "make a key with a role: telepalp-keys client --name NAME --role ROLE"};
  const NamesPtr names = alt_names_of(certificate);
  for (int i = 0; names && i < sk_GENERAL_NAME_num(names.get()); ++i) {
    const GENERAL_NAME& one = *sk_GENERAL_NAME_value(names.get(), i);
    if (one.type != GEN_URI) continue;
    const std::string uri = text_of(*one.d.uniformResourceIdentifier);
    if (!uri.starts_with(kRoleUri)) continue;
    const std::optional<Role> role = role_named(std::string_view(uri).substr(kRoleUri.size()));
    if (!role) return no_role;
    return Identity{.name = common_name(certificate),
                    .role = *role,
                    .serial = serial_of(*X509_get0_serialNumber(&certificate)),
                    .expires = time_of(*X509_get0_notAfter(&certificate))};
  }
  return no_role;
}

std::string common_name(X509& certificate) {
  std::array<char, 256> text{};
  X509_NAME_get_text_by_NID(X509_get_subject_name(&certificate), NID_commonName, text.data(), text.size());
  return text.data();
}

std::vector<std::string> host_names(X509& certificate) {
  std::vector<std::string> hosts;
  const NamesPtr names = alt_names_of(certificate);
  for (int i = 0; names && i < sk_GENERAL_NAME_num(names.get()); ++i) {
    const GENERAL_NAME& one = *sk_GENERAL_NAME_value(names.get(), i);
    if (one.type == GEN_DNS) hosts.push_back(text_of(*one.d.dNSName));
    if (one.type == GEN_IPADD) hosts.push_back(address_of(*one.d.iPAddress));
  }
  return hosts;
}

bool promises_list(X509& certificate) {
  const NamesPtr names = alt_names_of(certificate);
  for (int i = 0; names && i < sk_GENERAL_NAME_num(names.get()); ++i) {
    const GENERAL_NAME& one = *sk_GENERAL_NAME_value(names.get(), i);
    if (one.type == GEN_URI && text_of(*one.d.uniformResourceIdentifier) == kListUri) return true;
  }
  return false;
}

bool is_authority(X509& certificate) { return X509_check_ca(&certificate) == 1; }

namespace {

using LimitsPtr = std::unique_ptr<NAME_CONSTRAINTS, Freed<NAME_CONSTRAINTS_free>>;
using StorePtr = std::unique_ptr<X509_STORE, Freed<X509_STORE_free>>;
using CheckPtr = std::unique_ptr<X509_STORE_CTX, Freed<X509_STORE_CTX_free>>;

/// Address and mask, one after the other: "10.0.0.0/8".
std::string network_of(const ASN1_OCTET_STRING& bytes) {
  const std::string octets = text_of(bytes);
  const std::size_t half = octets.size() / 2;
  std::array<char, INET6_ADDRSTRLEN> text{};
  if (half != 4 && half != 16) return "?";
  inet_ntop(half == 4 ? AF_INET : AF_INET6, octets.data(), text.data(), text.size());
  int ones = 0;
  for (const char byte : octets.substr(half)) ones += std::popcount(static_cast<unsigned char>(byte));
  const bool is_one = static_cast<std::size_t>(ones) == half * 8;
  return text.data() + (is_one ? "" : "/" + std::to_string(ones));
}

}  // namespace

std::vector<std::string> permitted_hosts(X509& authority) {
  std::vector<std::string> hosts;
  const LimitsPtr limits(
      static_cast<NAME_CONSTRAINTS*>(X509_get_ext_d2i(&authority, NID_name_constraints, nullptr, nullptr)));
  const int count = limits ? sk_GENERAL_SUBTREE_num(limits->permittedSubtrees) : 0;
  for (int i = 0; i < count; ++i) {
    const GENERAL_NAME& one = *sk_GENERAL_SUBTREE_value(limits->permittedSubtrees, i)->base;
    if (one.type == GEN_DNS) hosts.push_back(text_of(*one.d.dNSName));
    if (one.type == GEN_IPADD) hosts.push_back(network_of(*one.d.iPAddress));
  }
  return hosts;
}

bool is_permitted(X509& certificate, X509& authority) {
  const StorePtr store(X509_STORE_new());
  const CheckPtr check(X509_STORE_CTX_new());
  X509_STORE_add_cert(store.get(), &authority);
  if (X509_STORE_CTX_init(check.get(), store.get(), &certificate, nullptr) != 1) return false;
  X509_VERIFY_PARAM* const how = X509_STORE_CTX_get0_param(check.get());
  X509_VERIFY_PARAM_set_flags(how, X509_V_FLAG_NO_CHECK_TIME);
  X509_VERIFY_PARAM_set_hostflags(how, X509_CHECK_FLAG_NEVER_CHECK_SUBJECT);
  const bool permitted = X509_verify_cert(check.get()) == 1;
  ERR_clear_error();
  return permitted;
}

}  // namespace telepalp::keys
