#include "tools/study/task/design.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>

#include "haptic_station/mechanism/held_linkage.h"
#include "proto/words/error_line.h"

namespace telepalp::study {
namespace {

using mechanism::FourBar;

constexpr MechanismParameter kParameters[] = {
    {"l1", &FourBar::l1_m, 1e-3},       {"l2", &FourBar::l2_m, 1e-3},         {"l3", &FourBar::l3_m, 1e-3},
    {"l4", &FourBar::l4_m, 1e-3},       {"theta", &FourBar::needle_rad, 1.0}, {"phi", &FourBar::handle_rad, 1.0},
    {"h", &FourBar::handle_at_m, 1e-3}, {"l_h", &FourBar::handle_m, 1e-3},    {"needle", &FourBar::needle_m, 1e-3}};
constexpr const char* kNames = "name, l1, l2, l3, l4, theta, phi, h, l_h and needle";
constexpr std::size_t kMost = 500;

struct Place {
  const std::string& file;
  std::size_t line;
  std::size_t column;
  [[nodiscard]] Error error(std::string what, std::string fix) const {
    return {.what = std::move(what),
            .where = file + ":" + std::to_string(line) + ":" + std::to_string(column),
            .fix = std::move(fix)};
  }
};

/// Where a parameter's number goes; nullptr: the mechanism has no such parameter.
struct Slot {
  double* value = nullptr;
  double unit = 1.0;
};
Slot slot_of(std::string_view name, Configuration& out) {
  if (out.other) {
    for (const OtherParameter& one : parameters_of(*out.other))
      if (one.name == name) return {one.value, one.unit};
    return {};
  }
  for (const MechanismParameter& one : kParameters)
    if (one.name == name) return {&(out.bar.*one.value), one.unit};
  return {};
}

std::string names_of(Configuration& out) {
  if (!out.other) return kNames;
  std::string names = "name";
  for (const OtherParameter& one : parameters_of(*out.other)) names += ", " + std::string(one.name);
  return names;
}

/// The kind decides which parameters there are, so it comes before them.
Result<void> read_kind(std::string_view kind, bool first, const Place& at, Configuration& out) {
  if (!first) return at.error("kind comes after a parameter", "give kind before the parameters");
  if (kind == "four-bar") return {};
  out.other = other_mechanism(kind);
  if (out.other) return {};
  return at.error("'" + std::string(kind) + "' is no kind of mechanism",
                  "give four-bar, slider-crank, five-bar or six-bar");
}

Result<void> read_pair(std::string_view pair, const Place& at, bool first, Configuration& out) {
  const std::size_t equals = pair.find('=');
  if (equals == std::string_view::npos || equals + 1 == pair.size())
    return at.error("'" + std::string(pair) + "' is not a pair name=value", "give one of " + names_of(out));
  const std::string_view name = pair.substr(0, equals);
  const std::string_view value = pair.substr(equals + 1);
  if (name == "name") {
    out.name = value;
    return {};
  }
  const Place after{at.file, at.line, at.column + equals + 1};
  if (name == "kind") return read_kind(value, first, after, out);
  const Slot slot = slot_of(name, out);
  if (slot.value == nullptr)
    return at.error("'" + std::string(name) + "' is no parameter of a mechanism", "give one of " + names_of(out));
  double number = 0.0;
  const auto read = std::from_chars(value.data(), value.data() + value.size(), number);
  if (read.ec != std::errc{} || read.ptr != value.data() + value.size())
    return after.error("'" + std::string(value) + "' is not a number", "give lengths in mm and angles in rad");
  *slot.value = slot.unit * number;
  out.l4_given |= name == "l4";
  out.needle_given |= name == "needle";
  return {};
}

/// Lengths of a mechanism of another kind: links have one, and all joints close where the tip touches the sac.
Result<void> check_other(Configuration& out, const Place& at) {
  for (const OtherParameter& one : parameters_of(*out.other)) {
    const bool is_place = one.name == "x" || one.name == "y" || one.name == "pivot" || one.name == "h";
    const double most = one.unit == 1.0 ? 2.0 * std::numbers::pi : 1.0;
    if (std::abs(*one.value) <= most && (one.unit == 1.0 || is_place || *one.value > 0.0))
      continue;  // NaN compares false
    return at.error(
        std::string(one.name) + " is " + number_text(*one.value / one.unit) + (one.unit == 1.0 ? " rad" : " mm"),
        "give links from above 0 to 1000 mm, and angles up to a full turn");
  }
  if (const auto good = in_pose(*out.other); !good)
    return at.error(std::string(kind_of(*out.other)) + ": " + good.error().what, good.error().fix);
  return {};
}

Result<Configuration> read_line(const std::string& line, const Place& at) {
  Configuration out;
  out.name = "line " + std::to_string(at.line);
  bool first = true;  // no parameter has come yet
  for (std::size_t from = line.find_first_not_of(" \t\r"); from != std::string::npos;) {
    const std::size_t end = std::min(line.size(), line.find_first_of(" \t\r", from));
    const std::string_view pair = std::string_view(line).substr(from, end - from);
    const Result<void> read = read_pair(pair, {at.file, at.line, from + 1}, first, out);
    if (!read) return read.error();
    first &= pair.starts_with("name=") || pair.starts_with("kind=");
    from = line.find_first_not_of(" \t\r", end);
  }
  if (out.other) {
    if (const Result<void> good = check_other(out, at); !good) return good.error();
    return out;
  }
  FourBar bar = out.bar;
  if (!out.l4_given) bar.l4_m = 0.875 * bar.l2_m;
  if (const Result<FourBar> good = mechanism::checked(bar); !good) return at.error(good.error().what, good.error().fix);
  return out;
}

}  // namespace

std::span<const MechanismParameter> mechanism_parameters() noexcept { return kParameters; }

Design amniocentesis_design() {
  constexpr double kLinks[3][4] = {{0.08, 0.15, 0.12, -0.31}, {0.1, 0.1, 0.1, -0.17}, {0.12, 0.15, 0.08, 0.31}};
  constexpr double kPhi_rad[] = {0.0, std::numbers::pi / 2.0, 5.0 * std::numbers::pi / 6.0};
  constexpr const char* kPhi[] = {"0", "pi/2", "5pi/6"};
  constexpr double kAt_m[] = {0.0, 0.08};
  constexpr double kHandle_m[] = {0.14, 0.18};
  Design design{.name = "amniocentesis", .configurations = {}, .of_the_paper = true};
  for (int linkage = 0; linkage < 3; ++linkage)
    for (int phi = 0; phi < 3; ++phi)
      for (int h = 0; h < 2; ++h)
        for (int l_h = 0; l_h < 2; ++l_h) {
          Configuration one;
          one.name = "linkage " + std::to_string(linkage + 1) + ", phi " + kPhi[phi] + ", h " + (h == 0 ? "0" : "80") +
                     ", l_h " + (l_h == 0 ? "140" : "180");
          const auto& links = kLinks[linkage];
          one.bar.l1_m = links[0];
          one.bar.l2_m = links[1];
          one.bar.l3_m = links[2];
          one.bar.needle_rad = links[3];
          one.bar.handle_rad = kPhi_rad[phi];
          one.bar.handle_at_m = kAt_m[h];
          one.bar.handle_m = kHandle_m[l_h];
          design.configurations.push_back(std::move(one));
        }
  return design;
}

Result<Design> parse_design(const std::string& text, const std::string& file) {
  Design design{.name = file, .configurations = {}};
  std::istringstream lines(text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    Result<Configuration> one = read_line(line, {file, number, first + 1});
    if (!one) return one.error();
    for (const Configuration& other : design.configurations)
      if (other.name == one->name)
        return Place{file, number, first + 1}.error("the name '" + one->name + "' is used twice", "give another name");
    design.configurations.push_back(std::move(*one));
  }
  if (design.configurations.empty() || design.configurations.size() > kMost)
    return Error{.what = "the list has " + std::to_string(design.configurations.size()) + " mechanisms",
                 .where = file,
                 .fix = "give 1 to " + std::to_string(kMost) +
                        ", one in each line, such as name=a l1=80 l2=150 l3=120 phi=1.57"};
  return design;
}

Result<Design> read_design(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    return Error{.what = "cannot be read",
                 .where = file.string(),
                 .fix = "give amniocentesis, or a text file with a list of mechanisms"};
  const std::string text(std::istreambuf_iterator<char>(in), {});
  return parse_design(text, file.string());
}

}  // namespace telepalp::study
