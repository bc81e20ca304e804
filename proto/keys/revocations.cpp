#include "proto/keys/revocations.h"

#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include "proto/keys/x509/openssl.h"

namespace telepalp::keys {
namespace {

std::uint64_t number_of(const X509_CRL& list) {
  const std::unique_ptr<ASN1_INTEGER, Freed<ASN1_INTEGER_free>> number(
      static_cast<ASN1_INTEGER*>(X509_CRL_get_ext_d2i(&list, NID_crl_number, nullptr, nullptr)));
  std::uint64_t value = 0;
  return number && ASN1_INTEGER_get_uint64(&value, number.get()) == 1 ? value : 0;
}

}  // namespace

Result<Revocations> Revocations::read(std::string_view pem, std::string_view authority, const std::string& file) {
  const std::vector<CertificatePtr> signers = certificates_in(authority);
  const RevocationListPtr list(PEM_read_bio_X509_CRL(reader_of(pem).get(), nullptr, nullptr, nullptr));
  const bool genuine =
      list && !signers.empty() && X509_CRL_verify(list.get(), X509_get0_pubkey(signers.front().get())) == 1;
  ERR_clear_error();
  if (!genuine)
    return Error{.what = "this revocation list is damaged, or was not made by the authority that made the server's key",
                 .where = file,
                 .fix = "copy revoked.crl again from the folder in which telepalp-keys keeps the authority"};
  Revocations revocations;
  STACK_OF(X509_REVOKED)* const revoked = X509_CRL_get_REVOKED(list.get());
  for (int i = 0; i < sk_X509_REVOKED_num(revoked); ++i) {
    const X509_REVOKED& one = *sk_X509_REVOKED_value(revoked, i);
    revocations.revoked_.emplace(serial_of(*X509_REVOKED_get0_serialNumber(&one)),
                                 time_of(*X509_REVOKED_get0_revocationDate(&one)));
  }
  revocations.number_ = number_of(*list);
  return revocations;
}

}  // namespace telepalp::keys
