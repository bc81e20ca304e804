#pragma once

#include <optional>
#include <string>

#include "proto/words/depth/depth_window.h"
#include "server/plan/grade.h"

namespace telepalp::pipeline {

/// In which codings subscribers want colour images. Pictures (JPEG) are also made while nobody wants video: they cost
/// little, and a newcomer then sees the patient at once.
struct ColorWanted {
  bool pictures = true;
  bool video = false;

  [[nodiscard]] bool makes_pictures() const noexcept { return pictures || !video; }
  [[nodiscard]] bool any() const noexcept { return pictures || video; }
};

/// In which codings subscribers want depth images. Whole images are also made while nobody wants a window, so that a
/// newcomer sees the patient at once.
struct DepthWanted {
  bool whole = true;    ///< images that are as exact everywhere as the server's options say
  bool window = false;  ///< images that are exact in the window for the hand

  [[nodiscard]] bool makes_whole() const noexcept { return whole || !window; }
  [[nodiscard]] bool any() const noexcept { return whole || window; }
};

/// In which codings the subscribers of one grade want images, and with which settings these are made.
struct GradeWanted {
  ColorWanted color{.pictures = false, .video = false};
  DepthWanted depth{.whole = false, .window = false};
  plan::ImageSettings settings{};
};

/// What subscribers want of the camera's images.
struct Wanted {
  ColorWanted color{};                  ///< by the subscribers that get Grade::Full
  DepthWanted depth{};                  ///< by the same
  std::optional<DepthWindow> window{};  ///< where depth with a window is exact; nullopt: everywhere
  GradeWanted touch{};                  ///< by the subscribers that get Grade::Touch
  GradeWanted view{};                   ///< by the subscribers that get Grade::View
  std::string given_up{};               ///< for people: plan::in_words() of the plan's sacrifice; empty: nothing

  /// What is made of `grade`. While nobody takes another grade, Full is also made, so that a newcomer sees the patient
  /// at once.
  [[nodiscard]] GradeWanted made(plan::Grade grade) const noexcept {
    if (grade != plan::Grade::Full) return grade == plan::Grade::Touch ? touch : view;
    GradeWanted full{.color = color, .depth = depth, .settings = {}};
    if (!touch.color.any() && !view.color.any()) full.color.pictures = color.makes_pictures();
    if (!touch.depth.any() && !view.depth.any()) full.depth.whole = depth.makes_whole();
    return full;
  }
};

}  // namespace telepalp::pipeline
