#include "proto/keys/digest/file_digest.h"

#include <array>
#include <fstream>
#include <vector>

#include "proto/keys/x509/openssl.h"

namespace telepalp::keys {

Result<std::string> sha256_hex_of_file(const std::filesystem::path& file) {
  constexpr std::size_t kBlock = std::size_t{1} << 20U;
  const DigestPtr digest(EVP_MD_CTX_new());
  bool good = digest && EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr) == 1;
  std::ifstream in(file, std::ios::binary);
  std::vector<char> block(kBlock);
  while (good && in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    good = EVP_DigestUpdate(digest.get(), block.data(), static_cast<std::size_t>(in.gcount())) == 1;
  }
  std::array<unsigned char, 32> value{};
  unsigned int size = 0;
  if (!in.eof())
    return Error{.what = "cannot be read", .where = file.string(), .fix = "check the file and its permissions"};
  if (!good || EVP_DigestFinal_ex(digest.get(), value.data(), &size) != 1 || size != value.size())
    return openssl_error("SHA-256 of " + file.string());
  return in_hexadecimal(value);
}

}  // namespace telepalp::keys
