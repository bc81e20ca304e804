#include "codec/depth_reader.h"

#include <utility>

namespace telepalp::codec {
namespace {

// A second of frames; beyond either they are decoded rather than kept.
constexpr std::size_t kMostPassed = 32;
constexpr std::size_t kMostPassedBytes = std::size_t{16} << 20;

std::span<const std::byte> bytes_of(const std::string& packet) { return std::as_bytes(std::span(packet)); }

}  // namespace

void DepthReader::pass_over(std::string packet) {
  if (stands_alone(bytes_of(packet))) forget_passed();
  passed_bytes_ += packet.size();
  passed_.push_back(std::move(packet));
  if (passed_.size() > kMostPassed || passed_bytes_ > kMostPassedBytes) catch_up();
}

Result<DepthImage> DepthReader::read(std::span<const std::byte> packet) {
  if (stands_alone(packet)) forget_passed();
  catch_up();
  return decoder_.decode(packet);
}

void DepthReader::catch_up() {
  for (const std::string& packet : passed_) (void)decoder_.decode(bytes_of(packet));
  forget_passed();
}

void DepthReader::forget_passed() {
  passed_.clear();
  passed_bytes_ = 0;
}

}  // namespace telepalp::codec
