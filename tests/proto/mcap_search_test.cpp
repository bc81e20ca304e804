// Session files with damaged record heads: reading continues at the next chunk, names the offset, and stays bounded.

#include <gtest/gtest.h>
#include <unistd.h>

#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/reading/chunk_search.h"
#include "proto/wire/mcap/reading/stream_reader.h"
#include "tests/proto/mcap_samples.h"

namespace telepalp::wire {
namespace {

struct StreamOutcome {
  std::size_t messages = 0;
  std::vector<std::string> errors;
};

StreamOutcome read_to_end(Result<McapStreamReader> reader) {
  StreamOutcome outcome;
  if (!reader) return {0, {to_string(reader.error())}};
  for (;;) {
    const auto next = reader->next();
    if (next && !*next) return outcome;
    if (next) ++outcome.messages;
    if (!next) outcome.errors.push_back(to_string(next.error()));
  }
}

StreamOutcome read_bytes(std::string bytes) {
  return read_to_end(McapStreamReader::open(mcap::in_memory(std::move(bytes), "session.mcap")));
}

/// A session in chunks of about 2000 bytes.
struct ChunkedSample {
  std::string bytes;
  std::vector<mcap::ChunkIndex> chunks;
  std::size_t messages = 0;
};

ChunkedSample sample() {
  const auto file = samples::fresh_file("search_" + std::to_string(::getpid()) + ".mcap");
  EXPECT_TRUE(samples::write_file(file, samples::session(1, 1000), {.bytes = 2000}));
  auto reader = McapReader::open(file);
  ChunkedSample made{samples::bytes_of(file), reader->summary().chunks, reader->summary().statistics.message_count};
  std::filesystem::remove(file);
  return made;
}

TEST(McapSearch, FindsEachChunkFromAnyByteBeforeIt) {
  const ChunkedSample whole = sample();
  const auto source = mcap::in_memory(whole.bytes, "session.mcap");
  std::uint64_t from = 0;
  for (const mcap::ChunkIndex& chunk : whole.chunks)
    for (; from <= chunk.chunk_start_offset; ++from)
      ASSERT_EQ(mcap::find_chunk(*source, from), chunk.chunk_start_offset) << "from byte " << from;
  EXPECT_EQ(mcap::find_chunk(*source, from), std::nullopt);
}

TEST(McapSearch, ADamagedLengthOfAnyRecordLosesThatRecordAloneAndNamesTheOffset) {
  const ChunkedSample whole = sample();
  for (std::size_t number = 1; number + 1 < whole.chunks.size(); ++number) {
    std::string hurt = whole.bytes;
    hurt[whole.chunks[number].chunk_start_offset + 6] = '\x7f';  // of the eight bytes that hold the record's length
    const StreamOutcome outcome = read_bytes(hurt);
    ASSERT_EQ(outcome.errors.size(), 1u) << number;
    EXPECT_NE(outcome.errors[0].find("damaged bytes are skipped, and reading continues at byte " +
                                     std::to_string(whole.chunks[number + 1].chunk_start_offset) +
                                     "; the damage begins (at byte " +
                                     std::to_string(whole.chunks[number].chunk_start_offset) + ")"),
              std::string::npos)
        << outcome.errors[0];
    EXPECT_LT(outcome.messages, whole.messages);
    EXPECT_GT(outcome.messages, whole.messages * 3 / 4);
  }
}

TEST(McapSearch, EveryHundredthByteSetToZeroNeverLosesMoreThanItsNeighbourhood) {
  const ChunkedSample whole = sample();
  const std::size_t per_chunk = whole.messages / whole.chunks.size() + 8;
  for (std::size_t at = mcap::kMagic.size(); at < whole.bytes.size(); at += 100) {
    std::string hurt = whole.bytes;
    hurt[at] = '\0';
    const StreamOutcome outcome = read_bytes(hurt);
    ASSERT_GE(outcome.messages + 2 * per_chunk, whole.messages) << "byte " << at;
    for (const std::string& error : outcome.errors) ASSERT_NE(error.find("(at byte "), std::string::npos) << error;
  }
}

TEST(McapSearch, ADefinitionLostWithTheDamageIsLearntFromTheSummary) {
  const ChunkedSample whole = sample();
  std::string hurt = whole.bytes;
  const std::size_t first = whole.chunks.front().chunk_start_offset;
  std::fill(hurt.begin() + mcap::kMagic.size(), hurt.begin() + static_cast<std::ptrdiff_t>(first), '\0');
  const StreamOutcome outcome = read_bytes(hurt);
  EXPECT_EQ(outcome.messages, whole.messages);
  EXPECT_EQ(outcome.errors.size(), 1u);
}

TEST(McapSearch, AFalseEndOfTheDataDoesNotHideTheChunksBehindIt) {
  const ChunkedSample whole = sample();
  for (const char end : {'\x02', '\x0f'}) {
    std::string hurt = whole.bytes;
    hurt[whole.chunks[3].chunk_start_offset] = end;
    const StreamOutcome outcome = read_bytes(hurt);
    EXPECT_EQ(outcome.errors.size(), 1u);
    EXPECT_GT(outcome.messages, whole.messages * 3 / 4);
  }
}

/// Counts what is read of the bytes in memory.
class CountingSource : public mcap::ByteSource {
 public:
  CountingSource(std::string bytes, std::uint64_t& read)
      : inner_(mcap::in_memory(std::move(bytes), "session.mcap")), read_(read) {}
  [[nodiscard]] const std::string& name() const noexcept override { return inner_->name(); }
  [[nodiscard]] std::uint64_t size() const noexcept override { return inner_->size(); }
  [[nodiscard]] bool read(std::uint64_t offset, std::size_t length, std::string& into) override {
    read_ += length;
    return inner_->read(offset, length, into);
  }

 private:
  std::unique_ptr<mcap::ByteSource> inner_;
  std::uint64_t& read_;
};

TEST(McapSearch, ManyDamagedPlacesDoNotMultiplyWhatIsRead) {
  constexpr std::size_t kPlaces = 5000;
  std::string bytes{mcap::kMagic};
  mcap::append(bytes, mcap::Header{"", "a liar"});
  mcap::append(bytes, mcap::Schema{1, "telepalp.msg.Clock", "protobuf", ""});
  mcap::append(bytes, mcap::Channel{1, 1, "/clock", "protobuf", {}});
  std::string records;
  mcap::append(records, mcap::MessageRecord{1, 1, 5, 5, ""});
  for (std::size_t place = 0; place < kPlaces; ++place) {
    mcap::append(bytes, mcap::ChunkRecord{5, 5, records.size(), 0, "", records});
    bytes += std::string(16, '\0');  // no valid record
  }
  std::uint64_t read = 0;
  const std::uint64_t size = bytes.size();
  const StreamOutcome outcome =
      read_to_end(McapStreamReader::open(std::make_unique<CountingSource>(std::move(bytes), read)));
  EXPECT_EQ(outcome.messages, kPlaces);
  EXPECT_GE(outcome.errors.size(), kPlaces - 1);
  EXPECT_LT(read, 64 * size);
}

TEST(McapSearch, AnotherVersionOfMcapIsNamed) {
  std::string other = sample().bytes;
  other[5] = '1';
  const StreamOutcome outcome = read_bytes(other);
  ASSERT_EQ(outcome.errors.size(), 1u);
  EXPECT_NE(outcome.errors[0].find("is of MCAP version 1; only version 0 can be read"), std::string::npos)
      << outcome.errors[0];
}

TEST(McapSearch, ASparseFileOfAHundredGigabytesIsReadToItsLastChunkInBoundedTime) {
  const ChunkedSample whole = sample();
  const auto file = samples::fresh_file("sparse_" + std::to_string(::getpid()) + ".mcap");
  constexpr std::uint64_t kHuge = std::uint64_t{100} << 30;
  const std::uint64_t half = whole.chunks[whole.chunks.size() / 2].chunk_start_offset;
  {
    std::ofstream out(file, std::ios::binary);
    out << whole.bytes.substr(0, half);
    out.seekp(static_cast<std::streamoff>(kHuge));
    out << whole.bytes.substr(half);
  }
  if (std::filesystem::file_size(file) < kHuge) GTEST_SKIP() << "this file system has no sparse files";
  const auto started = std::chrono::steady_clock::now();
  const StreamOutcome outcome = read_to_end(McapStreamReader::open(file));
  EXPECT_LT(std::chrono::steady_clock::now() - started, std::chrono::seconds(20));
  EXPECT_EQ(outcome.messages, whole.messages);
  ASSERT_EQ(outcome.errors.size(), 1u);
  EXPECT_NE(outcome.errors[0].find("(at byte " + std::to_string(half) + ")"), std::string::npos) << outcome.errors[0];
  EXPECT_FALSE(McapReader::open(file)) << "its summary's offsets lie";
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace telepalp::wire
