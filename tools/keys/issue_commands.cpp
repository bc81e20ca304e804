#include <algorithm>

#include "proto/keys/request/key_request.h"
#include "proto/keys/role.h"
#include "support/program/files/whole_file.h"
#include "tools/keys/commands.h"
#include "tools/keys/key_folder.h"

namespace telepalp::keys_tool {
namespace {

using keys::KeyFile;
using std::chrono::days;

constexpr days kAuthorityDays{3650};
constexpr days kKeyDays{365};
constexpr days kTokenDays{30};

Result<keys::Role> role_of(const Asked& asked) {
  const std::optional<keys::Role> role = keys::role_named(asked.role);
  if (role) return *role;
  return Error{.what = asked.role.empty() ? "no role is given" : "'" + asked.role + "' is not a role",
               .where = "--role",
               .fix = "give technician, doctor, viewer or qa"};
}

/// A warning, if the authority was made by an older telepalp-keys.
std::string note_on_limits(const KeyFolder& folder) {
  if (!folder.authority().hosts().empty()) return "";
  return "note:       this authority may sign for every host, so a browser that trusts it would believe its "
         "certificate for a bank. Limit it to the hosts and networks of your site: telepalp-keys renew " +
         folder.path("authority.key").string() + " --host HOST\n";
}

std::string in_words(const std::vector<std::string>& hosts) {
  std::string text;
  for (const std::string& host : hosts) text += (text.empty() ? "" : ", ") + host;
  return text;
}

/// Writes the key and describes it.
Result<std::string> keep(const KeyFolder& folder, const Result<std::string>& text, const std::filesystem::path& file,
                         bool replace, const std::string& use) {
  if (!text) return text.error();
  if (const Result<void> kept = folder.keep(*text, file, replace); !kept) return kept.error();
  const Result<KeyFile> key = keys::read_public_part(*text, file.string());
  if (!key) return key.error();
  return file.string() + ": " + keys::in_words(*key) + "use:        " + use + "\n" + note_on_limits(folder);
}

/// The start of a command that the role allows.
std::string program_of(keys::Role role) {
  if (role == keys::Role::Doctor) return "telepalp-station --connect SERVER";
  return keys::allows(role, keys::Operation::Record) ? "telepalp-record --connect SERVER --out FILE.mcap"
                                                     : "telepalp-view --connect SERVER --snapshot FILE.png";
}

Result<std::string> issue(const Asked& asked, const keys::Authority::Issue& what, const KeyFile& like,
                          const std::filesystem::path& file, bool replace, const KeyFolder& folder) {
  const std::string answer = "send the file to " + what.name + ", who stores it beside " + what.name + ".key";
  switch (like.kind) {
    case KeyFile::Kind::Server:
      return keep(folder, folder.authority().server_key(what, like.hosts), file, replace,
                  what.key ? answer : "telepalp-server --bind 0.0.0.0 --key " + file.string());
    case KeyFile::Kind::Client:
      return keep(folder, folder.authority().client_key(what), file, replace,
                  what.key ? answer : program_of(what.role) + " --key " + file.string());
    case KeyFile::Kind::Token:
      return keep(folder, folder.authority().token(what), file, replace,
                  "paste the text after `token:` into the browser's sign-in page, or start a program with --key " +
                      file.string());
  }
  return Error{.what = "the file holds neither a key nor a token",
               .where = asked.file,
               .fix = "give a file that telepalp-keys wrote"};
}

Result<std::string> make_for_a_person(const Asked& asked, KeyFile::Kind kind, days valid, const std::string& suffix) {
  const Result<keys::Role> role = role_of(asked);
  if (!role) return role.error();
  const Result<KeyFolder> folder = KeyFolder::open(asked.folder);
  if (!folder) return folder.error();
  KeyFile like;
  like.kind = kind;
  keys::Authority::Issue what{
      .name = asked.name, .role = *role, .now = asked.now, .valid = asked.valid.value_or(valid)};
  if (kind == KeyFile::Kind::Client) {
    Result<keys::OwnKey> own = own_key(asked, "the key of " + asked.name);
    if (!own) return own.error();
    what.own = std::move(own).value();
  }
  return issue(asked, what, like, folder->path(asked.name + suffix), false, *folder);
}

bool is_serial(const std::string& text) {
  return text.size() == 20 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace

Result<void> check_person(const Asked& asked) {
  if (const Result<keys::Role> role = role_of(asked); !role) return role.error();
  if (asked.name.empty())
    return Error{.what = "no name is given", .where = "--name", .fix = "name the person, such as --name anna"};
  return {};
}

Result<void> check_hosts(const Asked& asked) {
  if (asked.hosts.empty())
    return Error{.what = "no host is given",
                 .where = "--host",
                 .fix = "give each name or address that clients write after --connect, such as --host patient.example"};
  return {};
}

Result<void> check_person_or_hosts(const Asked& asked) {
  if (asked.hosts.empty() == asked.role.empty())
    return Error{.what = "the request is for a person or for a server",
                 .where = "sign",
                 .fix = "give --role for a person, or --host for a server, not both"};
  if (!asked.hosts.empty()) return {};
  const Result<keys::Role> role = role_of(asked);
  return role ? Result<void>() : Result<void>(role.error());
}

Result<std::string> make_authority(const Asked& asked) {
  const std::string name = asked.name.empty() ? "telepalp" : asked.name;
  if (const Result<void> none = KeyFolder::check_has_none(asked.folder); !none) return none.error();
  Result<keys::OwnKey> own = own_key(asked, "the authority");
  if (!own) return own.error();
  Result<keys::Authority> authority = keys::Authority::create(name, asked.now, asked.valid.value_or(kAuthorityDays),
                                                              asked.hosts, std::move(own).value());
  if (!authority) return authority.error();
  const Result<KeyFolder> made = KeyFolder::create(asked.folder, std::move(authority).value(), asked.now);
  if (!made) return made.error();
  return made->path("authority.key").string() + ": the key of the certificate authority " + name +
         ". This key signs all other keys: keep the file on this machine.\n" + made->path("authority.crt").string() +
         ": the authority's certificate, for browsers. This file may be given to anyone.\nlimited to: " +
         in_words(made->authority().hosts()) + "\n" +
         (asked.passphrase || !asked.key.empty() ? ""
                                                 : "protection: none: to add a passphrase: telepalp-keys passphrase " +
                                                       made->path("authority.key").string() + "\n") +
         "next:       telepalp-keys server --dir " + asked.folder.string() + " --host NAME-OR-ADDRESS-OF-THE-SERVER\n";
}

Result<std::string> make_server_key(const Asked& asked) {
  const Result<KeyFolder> folder = KeyFolder::open(asked.folder);
  if (!folder) return folder.error();
  KeyFile like;
  like.kind = KeyFile::Kind::Server;
  like.hosts = asked.hosts;
  const std::string name = asked.name.empty() ? "server" : asked.name;
  Result<keys::OwnKey> own = own_key(asked, "the key of the server " + name);
  if (!own) return own.error();
  return issue(asked,
               {.name = name, .now = asked.now, .valid = asked.valid.value_or(kKeyDays), .own = std::move(own).value()},
               like, folder->path(name + ".key"), false, *folder);
}

Result<std::string> make_client_key(const Asked& asked) {
  return make_for_a_person(asked, KeyFile::Kind::Client, kKeyDays, ".key");
}

Result<std::string> make_token(const Asked& asked) {
  return make_for_a_person(asked, KeyFile::Kind::Token, kTokenDays, ".token");
}

Result<std::string> sign(const Asked& asked) {
  const Result<std::string> text = read_file(asked.file, keys::kMaxRequestBytes);
  if (!text) return text.error();
  const Result<keys::KeyRequest> request = keys::read_request(*text, asked.file);
  if (!request) return request.error();
  if (!asked.name.empty() && asked.name != request->name)
    return Error{.what = "the request is for the name " + request->name + ", not for " + asked.name,
                 .where = asked.file,
                 .fix = "ask the person who sent it, or leave --name out"};
  const Result<KeyFolder> folder = KeyFolder::open(asked.folder);
  if (!folder) return folder.error();
  const std::string fingerprint = keys::fingerprint(*request->key);
  if (const Result<void> good = folder->check_not_revoked(fingerprint, asked.file); !good) return good.error();
  KeyFile like;
  like.kind = asked.hosts.empty() ? KeyFile::Kind::Client : KeyFile::Kind::Server;
  like.hosts = asked.hosts;
  const keys::Authority::Issue what{.name = request->name,
                                    .role = keys::role_named(asked.role).value_or(keys::Role::Viewer),
                                    .now = asked.now,
                                    .valid = asked.valid.value_or(kKeyDays),
                                    .key = request->key};
  const Result<std::string> signed_key = issue(asked, what, like, folder->path(request->name + ".crt"), false, *folder);
  if (!signed_key) return signed_key.error();
  return *signed_key + "key:        " + fingerprint +
         "\ncompare:    before you send it, let its sender read this fingerprint out to you; "
         "if it differs, somebody else made the request: revoke the serial\n";
}

namespace {

/// The same authority and key with a new certificate: all that it signed stays valid.
Result<std::string> renew_authority(const Asked& asked, const KeyFolder& folder) {
  if (asked.hosts.empty())
    return Error{.what = "no host is given to which the authority is limited",
                 .where = "--host",
                 .fix = "give each host or network of the site, such as --host 10.0.0.0/8 --host hospital.example"};
  Result<keys::Authority> renewed =
      folder.authority().renewed(asked.now, asked.valid.value_or(kAuthorityDays), asked.hosts);
  if (!renewed) return renewed.error();
  if (const Result<void> written = folder.replace_authority(*renewed); !written) return written.error();
  return folder.path("authority.crt").string() + ": the new certificate of the authority " + renewed->name() +
         "\nlimited to: " + in_words(renewed->hosts()) +
         "\nnext:       in each browser, delete the old certificate of the authority and import the new one. Keys and "
         "tokens stay valid.\n";
}

/// What a renewed key keeps of the old one. A key pair of which the site has only the certificate, or which is in a
/// token, stays; any other is made anew, under the same passphrase.
Result<keys::Authority::Issue> renewed_like(const KeyFile& old, const std::string& text, const Asked& asked) {
  keys::Authority::Issue what{.name = old.identity.name, .role = old.identity.role, .now = asked.now};
  what.valid = asked.valid.value_or(old.kind == KeyFile::Kind::Token ? kTokenDays : kKeyDays);
  if (old.kind == KeyFile::Kind::Token || old.secret == keys::Secret::Plain) return what;
  if (old.secret == keys::Secret::None) {
    what.key = keys::public_key_of(old);
    return what;
  }
  std::string passphrase;
  Result<keys::OwnKey> own =
      keys::open_private_key(text, asked.file, [&](const std::string& of, int attempt) -> Result<std::string> {
        Result<std::string> given = keys::ask_passphrase(of, attempt);
        if (given) passphrase = *given;
        return given;
      });
  if (own && old.secret == keys::Secret::Encrypted) own = keys::make_private_key(passphrase);
  if (!own) return own.error();
  what.own = std::move(own).value();
  return what;
}

}  // namespace

Result<std::string> renew(const Asked& asked) {
  const Result<KeyFolder> folder = KeyFolder::open(asked.folder);
  if (!folder) return folder.error();
  if (program::is_same_file(asked.file, folder->path("authority.key"))) return renew_authority(asked, *folder);
  const Result<std::string> text = keys::read_key_text(asked.file);
  if (!text) return text.error();
  const Result<KeyFile> old = keys::read_public_part(*text, asked.file);
  if (!old) return old.error();
  if (!folder->authority().has_signed(*old))
    return Error{.what = "another authority made this key",
                 .where = asked.file,
                 .fix = "give the folder of the authority " + old->authority_name + " with --dir"};
  const Result<keys::Authority::Issue> what = renewed_like(*old, *text, asked);
  if (!what) return what.error();
  if (what->key)
    if (const Result<void> good = folder->check_not_revoked(keys::fingerprint(*what->key), asked.file); !good)
      return good.error();
  const Result<std::string> renewed = issue(asked, *what, *old, asked.file, true, *folder);
  if (!renewed) return renewed.error();
  const std::string until = " is valid until " + keys::in_words(old->identity.expires);
  if (what->key || old->secret == keys::Secret::Token)
    return *renewed + "the old certificate, of the same private key," + until + "\n";
  return *renewed + "the old key or token" + until + "; to revoke it now: telepalp-keys revoke " +
         old->identity.serial + " --dir " + asked.folder.string() + "\n";
}

Result<std::string> revoke(const Asked& asked) {
  const Result<KeyFolder> folder = KeyFolder::open(asked.folder);
  if (!folder) return folder.error();
  std::string serial = asked.file;
  if (!is_serial(serial)) {
    if (!std::filesystem::exists(asked.file))
      return Error{.what = "is neither a file nor a serial of 20 digits 0 to 9 and a to f",
                   .where = asked.file,
                   .fix = "give the file of the key or token, or its serial: telepalp-keys list --dir " +
                          asked.folder.string() + " prints the serials"};
    const Result<std::string> text = keys::read_key_text(asked.file);
    if (!text) return text.error();
    const Result<KeyFile> key = keys::read_public_part(*text, asked.file);
    if (!key) return key.error();
    serial = key->identity.serial;
  }
  const Result<std::size_t> count = folder->revoke(serial, asked.now);
  if (!count) return count.error();
  const std::string list = folder->path("revoked.crl").string();
  return serial + " is revoked; " + list + " lists all revoked keys and tokens, " + std::to_string(*count) +
         " in number.\nnext:       copy " + list +
         " into the folder of the server's key; the server reads the list within 2 s\n";
}

}  // namespace telepalp::keys_tool
