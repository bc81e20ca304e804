#include "clients/mixed/files/tables.h"

#include <cstdio>
#include <fstream>
#include <iterator>

#include "proto/words/numbers/number_row.h"

namespace telepalp::mixed {
namespace {

using Eigen::Vector3d;
namespace fs = std::filesystem;

Result<std::string> read_table(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    return Error{.what = "the file cannot be read",
                 .where = file.string(),
                 .fix = "name a table, or a folder of tables, in the form that telepalp-mixed render writes"};
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

Result<void> each_row(const fs::path& file, std::string_view header, const std::function<bool(std::string_view)>& row) {
  const Result<std::string> text = read_table(file);
  if (!text) return text.error();
  std::string_view rest = *text;
  if (take_line(rest) != header)
    return Error{.what = "the first line is not this table's header",
                 .where = file.string() + ":1",
                 .fix = "write this line first: " + std::string(header)};
  for (int line = 2; !rest.empty(); ++line) {
    const std::string_view here = take_line(rest);
    if (!here.empty() && !row(here))
      return Error{.what = "the row does not fit the header, or a number in it is not finite",
                   .where = file.string() + ":" + std::to_string(line),
                   .fix = "correct the row; if it is the last one, the file was cut short"};
  }
  return {};
}

std::string cells(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    char one[40];
    std::snprintf(one, sizeof one, "%s%.9g", text.empty() ? "" : ",", value);
    text += one;
  }
  return text;
}

std::vector<double> pose_numbers(const Eigen::Isometry3d& pose) {
  const Eigen::AngleAxisd turn(pose.linear());
  const Vector3d at = pose.translation(), vector = turn.angle() * turn.axis();
  return {at.x(), at.y(), at.z(), vector.x(), vector.y(), vector.z()};
}

}  // namespace telepalp::mixed
