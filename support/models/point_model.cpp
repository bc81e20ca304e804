#include "support/models/point_model.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace telepalp::models {
namespace {

constexpr std::uintmax_t kMostFileBytes = std::uintmax_t{1} << 30;

Result<std::vector<std::byte>> read_bytes(const std::filesystem::path& file) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) return Error{.what = "cannot be read: " + code.message(), .where = file.string(), .fix = "check the path"};
  if (size > kMostFileBytes)
    return Error{.what = "is larger than 1 GiB", .where = file.string(), .fix = "give a model with fewer points"};
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  std::ifstream in(file, std::ios::binary);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!in)
    return Error{
        .what = "cannot be read to its end", .where = file.string(), .fix = "check the disk and your permissions"};
  return bytes;
}

/// Extent of the middle 98 % along each axis: a few stray points must not decide about the unit.
double extent(const PointModel& model) {
  double widest = 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<float> values;
    for (const Eigen::Vector3f& at : model.points)
      if (at.allFinite()) values.push_back(at[axis]);
    if (values.size() < 2) return 0.0;
    const auto low = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 100);
    const auto high = values.end() - 1 - static_cast<std::ptrdiff_t>(values.size() / 100);
    std::nth_element(values.begin(), low, values.end());
    const float least = *low;
    std::nth_element(values.begin(), high, values.end());
    widest = std::max(widest, static_cast<double>(*high - least));
  }
  return widest;
}

}  // namespace

Result<PointModel> read_point_model(const std::filesystem::path& file) {
  const Result<std::vector<std::byte>> bytes = read_bytes(file);
  if (!bytes) return bytes.error();
  const std::string ending = file.extension().string();
  if (ending == ".pcd") return parse_pcd(*bytes, file.string());
  if (ending == ".ply") return parse_ply(*bytes, file.string());
  if (ending == ".obj") return parse_obj(*bytes, file.string());
  return Error{.what = "is not a supported kind of file", .where = file.string(), .fix = "give .pcd, .ply or .obj"};
}

std::string unit_complaint(const PointModel& model) {
  const double size = extent(model);
  const auto looks = [&](const char* unit) {
    return "the points span " + std::to_string(size) +
           " m, which is not a patient's size: the unit of the coordinates is probably " + unit;
  };
  if (size > 100.0) return looks("1000 times smaller");
  if (size > 12.0) return looks("10 or 100 times smaller");
  if (size > 0.0 && size < 0.002) return looks("1000 times larger");
  return {};
}

}  // namespace telepalp::models
