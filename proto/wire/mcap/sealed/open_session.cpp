#include <utility>

#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/format/place.h"
#include "proto/wire/mcap/sealed/sealed_source.h"

namespace telepalp::wire::mcap {

Result<std::unique_ptr<ByteSource>> open_session(const std::filesystem::path& file) {
  const Place* const place = place_of(file);
  Result<std::unique_ptr<ByteSource>> source = place != nullptr ? place->open(file.string()) : open_file(file);
  if (!source) return source;
  return decrypted(*std::move(source));
}

}  // namespace telepalp::wire::mcap
