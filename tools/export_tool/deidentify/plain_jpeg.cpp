#include "tools/export_tool/deidentify/plain_jpeg.h"

#include <cstddef>

namespace telepalp::export_tool {
namespace {

// Markers of ITU-T T.81, table B.1: the second byte, after 0xff.
constexpr unsigned char kStartOfImage = 0xd8;
constexpr unsigned char kEndOfImage = 0xd9;
constexpr unsigned char kStartOfScan = 0xda;
constexpr unsigned char kFirstApplication = 0xe0;
constexpr unsigned char kLastApplication = 0xef;
constexpr unsigned char kComment = 0xfe;

unsigned char byte_at(std::string_view text, std::size_t place) { return static_cast<unsigned char>(text[place]); }

bool is_marker(std::string_view text, std::size_t place, unsigned char marker) {
  return place + 2 <= text.size() && byte_at(text, place) == 0xff && byte_at(text, place + 1) == marker;
}

/// Place of the marker that ends the coded data of the scan that begins at `place`; npos: there is none.
std::size_t end_of_scan(std::string_view jpeg, std::size_t place) {
  for (; place + 2 <= jpeg.size(); ++place) {
    const unsigned char next = byte_at(jpeg, place + 1);
    const bool is_in_scan = next == 0 || next == 0xff || (next >= 0xd0 && next <= 0xd7);  // stuffing, fill, restarts
    if (byte_at(jpeg, place) == 0xff && !is_in_scan) return place;
  }
  return std::string_view::npos;
}

}  // namespace

std::string plain_jpeg(std::string_view jpeg) {
  if (!is_marker(jpeg, 0, kStartOfImage)) return {};
  std::string plain(jpeg.substr(0, 2));
  for (std::size_t place = 2; place + 4 <= jpeg.size() && byte_at(jpeg, place) == 0xff;) {
    const unsigned char marker = byte_at(jpeg, place + 1);
    const std::size_t length = std::size_t{byte_at(jpeg, place + 2)} * 256 + byte_at(jpeg, place + 3);
    std::size_t end = place + 2 + length;
    if (length < 2 || end > jpeg.size()) return {};
    if (marker == kStartOfScan) end = end_of_scan(jpeg, end);
    if (end == std::string_view::npos) return {};
    const bool is_note = (marker >= kFirstApplication && marker <= kLastApplication) || marker == kComment;
    if (!is_note) plain += jpeg.substr(place, end - place);
    place = end;
    if (is_marker(jpeg, place, kEndOfImage)) return plain += jpeg.substr(place, 2);
  }
  return {};
}

}  // namespace telepalp::export_tool
