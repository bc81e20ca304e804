#include "proto/keys/known_list.h"

#include <fstream>
#include <iterator>
#include <utility>

namespace telepalp::keys {
namespace {

namespace fs = std::filesystem;

}  // namespace

KnownList::KnownList(const KeyFile& key)
    : authority_(key.authority), file_(key.path.empty() ? fs::path() : fs::path(key.path.string() + ".revoked")) {
  std::ifstream stream(file_, std::ios::binary);
  if (!stream) return;
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (Result<Revocations> read = Revocations::read(text, authority_, file_.string())) known_ = std::move(read).value();
}

Result<void> KnownList::take(std::string_view pem) {
  Result<Revocations> read = Revocations::read(pem, authority_, "");
  if (!read)
    return error_without_place("the server's list of revoked keys is damaged, or another authority signed it",
                               "ask the technician to copy revoked.crl to the server again");
  if (known_ && read->number() < known_->number())
    return error_without_place(
        "the server's list of revoked keys is older (number " + std::to_string(read->number()) +
            ") than one that was shown before (" + std::to_string(known_->number()) + ")",
        "ask the technician to copy the newest revoked.crl to the server; until then this may be a server "
        "whose key was stolen");
  const bool is_newer = !known_ || read->number() > known_->number();
  known_ = std::move(read).value();
  if (is_newer && !file_.empty()) replace_file(file_, pem);  // if this fails, the list is known until the program ends
  return {};
}

Result<void> KnownList::check(const ServerCertificate& server, bool shown) const {
  if (known_ && known_->contains(server.serial))
    return error_without_place(
        "the server's key is revoked: it was replaced or stolen",
        "ask the technician which server to connect to; the technician makes a new key for it: telepalp-keys "
        "server");
  if (shown || (!server.promises_list && !known_)) return {};
  return error_without_place(
      "the server shows no list of revoked keys",
      "ask the technician to install the same version of telepalp at the server and to copy revoked.crl "
      "there; until then this may be a server whose key was stolen");
}

}  // namespace telepalp::keys
