// What a stranger may send to the office or put beside a key: a certificate signing request, the address of a key in a
// hardware token, and the public part of a key file. The first byte chooses the kind.
#include <cstdint>
#include <string>
#include <string_view>

#include "proto/keys/key_file.h"
#include "proto/keys/request/key_request.h"
#include "proto/keys/secret/pkcs11.h"
#include "proto/keys/x509/names.h"
#include "proto/words/demand.h"

namespace {

using namespace telepalp;

/// What is read can be written into a file name and a certificate, and is signed by its own key on P-256.
void request(std::string_view bytes) {
  const Result<keys::KeyRequest> read = keys::read_request(bytes, "fuzzed.request");
  if (!read) return;
  demand(keys::check_name(read->name).ok(), "a name of a request is one that a key may have");
  demand(read->key != nullptr && keys::fingerprint(*read->key).size() == 7 + 64, "its key has a fingerprint");
}

void address(std::string_view bytes) {
  const Result<keys::Pkcs11Address> read = keys::read_pkcs11(bytes);
  if (!read) return;
  demand(read->key.starts_with("pkcs11:") && !read->object.empty(), "an address names an object");
  demand(read->key.find("pin-value") == std::string::npos, "no PIN is in an address");
}

void file(std::string_view bytes) {
  const Result<keys::KeyFile> read = keys::read_public_part(bytes, "fuzzed.key");
  demand(!read || !read->private_key, "the public part has no private key");
  (void)keys::secret_in(bytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  if (data[0] == '0') request(bytes);
  if (data[0] == '1') address(bytes);
  if (data[0] == '2') file(bytes);
  return 0;
}
