#include "support/models/lzf.h"

#include <cstring>

namespace telepalp::models {

bool lzf_decompress(std::span<const std::byte> compressed, std::span<std::byte> out) noexcept {
  std::size_t in = 0;
  std::size_t done = 0;
  while (in < compressed.size()) {
    const auto control = static_cast<std::size_t>(compressed[in++]);
    if (control < 32) {  // a run of control + 1 literal bytes
      const std::size_t count = control + 1;
      if (count > compressed.size() - in || count > out.size() - done) return false;
      std::memcpy(&out[done], &compressed[in], count);
      in += count;
      done += count;
      continue;
    }
    std::size_t length = control >> 5U;  // a back reference: 3 bits of length, 13 of distance
    if (length == 7) {
      if (in == compressed.size()) return false;
      length += static_cast<std::size_t>(compressed[in++]);
    }
    length += 2;
    if (in == compressed.size()) return false;
    const std::size_t distance = ((control & 31U) << 8U) + static_cast<std::size_t>(compressed[in++]) + 1;
    if (distance > done || length > out.size() - done) return false;
    for (std::size_t i = 0; i < length; ++i, ++done) out[done] = out[done - distance];  // source and target may overlap
  }
  return done == out.size();
}

}  // namespace telepalp::models
