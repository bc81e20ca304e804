#include "proto/keys/key_file.h"

#include <openssl/err.h>
#include <openssl/x509v3.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <optional>

#include "proto/keys/certificate.h"
#include "proto/keys/secret/pkcs11.h"
#include "proto/keys/secret/private_key.h"
#include "proto/keys/secret/small_file.h"
#include "proto/keys/token.h"
#include "proto/words/numbers/utc_text.h"

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
                 .secret = Secret::Plain,
                 .certificate = {},
                 .private_key = {},
                 .authority = to_pem(authority),
                 .authority_name = common_name(authority),
                 .token = token,
                 .identity = *bearer,
                 .hosts = {}};
}

Result<KeyFile> read_certificates(X509& certificate, X509& authority, Secret secret, const std::string& file) {
  const bool belong = X509_verify(&certificate, X509_get0_pubkey(&authority)) == 1;
  ERR_clear_error();
  if (!belong) return not_a_key(file);
  KeyFile read{.kind = may(certificate, XKU_SSL_SERVER) ? KeyFile::Kind::Server : KeyFile::Kind::Client,
               .secret = secret,
               .certificate = to_pem(certificate),
               .private_key = {},
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

/// The key pair was made, but the authority's answer is missing.
Error waits_for_certificate(const std::string& file) {
  const std::string answer = std::filesystem::path(file).replace_extension(".crt").string();
  return {.what = "this private key has no certificate yet",
          .where = file,
          .fix =
              "send the file that telepalp-keys request wrote beside it to the technician, and store the "
              "technician's answer as " +
              answer};
}

/// A private key alone, and the certificates that lie beside it; else `text` as it is.
std::string with_answer(std::string text, const std::filesystem::path& file) {
  if (secret_in(text) == Secret::None || text.find("BEGIN CERTIFICATE-----") != std::string::npos) return text;
  const auto answer = read_small_file(std::filesystem::path(file).replace_extension(".crt"), kMaxKeyFileBytes);
  return answer ? text + "\n" + *answer : text;
}

/// The key of an address in a hardware token, as if a file LABEL.key in the working folder named it.
struct Located {
  std::filesystem::path path;
  std::string text;
};
Result<Located> locate(const std::filesystem::path& file) {
  if (!is_pkcs11(file.string())) {
    Result<std::string> text = read_key_text(file);
    if (!text) return text.error();
    return Located{.path = file, .text = std::move(text).value()};
  }
  const Result<Pkcs11Address> address = read_pkcs11(file.string());
  if (!address) return address.error();
  if (address->object.find('/') != std::string::npos)
    return Error{.what = "the key's label has a slash, so no file can be named after it",
                 .where = address->object,
                 .fix = "write the address into a file of your own: telepalp-keys request --key ADDRESS"};
  const std::filesystem::path named = address->object + ".key";
  return Located{.path = named, .text = with_answer(std::string(kKeyLine) + file.string() + "\n", named)};
}

}  // namespace

Result<void> check_private(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return {};  // the address of a key in a token is no file
  const mode_t allowed = status.st_uid == 0 ? S_IRWXU | S_IRGRP : S_IRWXU;
  const mode_t mode = status.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
  if ((mode & ~allowed) == 0) return {};
  std::array<char, 8> octal{};
  std::snprintf(octal.data(), octal.size(), "%04o", mode);
  const bool of_a_service = status.st_uid == 0 && ::geteuid() != 0;
  return Error{.what = std::string("users other than its owner have access to this key: its mode is ") + octal.data(),
               .where = file.string(),
               .fix = (of_a_service ? "chmod 640 " : "chmod 600 ") + file.string()};
}

Result<KeyFile> read_public_part(std::string_view text, const std::string& file) {
  if (text.size() > kMaxKeyFileBytes) return not_a_key(file);
  const std::vector<CertificatePtr> certificates = certificates_in(text);
  const std::string token = token_line(text);
  if (!token.empty() && certificates.size() == 1) return read_token_file(token, *certificates.front(), file);
  const Secret secret = secret_in(text);
  if (secret != Secret::None && certificates.size() == 1 && is_authority(*certificates.front()))
    return Error{.what = "this is the authority's file: it makes keys, and no program can connect with it",
                 .where = file,
                 .fix = "make a key with telepalp-keys server or telepalp-keys client"};
  if (secret != Secret::None && certificates.empty()) return waits_for_certificate(file);
  if (certificates.size() != 2) return not_a_key(file);
  return read_certificates(*certificates.front(), *certificates.back(), secret, file);
}

Result<KeyFile> read_key(std::string_view text, const std::string& file, const AskPassphrase& ask) {
  Result<KeyFile> key = read_public_part(text, file);
  if (!key || key->kind == KeyFile::Kind::Token) return key;
  if (key->secret == Secret::None) return not_a_key(file);
  Result<OwnKey> opened = open_private_key(text, file, ask);
  if (!opened) return opened.error();
  const bool belong = X509_check_private_key(certificates_in(key->certificate).front().get(), opened->key.get()) == 1;
  ERR_clear_error();
  if (!belong)
    return Error{.what = "the private key and the certificate do not belong together",
                 .where = file,
                 .fix = "put the certificate that the technician made for this key beside it"};
  key->private_key = std::move(opened->key);
  return key;
}

void forbid_dumps() noexcept { ::prctl(PR_SET_DUMPABLE, 0); }

Result<std::string> read_key_text(const std::filesystem::path& file) {
  std::optional<std::string> text = read_small_file(file, kMaxKeyFileBytes);
  if (!text)
    return Error{.what = "the key cannot be read",
                 .where = file.string(),
                 .fix = "give a file that telepalp-keys wrote, and that you may read"};
  if (text->size() > kMaxKeyFileBytes) return not_a_key(file.string());
  return with_answer(*std::move(text), file);
}

namespace {

/// The key of `file` without its private key. Error: it is no key, others may read it, or it has expired.
Result<KeyFile> load_public_part(const Located& located, const std::filesystem::path& file, WallTime now) {
  const std::string name = located.path.string();
  Result<KeyFile> seen = read_public_part(located.text, name);
  if (!seen) return seen;
  // Only for a key: the fix is a chmod, and it would harm another file that was named by mistake. Before the private
  // key is opened: a file that others may write must not choose the driver of a token.
  if (const Result<void> hidden = check_private(file); !hidden) return hidden.error();
  if (const Result<void> valid = check_not_expired(*seen, now, name); !valid) return valid.error();
  seen->path = located.path;
  return seen;
}

}  // namespace

Result<KeyFile> load_key(const std::filesystem::path& file, WallTime now, const AskPassphrase& ask) {
  forbid_dumps();
  const Result<Located> located = locate(file);
  if (!located) return located.error();
  if (const Result<KeyFile> seen = load_public_part(*located, file, now); !seen) return seen;
  Result<KeyFile> key = read_key(located->text, located->path.string(), ask);
  if (key) key->path = located->path;
  return key;
}

Result<KeyFile> load_key_unasked(const std::filesystem::path& file, WallTime now) {
  const Result<Located> located = locate(file);
  if (!located) return located.error();
  Result<KeyFile> seen = load_public_part(*located, file, now);
  if (!seen) return seen;
  const bool needs_passphrase = seen->secret == Secret::Encrypted || seen->secret == Secret::Token;
  if (needs_passphrase && !environment_has_passphrase()) return seen;
  return load_key(file, now, passphrase_of_environment);
}

Result<std::shared_ptr<const KeyFile>> load_client_key(const std::filesystem::path& file, WallTime now,
                                                       const AskPassphrase& ask) {
  if (file.empty()) return std::shared_ptr<const KeyFile>();
  Result<KeyFile> key = load_key(file, now, ask);
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

std::string in_words(WallTime time) { return utc_text(time, "%Y-%m-%d %H:%M UTC"); }

std::string in_words(const KeyFile& key) {
  std::string text;
  if (key.kind == KeyFile::Kind::Server) {
    text = "server key " + key.identity.name + "\nhosts:     ";
    for (const std::string& host : key.hosts) text += " " + host;
  } else {
    text = std::string(key.kind == KeyFile::Kind::Token ? "token" : "key") + " of " + describe(key.identity) +
           "\nallows:     " + permissions(key.identity.role);
  }
  text += "\nauthority:  " + key.authority_name + "\nvalid until " + in_words(key.identity.expires) +
          "\nserial:     " + key.identity.serial + "\n";
  if (key.kind == KeyFile::Kind::Token) return text;
  switch (key.secret) {
    case Secret::Plain:
      return text + "protection: none: anyone who copies the file can use it\n";
    case Secret::Encrypted:
      return text + "protection: a passphrase\n";
    case Secret::Token:
      return text + "protection: the key is in a hardware token\n";
    case Secret::None:
      break;
  }
  return text + "protection: the private key is not in this file; its owner has it\n";
}

}  // namespace telepalp::keys
