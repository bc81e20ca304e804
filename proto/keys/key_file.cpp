#include "proto/keys/key_file.h"

#include <openssl/err.h>
#include <openssl/x509v3.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <ctime>
#include <fstream>

#include "proto/keys/certificate.h"
#include "proto/keys/token.h"

namespace telepalp::keys {
namespace {

Error not_a_key(const std::string& file) {
  return {.what = "this is not a key file, or it is damaged",
          .where = file,
          .fix = "give a file that telepalp-keys wrote; replace a damaged file with a copy of the original"};
}

std::string token_line(std::string_view text) {
  const std::size_t at = text.starts_with(kTokenLine) ? 0 : text.find("\n" + std::string(kTokenLine));
  if (at == std::string_view::npos) return {};
  const std::string_view rest = text.substr(text.find(kTokenLine, at) + kTokenLine.size());
  return std::string(rest.substr(0, rest.find_first_of("\r\n")));
}

bool may(X509& certificate, unsigned usage) { return (X509_get_extended_key_usage(&certificate) & usage) != 0; }

Result<KeyFile> read_token_file(const std::string& token, X509& authority, const std::string& file) {
  const Result<Identity> bearer = read_token(token, *X509_get0_pubkey(&authority), WallTime{});
  if (!bearer) return not_a_key(file);
  return KeyFile{.kind = KeyFile::Kind::Token,
                 .certificate = {},
                 .private_key = {},
                 .authority = to_pem(authority),
                 .authority_name = common_name(authority),
                 .token = token,
                 .identity = *bearer,
                 .hosts = {}};
}

Result<KeyFile> read_certificate_file(X509& certificate, EVP_PKEY& key, X509& authority, const std::string& file) {
  const bool belong =
      X509_check_private_key(&certificate, &key) == 1 && X509_verify(&certificate, X509_get0_pubkey(&authority)) == 1;
  ERR_clear_error();
  if (!belong) return not_a_key(file);
  KeyFile read{.kind = may(certificate, XKU_SSL_SERVER) ? KeyFile::Kind::Server : KeyFile::Kind::Client,
               .certificate = to_pem(certificate),
               .private_key = to_pem(key),
               .authority = to_pem(authority),
               .authority_name = common_name(authority),
               .token = {},
               .identity = {.name = common_name(certificate),
                            .role = Role::Viewer,
                            .serial = serial_of(*X509_get0_serialNumber(&certificate)),
                            .expires = time_of(*X509_get0_notAfter(&certificate))},
               .hosts = host_names(certificate)};
  if (read.kind == KeyFile::Kind::Server) return read;
  Result<Identity> identity = identity_of(certificate);
  if (!identity) return Error{.what = identity.error().what, .where = file, .fix = identity.error().fix};
  read.identity = std::move(identity).value();
  return read;
}

/// Error: somebody else than the file's owner has access to it. The group of a file that root owns may read it: so an
/// administrator gives a key to a service that cannot change it.
Result<void> check_private(const struct stat& status, const std::string& file) {
  const mode_t allowed = status.st_uid == 0 ? S_IRWXU | S_IRGRP : S_IRWXU;
  const mode_t mode = status.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
  if ((mode & ~allowed) == 0) return {};
  std::array<char, 8> octal{};
  std::snprintf(octal.data(), octal.size(), "%04o", mode);
  const bool of_a_service = status.st_uid == 0 && ::geteuid() != 0;
  return Error{.what = std::string("users other than its owner have access to this key: its mode is ") + octal.data(),
               .where = file,
               .fix = (of_a_service ? "chmod 640 " : "chmod 600 ") + file};
}

}  // namespace

Result<KeyFile> read_key(std::string_view text, const std::string& file) {
  if (text.size() > kMaxKeyFileBytes) return not_a_key(file);
  const std::vector<CertificatePtr> certificates = certificates_in(text);
  const std::string token = token_line(text);
  if (!token.empty() && certificates.size() == 1) return read_token_file(token, *certificates.front(), file);
  const PrivateKeyPtr key = private_key_in(text);
  if (key && certificates.size() == 1 && is_authority(*certificates.front()))
    return Error{.what = "this is the authority's file: it makes keys, and no program can connect with it",
                 .where = file,
                 .fix = "make a key with telepalp-keys server or telepalp-keys client"};
  if (!key || certificates.size() != 2) return not_a_key(file);
  return read_certificate_file(*certificates.front(), *key, *certificates.back(), file);
}

void forbid_dumps() noexcept { ::prctl(PR_SET_DUMPABLE, 0); }

Result<KeyFile> load_key(const std::filesystem::path& file, WallTime now) {
  forbid_dumps();
  struct stat status {};
  const bool missing = ::stat(file.c_str(), &status) != 0;
  std::ifstream stream(file, std::ios::binary);
  if (missing || !stream)
    return Error{.what = "the key cannot be read",
                 .where = file.string(),
                 .fix = "give a file that telepalp-keys wrote, and that you may read"};
  std::string text(kMaxKeyFileBytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  Result<KeyFile> key = read_key(text, file.string());
  if (!key) return key;
  // Only for a key: the fix is a chmod, and it would harm another file that was named by mistake.
  if (const Result<void> hidden = check_private(status, file.string()); !hidden) return hidden.error();
  if (const Result<void> valid = check_not_expired(*key, now, file.string()); !valid) return valid.error();
  key->path = file;
  return key;
}

Result<std::shared_ptr<const KeyFile>> load_client_key(const std::filesystem::path& file, WallTime now) {
  if (file.empty()) return std::shared_ptr<const KeyFile>();
  Result<KeyFile> key = load_key(file, now);
  if (!key) return key.error();
  if (key->kind == KeyFile::Kind::Server)
    return Error{.what = "this is the key of a server, not of a person",
                 .where = file.string(),
                 .fix = "ask the technician for a key of your own: telepalp-keys client --name NAME --role ROLE"};
  return std::make_shared<const KeyFile>(std::move(key).value());
}

bool replace_file(const std::filesystem::path& file, std::string_view text) {
  const std::filesystem::path part = file.string() + ".part";
  std::error_code failed;
  {
    std::ofstream stream(part, std::ios::binary | std::ios::trunc);
    std::filesystem::permissions(part, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write,
                                 failed);
    if (!(stream << text << std::flush) || failed) return false;
  }
  std::filesystem::rename(part, file, failed);
  return !failed;
}

Result<void> check_not_expired(const KeyFile& key, WallTime now, const std::string& file) {
  if (now < key.identity.expires) return {};
  return Error{.what = "this key expired on " + in_words(key.identity.expires),
               .where = file,
               .fix = "renew the key, or ask the technician to renew it: telepalp-keys renew " + file};
}

std::string in_words(WallTime time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  char text[40];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &parts);
  return text;
}

std::string in_words(const KeyFile& key) {
  std::string text;
  if (key.kind == KeyFile::Kind::Server) {
    text = "server key " + key.identity.name + "\nhosts:     ";
    for (const std::string& host : key.hosts) text += " " + host;
  } else {
    text = std::string(key.kind == KeyFile::Kind::Token ? "token" : "key") + " of " + describe(key.identity) +
           "\nallows:     " + permissions(key.identity.role);
  }
  return text + "\nauthority:  " + key.authority_name + "\nvalid until " + in_words(key.identity.expires) +
         "\nserial:     " + key.identity.serial + "\n";
}

}  // namespace telepalp::keys
