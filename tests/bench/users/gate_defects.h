#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::bench {

// Defects that are planted into a real session file. Each copies `from` to `to`. Error: `from` cannot be read, has
// nothing to plant the defect in, or `to` cannot be written.

/// Every force above `most_N` has this length.
[[nodiscard]] Result<void> clip_forces(const std::filesystem::path& from, const std::filesystem::path& to,
                                       double most_N);

/// In each contact, no force and no contact until the device is `late_m` deeper than where the contact began.
[[nodiscard]] Result<void> begin_contacts_late(const std::filesystem::path& from, const std::filesystem::path& to,
                                               double late_m);

/// `share` of the depth images are left out, evenly.
[[nodiscard]] Result<void> remove_images(const std::filesystem::path& from, const std::filesystem::path& to,
                                         double share);

/// Each depth is `scale` times as large.
[[nodiscard]] Result<void> scale_depths(const std::filesystem::path& from, const std::filesystem::path& to,
                                        double scale);

/// The intrinsics of the depth camera are those of an image of half the size.
[[nodiscard]] Result<void> halve_intrinsics(const std::filesystem::path& from, const std::filesystem::path& to);

/// One second of messages is left out, in the middle.
[[nodiscard]] Result<void> remove_a_second(const std::filesystem::path& from, const std::filesystem::path& to);

/// A copy of a scene file with `old` replaced by `now`. Error: `old` is not in it.
[[nodiscard]] Result<void> edit_scene(const std::filesystem::path& from, const std::filesystem::path& to,
                                      std::string_view old, std::string_view now);

}  // namespace telepalp::bench
