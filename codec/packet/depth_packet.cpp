#include "codec/packet/depth_packet.h"

#include <cmath>

#include "codec/bytes/bytes.h"
#include "codec/bytes/crc32c.h"
#include "proto/words/formats.h"

namespace telepalp::codec {
namespace {

constexpr std::string_view kMagic = "TPD";
constexpr char kVersion = '0' + kOldestDepthPacketVersion;
constexpr char kVersionWithWindow = '0' + kDepthPacketVersion;
constexpr std::size_t kCrcAt = 12;

void append_window(std::string& bytes, const DepthWindow& window) {
  const PixelRect& exact = window.exact;
  for (const int number : {exact.column, exact.row, exact.width, exact.height})
    append(bytes, static_cast<std::uint16_t>(number));
  for (const double bound : {window.near.least_m, window.near.per_m, window.border.least_m, window.border.per_m})
    append(bytes, bound);
}

std::string header_bytes(const PacketHeader& header) {
  std::string bytes(kMagic);
  bytes.push_back(header.window ? kVersionWithWindow : kVersion);
  append(bytes, static_cast<std::uint8_t>(header.mode));
  append(bytes, static_cast<std::uint8_t>(header.coding));
  append(bytes, header.slices);
  append(bytes, std::uint8_t{0});
  append(bytes, static_cast<std::uint16_t>(header.width));
  append(bytes, static_cast<std::uint16_t>(header.height));
  append(bytes, header.crc);
  append(bytes, header.unit_m);
  append(bytes, header.reference);
  append(bytes, header.since_key);
  append(bytes, std::uint16_t{0});
  if (header.window) append_window(bytes, *header.window);
  return bytes;
}

bool is_side(int side) noexcept { return side > 0 && side <= kMaxImageSide; }

}  // namespace

Error damaged(std::string what) {
  return {.what = std::move(what),
          .where = "compressed depth image",
          .fix =
              "in a live stream, wait for the next key frame; if later depth images fail as well, install the same "
              "version of telepalp at both ends"};
}

std::uint32_t frame_crc(const PacketHeader& header, std::span<const std::uint16_t> samples) {
  const std::string bytes = header_bytes(header);
  const auto all = std::as_bytes(std::span(bytes));
  const std::uint32_t front = crc32c(all.first(kCrcAt));
  return crc32c(std::as_bytes(samples), crc32c(all.subspan(kCrcAt + sizeof header.crc), front));
}

WrittenPacket write_packet(PacketHeader header, std::span<const std::uint16_t> samples, std::string_view body) {
  header.crc = frame_crc(header, samples);
  WrittenPacket packet{
      .bytes = header_bytes(header), .crc = header.crc, .key_frame = header.coding != Coding::Dependent};
  packet.bytes.append(body);
  return packet;
}

namespace {

Error other_version(char version) {
  return {
      .what = "it has version " + std::to_string(static_cast<int>(version) - '0') +
              " of the depth codec, but this program reads versions " + std::to_string(kOldestDepthPacketVersion) +
              " to " + std::to_string(kDepthPacketVersion),
      .where = "compressed depth image",
      .fix = "install the same version of telepalp at both ends; read a recording with the version that recorded it"};
}

/// Reads the window, which follows the fixed header, into `header`. Error: it is cut short, is not well formed for the
/// image, or the packet's mode or coding has no windows.
Result<void> read_window(ByteReader& reader, PacketHeader& header) {
  if (reader.rest().size() < kWindowBytes) return damaged("it ends before its window");
  DepthWindow window;
  for (int* number : {&window.exact.column, &window.exact.row, &window.exact.width, &window.exact.height})
    *number = *reader.number<std::uint16_t>();
  for (double* bound : {&window.near.least_m, &window.near.per_m, &window.border.least_m, &window.border.per_m})
    *bound = *reader.number<double>();
  if (!is_well_formed(window, header.width, header.height))
    return damaged("its window is empty, leaves the image, or has bounds that are not 0 to 1 m and growing");
  if (header.mode != DepthMode::Intra && header.mode != DepthMode::Temporal)
    return damaged("it has a window, but a mode without windows");
  if (header.coding == Coding::Zstd || header.coding == Coding::Tokens)
    return damaged("it has a window, but a coding without windows");
  header.window = window;
  return {};
}

/// Reads the 28 bytes after magic and version. Error: a field is out of bounds.
Result<PacketHeader> read_header(ByteReader& reader) {
  PacketHeader header;
  const std::uint8_t mode = *reader.number<std::uint8_t>();
  const std::uint8_t coding = *reader.number<std::uint8_t>();
  header.slices = *reader.number<std::uint8_t>();
  const std::uint8_t zero = *reader.number<std::uint8_t>();
  header.width = *reader.number<std::uint16_t>();
  header.height = *reader.number<std::uint16_t>();
  header.crc = *reader.number<std::uint32_t>();
  header.unit_m = *reader.number<double>();
  header.reference = *reader.number<std::uint32_t>();
  header.since_key = *reader.number<std::uint16_t>();
  const std::uint16_t zeros = *reader.number<std::uint16_t>();
  if (mode > kLastDepthMode || coding > kLastCoding || zero != 0 || zeros != 0 || header.slices == 0)
    return damaged("its header names an unknown mode or coding, declares no slices, or sets reserved bytes");
  header.mode = static_cast<DepthMode>(mode);
  header.coding = static_cast<Coding>(coding);
  if (!is_side(header.width) || !is_side(header.height))
    return damaged("it declares " + std::to_string(header.width) + " x " + std::to_string(header.height) +
                   " pixels, not 1 to " + std::to_string(kMaxImageSide) + " a side");
  if (!std::isfinite(header.unit_m) || header.unit_m <= 0.0) return damaged("its depth unit is not a positive length");
  if ((header.coding == Coding::Dependent) != (header.since_key != 0))
    return damaged("it is marked both as a key frame and as a predicted frame");
  return header;
}

}  // namespace

Result<Packet> read_packet(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (bytes.size() < kHeaderBytes || !text.starts_with(kMagic))
    return damaged("its " + std::to_string(bytes.size()) + " B do not begin with the header of a depth image");
  const char version = text[kMagic.size()];
  if (version != kVersion && version != kVersionWithWindow) return other_version(version);
  ByteReader reader(bytes.subspan(kMagic.size() + sizeof version));
  Result<PacketHeader> header = read_header(reader);
  if (!header) return header.error();
  if (version == kVersionWithWindow)
    if (const Result<void> read = read_window(reader, *header); !read) return read.error();
  return Packet{*header, reader.rest()};
}

bool is_key_frame(std::span<const std::byte> bytes) {
  const Result<Packet> packet = read_packet(bytes);
  return packet.ok() && packet->header.coding != Coding::Dependent;
}

}  // namespace telepalp::codec
