#include "server/access/revoked_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

namespace telepalp::access {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxListBytes = std::uintmax_t{384} << 10;  // some 7000 keys; a client takes up to 1 MiB
constexpr const char* kCopyList =
    "copy the newest revoked.crl from the folder in which telepalp-keys keeps the authority into the folder of the "
    "server's key";

}  // namespace

RevokedFile::RevokedFile(fs::path file, std::string authority)
    : file_(std::move(file)), authority_(std::move(authority)) {}

Result<void> RevokedFile::read(std::uint64_t known_number) {
  std::error_code failed;
  const auto changed = fs::last_write_time(file_, failed);
  const std::uintmax_t size = failed ? 0 : fs::file_size(file_, failed);
  std::ifstream stream(file_, std::ios::binary);
  const auto refused = [this](std::string what) {
    return Error{.what = std::move(what), .where = file_.string(), .fix = kCopyList};
  };
  if (failed || !stream) return refused("the list of revoked keys is missing, or cannot be read");
  if (size > kMaxListBytes) return refused("the list of revoked keys is larger than 384 KiB");
  read_ = changed;
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  Result<keys::Revocations> read = keys::Revocations::read(text, authority_, file_.string());
  if (!read) return read.error();
  const std::uint64_t known = std::max<std::uint64_t>(list_.number(), known_number);
  if (read->number() < known)
    return refused("this list of revoked keys is older (number " + std::to_string(read->number()) +
                   ") than one that this server has read before (number " + std::to_string(known) + ")");
  list_ = std::move(read).value();
  text_ = std::move(text);
  return {};
}

bool RevokedFile::has_changed() const {
  std::error_code failed;
  const auto changed = fs::last_write_time(file_, failed);
  return failed || changed != read_;
}

}  // namespace telepalp::access
