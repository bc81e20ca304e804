#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#include "codec/depth.h"
#include "proto/words/depth/depth_window.h"

namespace telepalp::codec {

/// A window for images of 64 x 40 pixels or more.
inline DepthWindow some_window() { return window_around({20, 10, 24, 16}, WindowGrowth::Growing); }

/// The window of the golden frame `i`; it moves.
inline DepthWindow golden_window(unsigned i) {
  return window_around({6 + 2 * static_cast<int>(i), 4, 10, 8}, i == 1 ? WindowGrowth::Growing : WindowGrowth::Flat);
}

/// Fails unless `back` is exact in the window, within the stated bound elsewhere, and has the holes of `depth`.
inline void expect_within(const DepthImage& back, const DepthImage& depth, const DepthWindow& window,
                          const auto& name) {
  ASSERT_EQ(back.samples.size(), depth.samples.size()) << name;
  for (int row = 0; row < depth.height; ++row)
    for (int column = 0; column < depth.width; ++column) {
      const int was = depth.at(column, row);
      const int is = back.at(column, row);
      ASSERT_EQ(is == 0, was == 0) << name << ", pixel " << column << ", " << row;
      const auto bound = bound_at(window, depth.width, depth.height, column, row);
      const double most_m = bound ? bound->at(was * depth.unit_m) + 1e-9 : 0.0;
      ASSERT_LE(std::abs(is - was) * depth.unit_m, most_m) << name << ", pixel " << column << ", " << row;
    }
}

}  // namespace telepalp::codec
