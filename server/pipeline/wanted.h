#pragma once

#include <optional>

#include "proto/words/depth/depth_window.h"

namespace telepalp::pipeline {

/// In which codings subscribers want colour images. Pictures (JPEG) are also made while nobody wants video: they cost
/// little, and a newcomer then sees the patient at once.
struct ColorWanted {
  bool pictures = true;
  bool video = false;

  [[nodiscard]] bool makes_pictures() const noexcept { return pictures || !video; }
};

/// In which codings subscribers want depth images. Whole images are also made while nobody wants a window, so that a
/// newcomer sees the patient at once.
struct DepthWanted {
  bool whole = true;    ///< images that are as exact everywhere as the server's options say
  bool window = false;  ///< images that are exact in the window for the hand

  [[nodiscard]] bool makes_whole() const noexcept { return whole || !window; }
};

/// What subscribers want of the camera's images.
struct Wanted {
  ColorWanted color{};
  DepthWanted depth{};
  std::optional<DepthWindow> window{};  ///< where depth with a window is exact; nullopt: everywhere
};

}  // namespace telepalp::pipeline
