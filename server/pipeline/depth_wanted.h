#pragma once

namespace telepalp::pipeline {

/// In which codings subscribers want depth images. Whole ones are also made while nobody wants a window, so that a
/// newcomer sees the patient at once.
struct DepthWanted {
  bool whole = true;
  bool window = false;  ///< images that are exact in the window for the hand

  [[nodiscard]] bool makes_whole() const noexcept { return whole || !window; }
};

}  // namespace telepalp::pipeline
