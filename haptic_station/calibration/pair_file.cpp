#include "haptic_station/calibration/pair_file.h"

#include <cmath>
#include <string>

#include "haptic_station/calibration/number_rows.h"
#include "proto/words/numbers/number_row.h"

namespace telepalp::calibration {
namespace {

constexpr std::string_view kHeader = "place,to_x_m,to_y_m,to_z_m,from_x_m,from_y_m,from_z_m";

}  // namespace

Result<std::vector<PointPair>> parse_point_pairs(std::string_view text, std::string_view name) {
  const std::string file(name);
  if (take_line(text) != kHeader)
    return Error{.what = "the first row is not the header",
                 .where = file + ":1",
                 .fix = "write this first row: " + std::string(kHeader)};
  std::vector<PointPair> pairs;
  for (std::size_t number = 2; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    if (line.empty()) continue;
    const auto row = number_row<7>(line);
    const bool good = row && std::abs((*row)[0]) < 1e6 && std::floor((*row)[0]) == (*row)[0];
    if (!good || pairs.size() == kMostPairs)
      return Error{
          .what = good ? "the file has more than 100000 rows"
                       : "the row is not seven finite numbers: the number of the place, which is an integer, and six "
                         "coordinates in metres",
          .where = file + ":" + std::to_string(number),
          .fix = good ? "give at most 100000 rows" : "write rows with decimal points, such as 1,0.1,0.02,0,0.12,0,0.3"};
    const auto& r = *row;
    pairs.push_back({.place = static_cast<int>(r[0]), .to = {r[1], r[2], r[3]}, .from = {r[4], r[5], r[6]}});
  }
  return pairs;
}

Result<std::vector<PointPair>> read_point_pairs(const std::filesystem::path& file) {
  const Result<std::string> text = read_rows(file);
  if (!text) return text.error();
  return parse_point_pairs(*text, file.string());
}

}  // namespace telepalp::calibration
