#include "tests/bench/users/session_damage.h"

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "proto/wire/mcap/format/byte_cursor.h"
#include "proto/wire/mcap/format/records.h"

namespace telepalp::bench {
namespace {

using wire::mcap::kRecordHeadBytes;
using wire::mcap::Opcode;

constexpr std::size_t kPageBytes = 4096;

struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

std::string name_of(Opcode opcode) {
  constexpr std::array kNames{"Header",     "Footer",       "Schema",        "Channel",       "Message",
                              "Chunk",      "MessageIndex", "ChunkIndex",    "Attachment",    "AttachmentIndex",
                              "Statistics", "Metadata",     "MetadataIndex", "SummaryOffset", "DataEnd"};
  const auto place = static_cast<std::size_t>(opcode) - 1;
  return place < kNames.size() ? kNames[place] : "unknown record";
}

/// The records of a session, by kind; those of the summary have a kind of their own. Also both ends' magic bytes.
std::map<std::string, std::vector<Span>> records_of(std::string_view session) {
  std::map<std::string, std::vector<Span>> kinds;
  bool in_summary = false;
  std::size_t at = wire::mcap::kMagic.size();
  kinds["magic"].push_back({0, at});
  while (session.size() - at > kRecordHeadBytes) {
    wire::mcap::ByteCursor from(session.substr(at, kRecordHeadBytes));
    const auto opcode = static_cast<Opcode>(from.u8());
    const std::uint64_t length = from.u64();
    if (length > session.size() - at - kRecordHeadBytes) break;
    const Span span{at, at + kRecordHeadBytes + static_cast<std::size_t>(length)};
    kinds[name_of(opcode) + (in_summary ? " of the summary" : "")].push_back(span);
    in_summary = in_summary || opcode == Opcode::DataEnd;
    at = span.end;
  }
  if (at < session.size()) kinds["magic"].push_back({at, session.size()});
  return kinds;
}

/// Where a damage lies, from a seeded generator.
class Places {
 public:
  Places(std::string_view session, unsigned seed) : session_(session), random_(seed) {}

  [[nodiscard]] std::size_t below(std::size_t limit) { return random_() % std::max<std::size_t>(limit, 1); }
  template <class T>
  [[nodiscard]] const T& any_of(const std::vector<T>& all) {
    return all[below(all.size())];
  }
  /// A block that ends in the session.
  [[nodiscard]] Span block(std::size_t bytes) {
    const std::size_t begin = below(session_.size() - std::min(bytes, session_.size()));
    return {begin, std::min(begin + bytes, session_.size())};
  }

 private:
  std::string_view session_;
  std::mt19937 random_;
};

std::string at_byte(std::size_t place) { return " at byte " + std::to_string(place); }

Damage flipped(std::string_view session, Places& places, unsigned turn) {
  const auto kinds = records_of(session);
  const auto& [kind, spans] = *std::next(kinds.begin(), static_cast<std::ptrdiff_t>(turn % kinds.size()));
  const Span& span = places.any_of(spans);
  const std::size_t at = span.begin + places.below(span.end - span.begin);
  std::string bytes(session);
  bytes[at] = static_cast<char>(bytes[at] ^ (1 << places.below(8)));
  return {std::move(bytes), "a bit flipped in " + kind + at_byte(at)};
}

Damage cut(std::string_view session, Places& places) {
  const std::size_t length = places.below(session.size());
  return {std::string(session.substr(0, length)), "cut to " + std::to_string(length) + " bytes"};
}

Damage swapped(std::string_view session, Places& places) {
  const std::size_t size = std::size_t{1} << (4 + places.below(9));
  const Span a = places.block(size), b = places.block(size);
  std::string bytes(session);
  const bool apart = a.end <= b.begin || b.end <= a.begin;
  if (apart && a.end - a.begin == b.end - b.begin)
    std::swap_ranges(bytes.begin() + static_cast<std::ptrdiff_t>(a.begin),
                     bytes.begin() + static_cast<std::ptrdiff_t>(a.end),
                     bytes.begin() + static_cast<std::ptrdiff_t>(b.begin));
  return {std::move(bytes), "two blocks of " + std::to_string(size) + " bytes swapped" + at_byte(a.begin)};
}

Damage zeroed(std::string_view session, const Span& span, const std::string& what) {
  std::string bytes(session);
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(span.begin),
            bytes.begin() + static_cast<std::ptrdiff_t>(span.end), '\0');
  return {std::move(bytes), what + " zeroed" + at_byte(span.begin)};
}

Damage page_zeroed(std::string_view session, Places& places) {
  const std::size_t begin = places.below(session.size() / kPageBytes + 1) * kPageBytes;
  return zeroed(session, {begin, std::min(begin + kPageBytes, session.size())}, "a page");
}

/// The place of a CRC in its record: behind the two times and the size of a chunk, at the end of other records.
Damage crc_zeroed(std::string_view session, Places& places) {
  constexpr std::size_t kCrcBytes = 4;
  auto kinds = records_of(session);
  std::vector<std::pair<std::string, std::vector<Span>>> with_crc;
  for (const char* kind : {"Chunk", "Attachment", "DataEnd", "Footer of the summary"})
    if (kinds.contains(kind)) with_crc.emplace_back(kind, kinds[kind]);
  const auto& [kind, spans] = places.any_of(with_crc);
  const Span& record = places.any_of(spans);
  const std::size_t at = kind == "Chunk" ? record.begin + kRecordHeadBytes + 3 * 8 : record.end - kCrcBytes;
  return zeroed(session, {at, at + kCrcBytes}, "the CRC of " + kind);
}

Damage removed(std::string_view session, Places& places) {
  const Span gone = places.block(1 + places.below(2 * kPageBytes));
  return {std::string(session.substr(0, gone.begin)) + std::string(session.substr(gone.end)),
          std::to_string(gone.end - gone.begin) + " bytes removed" + at_byte(gone.begin)};
}

Damage repeated(std::string_view session, Places& places) {
  const Span twice = places.block(1 + places.below(2 * kPageBytes));
  return {std::string(session.substr(0, twice.end)) + std::string(session.substr(twice.begin)),
          std::to_string(twice.end - twice.begin) + " bytes repeated" + at_byte(twice.begin)};
}

Damage appended(std::string_view session, Places& places) {
  const Span more = places.block(1 + places.below(kPageBytes));
  return {std::string(session) + std::string(session.substr(more.begin, more.end - more.begin)),
          std::to_string(more.end - more.begin) + " bytes appended"};
}

Damage other_damage(std::string_view session, Places& places, unsigned turn) {
  constexpr std::array kKinds{cut, swapped, page_zeroed, crc_zeroed, removed, repeated, appended};
  return kKinds[turn % kKinds.size()](session, places);
}

}  // namespace

Damage damaged(std::string_view session, unsigned number) {
  Places places(session, number);
  for (;;) {
    Damage damage = number % 2 == 0 ? flipped(session, places, number / 2) : other_damage(session, places, number / 2);
    if (damage.bytes != session) return damage;
  }
}

}  // namespace telepalp::bench
