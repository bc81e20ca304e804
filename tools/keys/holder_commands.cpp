// What the holder of a private key does with it alone, on a computer that has no authority.
#include <algorithm>

#include "proto/keys/request/key_request.h"
#include "proto/keys/seal/site_key.h"
#include "proto/keys/secret/passphrase.h"
#include "support/program/files/whole_file.h"
#include "tools/keys/commands.h"
#include "tools/keys/key_folder.h"

namespace telepalp::keys_tool {
namespace {

using program::Readers;

Error exists_already(const std::filesystem::path& file) {
  return {.what = "the file exists already",
          .where = file.string(),
          .fix = "move it away if its key is no longer used, or give another --name or --dir"};
}

}  // namespace

Result<void> check_name_given(const Asked& asked) {
  if (!asked.name.empty()) return {};
  return Error{.what = "no name is given",
               .where = "--name",
               .fix = "name the person or the server, such as --name anna or --name server"};
}

Result<keys::OwnKey> own_key(const Asked& asked, const std::string& what) {
  if (!asked.key.empty()) return keys::private_key_in_token(asked.key, keys::ask_passphrase);
  if (!asked.passphrase) return keys::make_private_key("");
  const Result<std::string> passphrase = keys::new_passphrase(what);
  if (!passphrase) return passphrase.error();
  return keys::make_private_key(*passphrase);
}

Result<std::string> make_key_and_request(const Asked& asked) {
  const std::filesystem::path file = asked.folder / (asked.name + ".key");
  const std::filesystem::path to_send = asked.folder / (asked.name + ".request");
  for (const std::filesystem::path& made : {file, to_send})
    if (std::filesystem::exists(made)) return exists_already(made);
  const Result<keys::OwnKey> own = own_key(asked, "the key of " + asked.name);
  if (!own) return own.error();
  const Result<std::string> request = keys::make_request(asked.name, *own->key);
  if (!request) return request.error();
  const std::string about = "telepalp: the private key of " + asked.name + ". Its certificate is in the file " +
                            asked.name + ".crt beside it. Never send this file.\n";
  Result<void> done = program::make_folder(asked.folder, Readers::Group);
  if (done) done = program::write_whole_file(file, about + own->text, Readers::Group);
  if (done) done = program::write_whole_file(to_send, *request, Readers::Anyone);
  if (!done) return done.error();
  const std::string in_token = asked.key.empty() ? "" : "the key stays in the token; this file names it. ";
  return file.string() + ": the private key of " + asked.name + ". " + in_token + "It stays on this computer.\n" +
         to_send.string() +
         ": the request for a certificate. It holds no secret.\nkey:        " + keys::fingerprint(*own->key) +
         "\nnext:       send " + to_send.string() +
         " to the technician, and read this fingerprint out to the technician; store the answer, " + asked.name +
         ".crt, in " + asked.folder.string() + "\n";
}

Result<std::string> make_site_key(const Asked& asked) {
  const std::filesystem::path file = asked.folder / (asked.name + "-site.key");
  const std::filesystem::path open_part = asked.folder / (asked.name + "-site.pub");
  for (const std::filesystem::path& made : {file, open_part})
    if (std::filesystem::exists(made)) return exists_already(made);
  const Result<keys::OwnKey> own = own_key(asked, "the key of the site " + asked.name);
  if (!own) return own.error();
  const Result<std::string> shown = keys::public_text(*own->key);
  if (!shown) return shown.error();
  const std::string about = "telepalp: the key of the site " + asked.name + ", for its encrypted recordings. ";
  Result<void> done = program::make_folder(asked.folder, Readers::Group);
  if (done) done = program::write_whole_file(file, about + "It decrypts them.\n" + *shown + own->text, Readers::Group);
  if (done) done = program::write_whole_file(open_part, about + "It only encrypts.\n" + *shown, Readers::Anyone);
  if (!done) return done.error();
  const Result<keys::SiteKey> made = keys::SiteKey::load(open_part);
  if (!made) return made.error();
  return file.string() + ": decrypts the site's recordings. Keep a copy in a safe place: without it they are lost.\n" +
         open_part.string() +
         ": encrypts them. It holds no secret.\nkey:        " + keys::in_hexadecimal_digits(made->id()) +
         "\nuse:        TELEPALP_SITE_KEYS=" + open_part.string() +
         " for programs that only record, TELEPALP_SITE_KEYS=" + file.string() + " for those that play, too\n";
}

Result<std::string> set_passphrase(const Asked& asked) {
  const Result<std::string> text = read_file(asked.file, keys::kMaxKeyFileBytes);
  if (!text) return text.error();
  if (keys::secret_in(*text) == keys::Secret::Token)
    return Error{.what = "this key is in a hardware token, which has a PIN of its own",
                 .where = asked.file,
                 .fix = "change the PIN by the token's own program"};
  const Result<keys::OwnKey> old = keys::open_private_key(*text, asked.file, keys::ask_passphrase);
  if (!old) return old.error();
  const Result<std::string> passphrase = keys::new_passphrase(asked.file);
  if (!passphrase) return passphrase.error();
  const Result<std::string> locked = keys::locked(*old->key, *passphrase);
  if (!locked) return locked.error();
  std::string changed = *text;
  changed.replace(changed.find(old->text.substr(0, old->text.size() - 1)), old->text.size() - 1,
                  locked->substr(0, locked->size() - 1));
  if (const Result<void> written = program::write_whole_file(asked.file, changed, Readers::Group); !written)
    return written.error();
  return asked.file + ": a passphrase now protects the private key. Copies that were made before have none.\n";
}

}  // namespace telepalp::keys_tool
