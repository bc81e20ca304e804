#include "haptic_station/core/journal/journal_file.h"

#include <google/protobuf/io/coded_stream.h>

#include <array>
#include <istream>
#include <ostream>
#include <span>

#include "codec/bytes/crc32c.h"

namespace telepalp::core {
namespace {

using google::protobuf::io::CodedInputStream;
using google::protobuf::io::CodedOutputStream;

constexpr std::string_view kMagic = "telepalp-journal ";
constexpr std::string_view kVersion = "1\n";
constexpr std::size_t kFrameBytes = 8;             // length and CRC
constexpr std::uint32_t kMostBytes = 512U << 20U;  // a longer block can only be damage

std::uint32_t crc_of(const std::string& bytes) { return codec::crc32c(std::as_bytes(std::span(bytes))); }

Error no_journal(const std::string& name, const std::string& what) {
  return {.what = what, .where = name, .fix = "give a file that telepalp-station --journal FILE wrote"};
}

}  // namespace

JournalWriter::JournalWriter(std::ostream& out, const msg::JournalHeader& header) : out_(out) {
  out_ << kMagic << kVersion;
  msg::JournalBlock block;
  *block.mutable_header() = header;
  add(block);
}

void JournalWriter::add(const msg::JournalBlock& block) {
  const std::string bytes = block.SerializeAsString();
  std::array<std::uint8_t, kFrameBytes> frame{};
  CodedOutputStream::WriteLittleEndian32ToArray(static_cast<std::uint32_t>(bytes.size()), frame.data());
  CodedOutputStream::WriteLittleEndian32ToArray(crc_of(bytes), frame.data() + 4);
  out_.write(reinterpret_cast<const char*>(frame.data()), kFrameBytes);
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

Result<JournalReader> JournalReader::open(std::istream& in, const std::string& name) {
  std::string magic(kMagic.size(), '\0');
  std::string version(kVersion.size(), '\0');
  in.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  in.read(version.data(), static_cast<std::streamsize>(version.size()));
  if (!in || magic != kMagic) return no_journal(name, "is not a station's journal");
  if (version != kVersion) return no_journal(name, "is a journal of another version of telepalp");
  JournalReader reader(in);
  reader.whole_bytes_ = magic.size() + version.size();
  const std::optional<msg::JournalBlock> first = reader.next();
  if (!first || !first->has_header()) return no_journal(name, "holds no whole header");
  reader.header_ = first->header();
  return reader;
}

std::optional<msg::JournalBlock> JournalReader::next() {
  std::array<std::uint8_t, kFrameBytes> frame{};
  if (!in_->read(reinterpret_cast<char*>(frame.data()), kFrameBytes)) return std::nullopt;
  std::uint32_t size = 0;
  std::uint32_t crc = 0;
  CodedInputStream::ReadLittleEndian32FromArray(frame.data(), &size);
  CodedInputStream::ReadLittleEndian32FromArray(frame.data() + 4, &crc);
  if (size > kMostBytes) return std::nullopt;
  std::string bytes(size, '\0');
  if (!in_->read(bytes.data(), static_cast<std::streamsize>(size)) || crc_of(bytes) != crc) return std::nullopt;
  msg::JournalBlock block;
  if (!block.ParseFromString(bytes)) return std::nullopt;
  whole_bytes_ += kFrameBytes + size;
  if (block.has_end()) end_ = block.end();
  return block;
}

}  // namespace telepalp::core
