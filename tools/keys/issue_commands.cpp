#include <algorithm>

#include "proto/keys/role.h"
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

/// Writes the key and describes it.
Result<std::string> keep(const KeyFolder& folder, const Result<std::string>& text, const std::filesystem::path& file,
                         bool replace, const std::string& use) {
  if (!text) return text.error();
  if (const Result<void> kept = folder.keep(*text, file, replace); !kept) return kept.error();
  const Result<KeyFile> key = keys::read_key(*text, file.string());
  if (!key) return key.error();
  return file.string() + ": " + keys::in_words(*key) + "use:        " + use + "\n";
}

/// The start of a command that the role allows.
std::string program_of(keys::Role role) {
  if (role == keys::Role::Doctor) return "telepalp-station --connect SERVER";
  return keys::allows(role, keys::Operation::Record) ? "telepalp-record --connect SERVER --out FILE.mcap"
                                                     : "telepalp-view --connect SERVER --snapshot FILE.png";
}

Result<std::string> issue(const Asked& asked, const keys::Authority::Issue& what, const KeyFile& like,
                          const std::filesystem::path& file, bool replace, const KeyFolder& folder) {
  switch (like.kind) {
    case KeyFile::Kind::Server:
      return keep(folder, folder.authority().server_key(what, like.hosts), file, replace,
                  "telepalp-server --bind 0.0.0.0 --key " + file.string());
    case KeyFile::Kind::Client:
      return keep(folder, folder.authority().client_key(what), file, replace,
                  program_of(what.role) + " --key " + file.string());
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
  const keys::Authority::Issue what{
      .name = asked.name, .role = *role, .now = asked.now, .valid = asked.valid.value_or(valid)};
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

Result<std::string> make_authority(const Asked& asked) {
  const std::string name = asked.name.empty() ? "telepalp" : asked.name;
  const Result<KeyFolder> made = KeyFolder::create(asked.folder, name, asked.now, asked.valid.value_or(kAuthorityDays));
  if (!made) return made.error();
  return made->path("authority.key").string() + ": the key of the certificate authority " + name +
         ". This key signs all other keys: keep the file on this machine.\n" + made->path("authority.crt").string() +
         ": the authority's certificate, for browsers. This file may be given to anyone.\nnext:       telepalp-keys "
         "server --dir " +
         asked.folder.string() + " --host NAME-OR-ADDRESS-OF-THE-SERVER\n";
}

Result<std::string> make_server_key(const Asked& asked) {
  const Result<KeyFolder> folder = KeyFolder::open(asked.folder);
  if (!folder) return folder.error();
  KeyFile like;
  like.kind = KeyFile::Kind::Server;
  like.hosts = asked.hosts;
  const std::string name = asked.name.empty() ? "server" : asked.name;
  return issue(asked, {.name = name, .now = asked.now, .valid = asked.valid.value_or(kKeyDays)}, like,
               folder->path(name + ".key"), false, *folder);
}

Result<std::string> make_client_key(const Asked& asked) {
  return make_for_a_person(asked, KeyFile::Kind::Client, kKeyDays, ".key");
}

Result<std::string> make_token(const Asked& asked) {
  return make_for_a_person(asked, KeyFile::Kind::Token, kTokenDays, ".token");
}

Result<std::string> renew(const Asked& asked) {
  const Result<KeyFolder> folder = KeyFolder::open(asked.folder);
  if (!folder) return folder.error();
  const Result<std::string> text = read_file(asked.file, keys::kMaxKeyFileBytes);
  if (!text) return text.error();
  const Result<KeyFile> old = keys::read_key(*text, asked.file);
  if (!old) return old.error();
  if (old->authority != folder->authority().certificate())
    return Error{.what = "another authority made this key",
                 .where = asked.file,
                 .fix = "give the folder of the authority " + old->authority_name + " with --dir"};
  const days valid = asked.valid.value_or(old->kind == KeyFile::Kind::Token ? kTokenDays : kKeyDays);
  const Result<std::string> renewed =
      issue(asked, {.name = old->identity.name, .role = old->identity.role, .now = asked.now, .valid = valid}, *old,
            asked.file, true, *folder);
  if (!renewed) return renewed.error();
  return *renewed + "the old key or token is valid until " + keys::in_words(old->identity.expires) +
         "; to revoke it now: telepalp-keys revoke " + old->identity.serial + " --dir " + asked.folder.string() + "\n";
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
    const Result<std::string> text = read_file(asked.file, keys::kMaxKeyFileBytes);
    if (!text) return text.error();
    const Result<KeyFile> key = keys::read_key(*text, asked.file);
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
