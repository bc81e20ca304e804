#pragma once

#include <cstddef>
#include <cstdio>

#include "proto/words/counted.h"

namespace telepalp::codec_tool {

/// Total size of compressed images.
struct Totals {
  std::size_t frames = 0;
  double pixels = 0.0;
  double bytes = 0.0;  ///< compressed

  void add(double image_pixels, std::size_t packet_bytes) noexcept {
    ++frames;
    pixels += image_pixels;
    bytes += static_cast<double>(packet_bytes);
  }
  void print() const {
    std::printf("%s, %.0f B of depth compressed to %.0f B: ratio %.2f, %.3f bits per pixel\n",
                counted(frames, "frame", "frames").c_str(), 2.0 * pixels, bytes, 2.0 * pixels / bytes,
                8.0 * bytes / pixels);
  }
};

}  // namespace telepalp::codec_tool
