// Truncated, damaged and malicious session files: readers must return the intact messages, name the damage, and
// allocate little.

#include <gtest/gtest.h>
#include <lz4frame.h>
#include <unistd.h>

#include <algorithm>

#include "proto/wire/mcap/format/compression.h"
#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/reading/stream_reader.h"
#include "tests/proto/mcap_samples.h"

namespace telepalp::wire {
namespace {

struct Outcome {
  std::size_t messages = 0;
  std::vector<std::string> errors;
  bool opened = false;
};

/// Reads to the end, over all errors. There are at most as many errors as bytes.
template <class Reader>
Outcome read_all(Result<Reader> reader) {
  Outcome outcome;
  if (!reader) {
    outcome.errors.push_back(to_string(reader.error()));
    return outcome;
  }
  outcome.opened = true;
  for (;;) {
    const auto next = [&] {
      if constexpr (std::is_same_v<Reader, McapReader>)
        return reader->next_stored();
      else
        return reader->next();
    }();
    if (!next)
      outcome.errors.push_back(to_string(next.error()));
    else if (*next)
      ++outcome.messages;
    else
      return outcome;
  }
}

Outcome stream(std::string bytes) {
  return read_all(McapStreamReader::open(mcap::in_memory(std::move(bytes), "session.mcap")));
}
Outcome indexed(std::string bytes) {
  return read_all(McapReader::open(mcap::in_memory(std::move(bytes), "session.mcap")));
}

/// A small file in memory, with the end of each chunk and the number of messages before it.
struct Sample {
  std::string bytes;
  std::vector<std::pair<std::uint64_t, std::size_t>> chunk_ends;
  mcap::Summary summary;
};

Sample make_sample() {
  const auto file = samples::fresh_file("damage_" + std::to_string(::getpid()) + ".mcap");
  EXPECT_TRUE(samples::write_file(file, samples::session(1, 1000), {.bytes = 2000}));
  Sample sample{samples::bytes_of(file), {}, {}};
  std::filesystem::remove(file);
  auto source = mcap::in_memory(sample.bytes, "session.mcap");
  auto summary = mcap::read_summary(*source);
  EXPECT_TRUE(summary);
  sample.summary = std::move(summary).value();
  std::size_t messages = 0;
  for (const mcap::ChunkIndex& index : sample.summary.chunks) {
    std::string content = sample.bytes.substr(index.chunk_start_offset + mcap::kRecordHeadBytes,
                                              index.chunk_length - mcap::kRecordHeadBytes);
    const auto records = mcap::unpack(*mcap::parse<mcap::ChunkRecord>(content));
    EXPECT_TRUE(records);
    mcap::ChunkWalk walk(*records);
    for (auto entry = walk.next(); entry && *entry; entry = walk.next()) ++messages;
    sample.chunk_ends.emplace_back(index.chunk_start_offset + index.chunk_length, messages);
  }
  return sample;
}

TEST(McapDamage, AFileCutOffAnywhereGivesBackEveryWholeChunkAndSaysWhereItEnds) {
  const Sample sample = make_sample();
  ASSERT_GT(sample.chunk_ends.size(), 5u);
  for (std::size_t length = 0; length < sample.bytes.size(); ++length) {
    const std::string cut = sample.bytes.substr(0, length);
    std::size_t expected = 0;
    for (const auto& [end, messages] : sample.chunk_ends)
      if (end <= length) expected = messages;
    const Outcome outcome = stream(cut);
    ASSERT_EQ(outcome.messages, expected) << "cut to " << length;
    const Outcome through_index = indexed(cut);
    ASSERT_FALSE(through_index.opened) << "cut to " << length;
    if (length >= mcap::kMagic.size()) {
      ASSERT_NE(through_index.errors.front().find("fix: telepalp-record repair session.mcap"), std::string::npos);
    }
  }
}

TEST(McapDamage, ACutInAChunkIsAnErrorWithWhatWhereAndFix) {
  const Sample sample = make_sample();
  const Outcome outcome = stream(sample.bytes.substr(0, sample.summary.chunks[3].chunk_start_offset + 100));
  ASSERT_EQ(outcome.errors.size(), 1u);
  EXPECT_EQ(outcome.errors.front(), "session.mcap: chunk 3: truncated (at byte " +
                                        std::to_string(sample.summary.chunks[3].chunk_start_offset) +
                                        "). fix: telepalp-record repair session.mcap");
}

TEST(McapDamage, AnyFlippedByteInAChunkLosesThatChunkAloneAndIsNamed) {
  const Sample sample = make_sample();
  const mcap::ChunkIndex& chunk = sample.summary.chunks[2];
  const std::size_t in_chunk = sample.chunk_ends[2].second - sample.chunk_ends[1].second;
  const std::size_t all = sample.chunk_ends.back().second;
  // The compressed records. The chunk's header precedes them; no CRC covers its times.
  const std::uint64_t start = chunk.chunk_start_offset + chunk.chunk_length - chunk.compressed_size;
  for (std::uint64_t at = start; at < start + chunk.compressed_size; ++at) {
    std::string flipped = sample.bytes;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x10);
    for (const Outcome& outcome : {stream(flipped), indexed(flipped)}) {
      if (outcome.errors.empty()) {  // zstd does not use this bit, so the data is unchanged
        ASSERT_EQ(outcome.messages, all) << at;
        continue;
      }
      ASSERT_EQ(outcome.messages, all - in_chunk) << at;
      ASSERT_EQ(outcome.errors.size(), 1u);
      ASSERT_TRUE(outcome.errors.front().starts_with("session.mcap: chunk 2: ")) << outcome.errors.front();
    }
  }
}

TEST(McapDamage, AFlippedByteInAnUncompressedChunkFailsItsCrc) {
  std::string records;
  mcap::append(records, mcap::MessageRecord{1, 1, 5, 5, "payload"});
  mcap::ChunkRecord chunk{5, 5, records.size(), mcap::crc32(records), "", records};
  EXPECT_TRUE(mcap::unpack(chunk));
  std::string flipped = records;
  flipped.back() = 'D';
  chunk.records = flipped;
  const auto unpacked = mcap::unpack(chunk);
  ASSERT_FALSE(unpacked);
  EXPECT_NE(unpacked.error().what.find("CRC"), std::string::npos);
}

TEST(McapDamage, AnyFlippedByteInTheSummaryIsFoundByItsCrc) {
  const Sample sample = make_sample();
  const std::size_t footer = sample.bytes.size() - 37;
  const auto summary_start =
      mcap::parse<mcap::Footer>(std::string_view(sample.bytes).substr(footer + 9, 20))->summary_start;
  for (std::size_t at = summary_start; at < footer; ++at) {
    std::string flipped = sample.bytes;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x01);
    const Outcome outcome = indexed(flipped);
    ASSERT_FALSE(outcome.opened) << at;
    ASSERT_NE(outcome.errors.front().find("CRC of its summary"), std::string::npos) << outcome.errors.front();
  }
}

TEST(McapDamage, RandomBytesOverAFileNeverCrashAReader) {
  const Sample sample = make_sample();
  std::mt19937 random(20260);
  for (int round = 0; round < 400; ++round) {
    std::string hurt = sample.bytes;
    for (int flips = 0; flips < 1 + round % 16; ++flips)
      hurt[random() % hurt.size()] = static_cast<char>(random() & 0xff);
    EXPECT_LE(stream(hurt).messages, sample.chunk_ends.back().second + 16) << "seed 20260, round " << round;
    (void)indexed(hurt);
  }
}

/// A complete file with given records and a summary from `fill`, without the summary's CRC, like a malicious file.
template <class Fill>
std::string file_with(const std::string& data, Fill fill) {
  std::string bytes{mcap::kMagic};
  mcap::append(bytes, mcap::Header{"", "a liar"});
  const std::uint64_t data_start = bytes.size();
  bytes += data;
  mcap::append(bytes, mcap::DataEnd{0});
  const std::uint64_t summary = bytes.size();
  fill(bytes, data_start);
  mcap::append(bytes, mcap::Footer{summary, 0, 0});
  return bytes + std::string(mcap::kMagic);
}

std::string schema_and_channel() {
  std::string bytes;
  mcap::append(bytes, mcap::Schema{1, "telepalp.msg.Clock", "protobuf", ""});
  mcap::append(bytes, mcap::Channel{1, 1, "/clock", "protobuf", {}});
  return bytes;
}

std::string chunk_of(const std::string& records, std::uint64_t declared, std::string_view compression = "") {
  std::string bytes;
  mcap::append(bytes, mcap::ChunkRecord{5, 5, declared, 0, compression, records});
  return bytes;
}

std::string one_message() {
  std::string records;
  mcap::append(records, mcap::MessageRecord{1, 1, 5, 5, ""});
  return records;
}

mcap::ChunkIndex index_of(std::uint64_t offset, std::uint64_t length) {
  return {.message_start_time = 5,
          .message_end_time = 5,
          .chunk_start_offset = offset,
          .chunk_length = length,
          .message_index_offsets = {},
          .message_index_length = 0,
          .compression = "",
          .compressed_size = 0,
          .uncompressed_size = 0};
}

TEST(BadInput32, AChunkIndexThatPointsOutsideOfTheFileIsRefused) {
  for (const std::uint64_t offset : {std::uint64_t{0}, std::uint64_t{1} << 20, UINT64_MAX - 4, UINT64_MAX}) {
    for (const std::uint64_t length : {std::uint64_t{9}, UINT64_MAX}) {
      const Outcome outcome = indexed(file_with(schema_and_channel(), [&](std::string& out, std::uint64_t) {
        out += schema_and_channel();
        mcap::append(out, index_of(offset, length));
      }));
      EXPECT_FALSE(outcome.opened) << offset << " " << length;
    }
  }
}

TEST(BadInput32, AChunkIndexThatDoesNotPointAtAChunkIsAnErrorAndSkipped) {
  const std::string chunk = chunk_of(one_message(), one_message().size());
  const Outcome outcome = indexed(file_with(schema_and_channel() + chunk, [&](std::string& out, std::uint64_t start) {
    out += schema_and_channel();
    mcap::append(out, index_of(start, 20));
    mcap::append(out, index_of(start + schema_and_channel().size(), chunk.size()));
  }));
  EXPECT_EQ(outcome.messages, 1u);
  EXPECT_EQ(outcome.errors.size(), 1u);
}

TEST(McapDamage, AZstdBombIsRefusedByItsDeclaredSizeOrStoppedAtIt) {
  const std::string bomb = mcap::zstd_compress(std::string(200u << 20, '\0'));
  ASSERT_LT(bomb.size(), 50'000u);
  const auto declared_truly = mcap::unpack({5, 5, 200u << 20, 0, "zstd", bomb});
  ASSERT_FALSE(declared_truly);
  EXPECT_NE(declared_truly.error().what.find("limit"), std::string::npos);
  EXPECT_FALSE(mcap::unpack({5, 5, 1000, 0, "zstd", bomb}));
}

TEST(McapDamage, AnLz4BombIsStoppedAtItsDeclaredSizeAndADamagedFrameIsNamed) {
  const std::string plain(20u << 20, '\0');
  std::string bomb(LZ4F_compressFrameBound(plain.size(), nullptr), '\0');
  bomb.resize(LZ4F_compressFrame(bomb.data(), bomb.size(), plain.data(), plain.size(), nullptr));
  ASSERT_LT(bomb.size(), 200'000u);
  EXPECT_TRUE(mcap::unpack({5, 5, plain.size(), 0, "lz4", bomb}));
  EXPECT_FALSE(mcap::unpack({5, 5, 200u << 20, 0, "lz4", bomb}));
  for (const std::uint64_t declared : {std::uint64_t{0}, std::uint64_t{1000}, plain.size() - 1, plain.size() + 1})
    EXPECT_FALSE(mcap::unpack({5, 5, declared, 0, "lz4", bomb})) << declared;
  for (std::size_t length = 0; length < bomb.size(); length += 97)
    EXPECT_FALSE(mcap::unpack({5, 5, plain.size(), 0, "lz4", std::string_view(bomb).substr(0, length)})) << length;
  const auto damaged = mcap::unpack({5, 5, plain.size(), 0, "lz4", "no frame"});
  ASSERT_FALSE(damaged);
  EXPECT_NE(damaged.error().what.find("its lz4 data is damaged"), std::string::npos);
}

TEST(McapDamage, AChunkInAChunkIsRefused) {
  const std::string inner = chunk_of(one_message(), one_message().size());
  const Outcome outcome = stream(file_with(schema_and_channel() + chunk_of(inner, inner.size()), [](auto&, auto) {}));
  EXPECT_EQ(outcome.messages, 0u);
  ASSERT_EQ(outcome.errors.size(), 1u);
  EXPECT_NE(outcome.errors.front().find("is not allowed in a chunk"), std::string::npos);
}

TEST(McapDamage, RecordsThatTheSpecificationMayAddLaterAreSkipped) {
  std::string later(1, '\x7f');
  later += std::string("\x03\0\0\0\0\0\0\0", 8) + "new";
  const std::string records = later + one_message() + later;
  const std::string bytes = file_with(later + schema_and_channel() + later + chunk_of(records, records.size()) + later,
                                      [&](std::string& out, std::uint64_t) { out += later; });
  const Outcome outcome = stream(bytes);
  EXPECT_EQ(outcome.messages, 1u);
  EXPECT_TRUE(outcome.errors.empty());
}

TEST(McapDamage, ARecordOfFourExabytesIsATruncationAndAllocatesNothing) {
  std::string bytes{mcap::kMagic};
  mcap::append(bytes, mcap::Header{"", ""});
  bytes += '\x06';
  bytes += std::string(8, '\x7f');
  const Outcome outcome = stream(bytes);
  ASSERT_EQ(outcome.errors.size(), 1u);
  EXPECT_NE(outcome.errors.front().find("chunk 0: truncated"), std::string::npos);
}

TEST(McapDamage, AMessageOnAnUnknownChannelIsAnErrorAndSkipped) {
  std::string records = one_message();
  mcap::append(records, mcap::MessageRecord{9, 1, 5, 5, "lost"});
  records += one_message();
  const Outcome outcome =
      stream(file_with(schema_and_channel() + chunk_of(records, records.size()), [](auto&, auto) {}));
  EXPECT_EQ(outcome.messages, 2u);
  EXPECT_EQ(outcome.errors.size(), 1u);
}

TEST(McapDamage, ASchemaWithIdZeroIsRefused) {
  std::string data;
  mcap::append(data, mcap::Schema{0, "x", "protobuf", ""});
  EXPECT_EQ(stream(file_with(data, [](auto&, auto) {})).errors.size(), 1u);
}

TEST(McapDamage, WhatIsNoMcapFileIsCalledSo) {
  const auto errors = stream("PK\x03\x04 something else entirely").errors;
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors.front().find("is not an MCAP file"), std::string::npos);
  EXPECT_NE(stream("").errors.front().find("is empty"), std::string::npos);
  const auto folder = McapReader::open(std::filesystem::path("/tmp"));
  ASSERT_FALSE(folder);
  EXPECT_NE(folder.error().what.find("not a file"), std::string::npos);
}

}  // namespace
}  // namespace telepalp::wire
