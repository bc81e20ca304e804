#pragma once

#include <cstddef>
#include <filesystem>

#include "clients/report/session/session.h"
#include "clients/report/summary/quantiles.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::report {

/// What the images of two runs have in common. The recorded depth images are compared. If one run holds no image, as a
/// replay's session does, the images that became a surface are compared instead.
struct ImageComparison {
  std::size_t a = 0, b = 0;  ///< images of each run
  bool surfaces = false;     ///< images that became a surface are compared
  bool matched = false;      ///< the images are matched by their times; false: their rates are compared
  std::size_t missing_in_a = 0, missing_in_b = 0;

  std::size_t pixels = 0;            ///< pixels that both runs measure, over the images that were decoded
  double depth_ratio = kUnknown;     ///< median of B's depth divided by A's
  double depth_apart_mm = kUnknown;  ///< median distance of the two depths
  bool sizes_differ = false;         ///< of the images

  /// Images that one run alone has, as a share of the larger run [%]; NaN (kUnknown) if no run has any.
  [[nodiscard]] double missing_pct() const noexcept;
};

/// Compares the numbers and times of the images, without decoding them.
[[nodiscard]] ImageComparison compare_images(const Session& a, const Session& b);

/// Adds the comparison of two depth images that show the same instant.
void add_depths(ImageComparison& comparison, const DepthImage& a, const DepthImage& b);

/// Decodes three images that both sessions hold, and compares their depths. Does nothing if no image is matched. Error:
/// a file cannot be read.
[[nodiscard]] Result<void> compare_depths(ImageComparison& comparison, const std::filesystem::path& file_a,
                                          const Session& a, const std::filesystem::path& file_b, const Session& b);

}  // namespace telepalp::report
