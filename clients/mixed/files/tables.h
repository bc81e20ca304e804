#pragma once

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"
#include "proto/words/rotation_vector.h"

namespace telepalp::mixed {

/// Calls `row` with each line after the header that is not empty. Error, with file and line: the file cannot be read,
/// its first line is not `header`, or `row` returns false.
[[nodiscard]] Result<void> each_row(const std::filesystem::path& file, std::string_view header,
                                    const std::function<bool(std::string_view)>& row);

/// The numbers with nine digits, separated by commas.
[[nodiscard]] std::string cells(const std::vector<double>& values);

/// Translation and rotation vector of a pose: six numbers.
[[nodiscard]] std::vector<double> pose_numbers(const Eigen::Isometry3d& pose);

/// The three numbers of a row from `first` on.
template <std::size_t N>
[[nodiscard]] Eigen::Vector3d vector_at(const std::array<double, N>& n, std::size_t first) {
  return {n[first], n[first + 1], n[first + 2]};
}

/// The pose whose pose_numbers() a row has from `first` on.
template <std::size_t N>
[[nodiscard]] Eigen::Isometry3d pose_at(const std::array<double, N>& n, std::size_t first) {
  return isometry_of(vector_at(n, first + 3), vector_at(n, first));
}

}  // namespace telepalp::mixed
