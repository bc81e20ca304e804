#include "tools/keys/key_folder.h"

#include <fstream>
#include <set>
#include <sstream>

#include "proto/keys/request/key_request.h"
#include "support/program/files/whole_file.h"

namespace telepalp::keys_tool {
namespace {

namespace fs = std::filesystem;
using program::Readers;

constexpr std::size_t kMaxListBytes = std::size_t{16} << 20;
constexpr const char* kAuthority = "authority.key";
constexpr const char* kPublic = "authority.crt";
constexpr const char* kIssued = "issued.txt";
constexpr const char* kRevoked = "revoked.crl";

std::string issued_line(const keys::KeyFile& key, const fs::path& file) {
  const bool server = key.kind == keys::KeyFile::Kind::Server;
  const std::string kind = server ? "server" : key.kind == keys::KeyFile::Kind::Token ? "token" : "key";
  return key.identity.serial + "  " + kind + "  " + (server ? key.identity.name : describe(key.identity)) + "  until " +
         keys::in_words(key.identity.expires) + "  " + file.filename().string() +
         (key.certificate.empty() ? "" : "  " + keys::fingerprint(*keys::public_key_of(key))) + "\n";
}

}  // namespace

Result<std::string> read_file(const fs::path& file, std::size_t most) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(most + 1, '\0');
  if (stream) stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (stream.is_open() && text.size() <= most) return text;
  if (!stream.is_open())
    return Error{
        .what = "the file cannot be read", .where = file.string(), .fix = "check its name, and that you may read it"};
  return Error{
      .what = "the file is larger than " + std::to_string(most) + " B; files that telepalp-keys writes are smaller",
      .where = file.string(),
      .fix = "give a file that telepalp-keys wrote"};
}

Result<void> KeyFolder::check_has_none(const fs::path& folder) {
  if (!fs::exists(folder / kAuthority)) return {};
  return Error{.what = "the file of a certificate authority exists already",
               .where = (folder / kAuthority).string(),
               .fix = "use this authority, or give another folder with --dir"};
}

Result<KeyFolder> KeyFolder::create(const fs::path& folder, keys::Authority authority, keys::WallTime now) {
  if (const Result<void> none = check_has_none(folder); !none) return none.error();
  KeyFolder made(folder, std::move(authority));
  Result<void> done = program::make_folder(folder, Readers::Group);
  if (done) done = program::write_whole_file(folder / kPublic, made.authority_.certificate(), Readers::Anyone);
  if (done) done = program::write_whole_file(folder / kAuthority, made.authority_.file_text(), Readers::Group);
  if (done) done = made.write_revoked({}, 1, now);
  if (!done) return done.error();
  return made;
}

Result<KeyFolder> KeyFolder::open(const fs::path& folder) {
  const fs::path file = folder / kAuthority;
  if (!fs::exists(file))
    return Error{.what = "the file of the certificate authority, which signs all keys, is missing",
                 .where = file.string(),
                 .fix =
                     "run this command on the computer that makes keys, in the folder of its authority (--dir); for a "
                     "new authority: telepalp-keys authority --dir " +
                     folder.string() + " --host HOST"};
  const Result<std::string> text = read_file(file, keys::kMaxKeyFileBytes);
  if (!text) return text.error();
  Result<keys::Authority> authority = keys::Authority::read(*text, file.string(), keys::ask_passphrase);
  if (!authority) return authority.error();
  return KeyFolder(folder, std::move(authority).value());
}

Result<void> KeyFolder::keep(const std::string& key_text, const fs::path& file, bool replace) const {
  if (!replace && fs::exists(file))
    return Error{.what = "the file exists already",
                 .where = file.string(),
                 .fix = "to replace this key: telepalp-keys renew " + file.string() + " --dir " + folder_.string() +
                        "; for another key, give another --name, or move this file away"};
  const Result<keys::KeyFile> key = keys::read_public_part(key_text, file.string());
  if (!key) return key.error();
  // Noted first: a key that exists can then always be revoked.
  std::ofstream issued(path(kIssued), std::ios::app);
  issued << issued_line(*key, file) << std::flush;
  if (!issued)
    return Error{.what = "cannot be written",
                 .where = path(kIssued).string(),
                 .fix = "make room on the disk, or check that you may write to this folder"};
  return program::write_whole_file(file, key_text, Readers::Group);
}

namespace {

Result<keys::Revocations> revoked_in(const fs::path& folder, std::string_view authority) {
  if (!fs::exists(folder / kRevoked)) return keys::Revocations{};
  const Result<std::string> text = read_file(folder / kRevoked, kMaxListBytes);
  if (!text) return text.error();
  return keys::Revocations::read(*text, authority, (folder / kRevoked).string());
}

/// The serial number with which a line of issued.txt begins.
std::string serial_of(const std::string& line) { return line.substr(0, line.find(' ')); }

/// The fingerprint with which a line of issued.txt ends; empty: the line is of a token, or of an older version.
std::string fingerprint_of(const std::string& line) {
  const std::size_t at = line.rfind("  SHA256:");
  return at == std::string::npos ? "" : line.substr(at + 2);
}

/// `serial`, and the serials of the other certificates of its key pair: a renewal of a certificate keeps the key pair,
/// and whoever stole the private key could use the older certificate.
std::set<std::string> serials_of_key(const fs::path& file, const std::string& serial) {
  std::map<std::string, std::set<std::string>> by_key;
  std::string key;
  std::ifstream issued(file);
  for (std::string line; std::getline(issued, line);) {
    by_key[fingerprint_of(line)].insert(serial_of(line));
    if (serial_of(line) == serial) key = fingerprint_of(line);
  }
  return key.empty() ? std::set{serial} : by_key[key];
}

}  // namespace

Result<keys::Revocations> KeyFolder::revoked() const { return revoked_in(folder_, authority_.certificate()); }

Result<void> KeyFolder::write_revoked(const std::map<std::string, keys::WallTime>& all, std::uint64_t number,
                                      keys::WallTime now) const {
  const Result<std::string> list = authority_.revocation_list(all, now, number);
  if (!list) return list.error();
  return program::write_whole_file(path(kRevoked), *list, Readers::Group);
}

Result<std::size_t> KeyFolder::revoke(const std::string& serial, keys::WallTime now) const {
  const Result<keys::Revocations> before = revoked();
  if (!before) return before.error();
  std::map<std::string, keys::WallTime> all = before->all();
  for (const std::string& one : serials_of_key(path(kIssued), serial)) all.emplace(one, now);
  if (const Result<void> written = write_revoked(all, before->number() + 1, now); !written) return written.error();
  return all.size();
}

Result<std::string> KeyFolder::list(const fs::path& folder) {
  const Result<std::string> authority = read_file(folder / kPublic, keys::kMaxKeyFileBytes);
  if (!authority) return authority.error();
  const Result<keys::Revocations> gone = revoked_in(folder, *authority);
  if (!gone) return gone.error();
  std::string text;
  std::ifstream issued(folder / kIssued);
  for (std::string line; std::getline(issued, line);)
    text += line + (gone->contains(serial_of(line)) ? "  REVOKED" : "") + "\n";
  return text;
}

Result<void> KeyFolder::check_not_revoked(const std::string& fingerprint, const std::string& file) const {
  const Result<keys::Revocations> gone = revoked();
  if (!gone) return gone.error();
  std::ifstream issued(path(kIssued));
  for (std::string line; std::getline(issued, line);)
    if (fingerprint_of(line) == fingerprint && gone->contains(serial_of(line)))
      return Error{
          .what = "a certificate of this private key was revoked, so the key may be in wrong hands",
          .where = file,
          .fix = "its holder makes a new key: telepalp-keys request --name NAME, with the old file moved away"};
  return {};
}

Result<void> KeyFolder::replace_authority(const keys::Authority& renewed) const {
  if (const Result<void> done = program::write_whole_file(path(kAuthority), renewed.file_text(), Readers::Group); !done)
    return done;
  return program::write_whole_file(path(kPublic), renewed.certificate(), Readers::Anyone);
}

}  // namespace telepalp::keys_tool
