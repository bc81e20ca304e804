#include "tools/keys/key_folder.h"

#include <fstream>
#include <sstream>

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
         keys::in_words(key.identity.expires) + "  " + file.filename().string() + "\n";
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

Result<KeyFolder> KeyFolder::create(const fs::path& folder, const std::string& name, keys::WallTime now,
                                    std::chrono::days valid) {
  if (fs::exists(folder / kAuthority))
    return Error{.what = "the file of a certificate authority exists already",
                 .where = (folder / kAuthority).string(),
                 .fix = "use this authority, or give another folder with --dir"};
  Result<keys::Authority> authority = keys::Authority::create(name, now, valid);
  if (!authority) return authority.error();
  KeyFolder made(folder, std::move(authority).value());
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
                 .fix = "run telepalp-keys authority --dir " + folder.string() +
                        ", or give the folder of an authority with --dir"};
  const Result<std::string> text = read_file(file, keys::kMaxKeyFileBytes);
  if (!text) return text.error();
  Result<keys::Authority> authority = keys::Authority::read(*text, file.string());
  if (!authority) return authority.error();
  return KeyFolder(folder, std::move(authority).value());
}

Result<void> KeyFolder::keep(const std::string& key_text, const fs::path& file, bool replace) const {
  if (!replace && fs::exists(file))
    return Error{.what = "the file exists already",
                 .where = file.string(),
                 .fix = "to replace this key: telepalp-keys renew " + file.string() + " --dir " + folder_.string() +
                        "; for another key, give another --name"};
  const Result<keys::KeyFile> key = keys::read_key(key_text, file.string());
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

Result<keys::Revocations> KeyFolder::revoked() const {
  if (!fs::exists(path(kRevoked))) return keys::Revocations{};
  const Result<std::string> text = read_file(path(kRevoked), kMaxListBytes);
  if (!text) return text.error();
  return keys::Revocations::read(*text, authority_.certificate(), path(kRevoked).string());
}

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
  all.emplace(serial, now);
  if (const Result<void> written = write_revoked(all, before->number() + 1, now); !written) return written.error();
  return all.size();
}

Result<std::string> KeyFolder::list() const {
  const Result<keys::Revocations> gone = revoked();
  if (!gone) return gone.error();
  std::string text;
  std::ifstream issued(path(kIssued));
  for (std::string line; std::getline(issued, line);) {
    const bool is_gone = gone->contains(line.substr(0, line.find(' ')));
    text += line + (is_gone ? "  REVOKED" : "") + "\n";
  }
  return text;
}

}  // namespace telepalp::keys_tool
