#include <utility>

#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/reading/stream_reader.h"

// Apart from the reader, because the fuzzer of the reader needs neither places nor keys.

namespace telepalp::wire {

Result<McapStreamReader> McapStreamReader::open(const std::filesystem::path& file) {
  Result<std::unique_ptr<mcap::ByteSource>> source = mcap::open_session(file);
  if (!source) return source.error();
  return open(std::move(source).value());
}

}  // namespace telepalp::wire
