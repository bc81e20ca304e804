#include "codec/depth_reader.h"

#include <utility>

namespace telepalp::codec {
namespace {

constexpr std::size_t kMostPassed = 32;  // a second of frames; beyond it they are decoded rather than kept

std::span<const std::byte> bytes_of(const std::string& packet) { return std::as_bytes(std::span(packet)); }

}  // namespace

void DepthReader::pass_over(std::string packet) {
  if (stands_alone(bytes_of(packet))) passed_.clear();
  passed_.push_back(std::move(packet));
  if (passed_.size() > kMostPassed) catch_up();
}

Result<DepthImage> DepthReader::read(std::span<const std::byte> packet) {
  if (stands_alone(packet)) passed_.clear();
  catch_up();
  return decoder_.decode(packet);
}

void DepthReader::catch_up() {
  for (const std::string& packet : std::exchange(passed_, {})) (void)decoder_.decode(bytes_of(packet));
}

}  // namespace telepalp::codec
