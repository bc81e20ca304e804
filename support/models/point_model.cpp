#include "support/models/point_model.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "proto/words/error_line.h"
#include "proto/words/numbers/quantile.h"

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
    const std::size_t strays = values.size() / 100;
    const float least = value_at_rank(std::span(values), strays);
    widest = std::max(widest, double{value_at_rank(std::span(values), values.size() - 1 - strays) - least});
  }
  return widest;
}

constexpr double kLeastSize_m = 0.002, kMostSize_m = 12.0;

/// Three digits are enough to recognise a size.
std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// Names the units, a power of ten of the present one, that give a size from an organ's to a person's.
std::string fix_of(double size_m, double unit_m) {
  constexpr double kOrgan_m = 0.04, kPerson_m = 2.5;
  std::string units, first;
  for (const double factor : {1e-3, 1e3, 1e-2, 1e-1, 1e2, 1e1, 1e-6, 1e6}) {
    if (size_m * factor < kOrgan_m || size_m * factor > kPerson_m) continue;
    const std::string unit = number_text(std::stod(rounded(unit_m * factor)));
    units += (units.empty() ? "" : " or ") + unit + " (then the points span " + rounded(size_m * factor) + " m)";
    if (first.empty()) first = unit;
  }
  if (first.empty())
    return "check the file: no usual unit of its coordinates gives a patient's size; another unit is given by unit_m, "
           "its length in metres";
  return "give unit_m, the metres for one unit of the file, as " + units + ": telepalp-station --surface model:FILE," +
         "unit_m=" + first + ", unit_m: " + first + " in a scene, or telepalp-probe --unit-m " + first;
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

std::optional<Error> unit_error(const PointModel& model, double unit_m) {
  const double size_m = extent(model);
  if (size_m == 0.0 || (size_m >= kLeastSize_m && size_m <= kMostSize_m)) return std::nullopt;
  return Error{.what = "the points span " + rounded(size_m) + " m with unit_m " + number_text(unit_m) +
                       ", which is not a patient's size",
               .where = {},
               .fix = fix_of(size_m, unit_m)};
}

}  // namespace telepalp::models
