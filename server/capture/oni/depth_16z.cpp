#include "server/capture/oni/depth_16z.h"

namespace telepalp::capture {
namespace {

constexpr unsigned kFirstRun = 0xE0;      // 0xE0 + n: 2n samples equal to the last one
constexpr unsigned kWholeByte = 0xFF;     // one sample follows, as an 8-bit difference or as a whole value
constexpr unsigned kNibbleEscape = 0x0F;  // like kWholeByte, but in the second half of a byte
constexpr unsigned kNibbleNothing = 0x0D;
constexpr int kNibbleZero = 6;   // the nibble for a difference of 0
constexpr int kByteZero = 0xC0;  // the byte for a difference of 0
constexpr unsigned kIsByte = 0x80;

class Bytes {
 public:
  explicit Bytes(std::span<const std::byte> left) : left_(left) {}
  [[nodiscard]] bool empty() const { return left_.empty(); }
  std::optional<unsigned> take() {
    if (left_.empty()) return std::nullopt;
    const auto byte = std::to_integer<unsigned>(left_.front());
    left_ = left_.subspan(1);
    return byte;
  }
  std::optional<std::uint16_t> take_little_endian16() {
    const auto low = take();
    const auto high = take();
    if (!high) return std::nullopt;
    return static_cast<std::uint16_t>(*low | *high << 8);
  }

 private:
  std::span<const std::byte> left_;
};

/// Collects up to `count` samples; a further one is refused.
class Samples {
 public:
  Samples(std::span<const std::uint16_t> table, std::size_t count) : table_(table), count_(count) {
    samples_.reserve(count);
  }
  bool add(std::uint16_t code, unsigned times = 1) {
    if (times > count_ - samples_.size() || (!table_.empty() && code >= table_.size())) return false;
    samples_.insert(samples_.end(), times, table_.empty() ? code : table_[code]);
    last_ = code;
    return true;
  }
  bool add_less(int difference) { return add(static_cast<std::uint16_t>(last_ - difference)); }
  [[nodiscard]] std::uint16_t last() const { return last_; }
  [[nodiscard]] bool whole() const { return samples_.size() == count_; }
  std::vector<std::uint16_t> take() && { return std::move(samples_); }

 private:
  std::span<const std::uint16_t> table_;
  std::size_t count_;
  std::uint16_t last_ = 0;
  std::vector<std::uint16_t> samples_;
};

/// Decodes a sample whose difference does not fit four bits.
bool decode_far(Bytes& bytes, Samples& samples) {
  const auto first = bytes.take();
  if (!first) return false;
  if ((*first & kIsByte) != 0) return samples.add_less(static_cast<int>(*first) - kByteZero);
  const auto second = bytes.take();
  return second && samples.add(static_cast<std::uint16_t>(*first << 8 | *second));
}

bool decode_next(Bytes& bytes, Samples& samples) {
  const unsigned byte = *bytes.take();
  if (byte == kWholeByte) return decode_far(bytes, samples);
  if (byte >= kFirstRun) return byte == kFirstRun || samples.add(samples.last(), 2 * (byte - kFirstRun));
  if (!samples.add_less(static_cast<int>(byte >> 4) - kNibbleZero)) return false;
  const unsigned second = byte & 0x0F;
  if (second == kNibbleEscape) return decode_far(bytes, samples);
  return second == kNibbleNothing || samples.add_less(static_cast<int>(second) - kNibbleZero);
}

std::optional<std::vector<std::uint16_t>> decode(Bytes bytes, std::span<const std::uint16_t> table, std::size_t count) {
  Samples samples(table, count);
  const auto first = bytes.take_little_endian16();
  if (!first || !samples.add(*first)) return std::nullopt;
  while (!bytes.empty())
    if (!decode_next(bytes, samples)) return std::nullopt;
  if (!samples.whole()) return std::nullopt;
  return std::move(samples).take();
}

}  // namespace

std::optional<std::vector<std::uint16_t>> decode_16z(std::span<const std::byte> packet, std::size_t count) {
  return decode(Bytes{packet}, {}, count);
}

std::optional<std::vector<std::uint16_t>> decode_16z_table(std::span<const std::byte> packet, std::size_t count) {
  Bytes bytes(packet);
  const auto entries = bytes.take_little_endian16();
  if (!entries || *entries == 0) return std::nullopt;
  std::vector<std::uint16_t> table;
  for (std::size_t i = 0; i < *entries; ++i) {
    const auto value = bytes.take_little_endian16();
    if (!value) return std::nullopt;
    table.push_back(*value);
  }
  return decode(bytes, table, count);
}

}  // namespace telepalp::capture
