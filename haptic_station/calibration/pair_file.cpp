#include "haptic_station/calibration/pair_file.h"

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace telepalp::calibration {
namespace {

constexpr std::string_view kHeader = "place,to_x_m,to_y_m,to_z_m,from_x_m,from_y_m,from_z_m";
constexpr std::uintmax_t kMostBytes = 16u << 20;
constexpr std::size_t kMostRows = 100'000;

std::string_view next_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// The row's seven numbers; from_chars knows no locale, so a decimal comma makes fields too many.
std::optional<std::array<double, 7>> numbers(std::string_view line) {
  std::array<double, 7> out{};
  const char* at = line.data();
  const char* const end = at + line.size();
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto [stop, error] = std::from_chars(at, end, out[i]);
    if (error != std::errc{} || !std::isfinite(out[i])) return std::nullopt;
    const bool last = i + 1 == out.size();
    if (last != (stop == end) || (!last && *stop != ',')) return std::nullopt;
    at = stop + 1;
  }
  return out;
}

}  // namespace

Result<std::vector<PointPair>> parse_point_pairs(std::string_view text, std::string_view name) {
  const std::string file(name);
  if (next_line(text) != kHeader)
    return Error{
        .what = "the first row is not the header", .where = file + ":1", .fix = "begin with " + std::string(kHeader)};
  std::vector<PointPair> pairs;
  for (std::size_t number = 2; !text.empty(); ++number) {
    const std::string_view line = next_line(text);
    if (line.empty()) continue;
    const auto row = numbers(line);
    const bool good = row && std::abs((*row)[0]) < 1e6 && std::floor((*row)[0]) == (*row)[0];
    if (!good || pairs.size() == kMostRows)
      return Error{.what = good ? "more than 100000 rows" : "not a whole place number and six finite numbers",
                   .where = file + ":" + std::to_string(number),
                   .fix = "give rows like 1,0.1,0.02,0,0.12,0,0.3 with decimal points"};
    const auto& r = *row;
    pairs.push_back({.place = static_cast<int>(r[0]), .to = {r[1], r[2], r[3]}, .from = {r[4], r[5], r[6]}});
  }
  return pairs;
}

Result<std::vector<PointPair>> read_point_pairs(const std::filesystem::path& file) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) return Error{.what = "cannot be read: " + code.message(), .where = file.string(), .fix = "check the path"};
  if (size > kMostBytes) return Error{.what = "larger than 16 MiB", .where = file.string(), .fix = "give fewer rows"};
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) return Error{.what = "cannot be read", .where = file.string(), .fix = "check its permissions"};
  return parse_point_pairs(text.str(), file.string());
}

}  // namespace telepalp::calibration
