#pragma once

namespace telepalp::pipeline {

/// In which codings subscribers want colour images. Pictures (JPEG) are also made while nobody wants video: they cost
/// little, and a newcomer then sees the patient at once.
struct ColorWanted {
  bool pictures = true;
  bool video = false;

  [[nodiscard]] bool makes_pictures() const noexcept { return pictures || !video; }
};

}  // namespace telepalp::pipeline
