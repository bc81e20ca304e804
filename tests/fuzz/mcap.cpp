#include <cstdint>
#include <string>

#include "proto/wire/mcap/format/records.h"
#include "proto/wire/mcap/reading/stream_reader.h"
#include "proto/wire/mcap/reading/summary.h"
#include "proto/words/demand.h"

namespace {

using namespace telepalp::wire;

/// Reads all of `bytes` sequentially, over all errors. Every message has a channel.
void read_stream(const std::string& bytes) {
  auto reader = McapStreamReader::open(mcap::in_memory(bytes, "fuzzed.mcap"));
  if (!reader) return;
  for (;;) {
    const auto next = reader->next();
    if (!next) continue;
    if (!*next) return;
    telepalp::demand((*next)->channel != nullptr, "a message stands on a channel");
  }
}

/// An accepted summary has only offsets within the file.
void read_summary_of(const std::string& bytes) {
  auto source = mcap::in_memory(bytes, "fuzzed.mcap");
  const auto summary = mcap::read_summary(*source);
  if (!summary) return;
  for (const mcap::ChunkIndex& chunk : summary->chunks)
    telepalp::demand(
        chunk.chunk_start_offset < bytes.size() && chunk.chunk_length <= bytes.size() - chunk.chunk_start_offset,
        "a chunk index points into the file");
}

/// An accepted chunk index is encoded and parsed back unchanged.
void round_trip(const std::string& bytes) {
  const auto index = mcap::parse<mcap::ChunkIndex>(bytes);
  if (!index) return;
  std::string again;
  mcap::append(again, *index);
  std::string twice;
  mcap::append(twice, *mcap::parse<mcap::ChunkIndex>(std::string_view(again).substr(mcap::kRecordHeadBytes)));
  telepalp::demand(again == twice, "writing and reading again changes nothing");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  read_stream(bytes);
  read_summary_of(bytes);
  round_trip(bytes);
  return 0;
}
