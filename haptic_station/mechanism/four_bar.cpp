#include "haptic_station/mechanism/four_bar.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "haptic_station/mechanism/crank_range.h"
#include "haptic_station/mechanism/four_bar_pose.h"
#include "proto/words/error_line.h"

namespace telepalp::mechanism {
namespace {

constexpr double kShortest_m = 1e-4;  // shorter links cannot be built, and make the equations of the loop singular
constexpr double kLeastLever_m = 1e-3;

struct Parameter {
  const char* name;
  double FourBar::*value;
  bool link;
};
constexpr Parameter kParameters[] = {
    {"l1", &FourBar::l1_m, true},           {"l2", &FourBar::l2_m, true},
    {"l3", &FourBar::l3_m, true},           {"l4", &FourBar::l4_m, true},
    {"theta", &FourBar::needle_rad, false}, {"the needle's length", &FourBar::needle_m, false},
    {"phi", &FourBar::handle_rad, false},   {"h", &FourBar::handle_at_m, false},
    {"l_h", &FourBar::handle_m, false}};

/// A length in mm, rounded to 0.001 mm.
std::string mm(double m) { return number_text(std::round(1e6 * m) / 1e3); }

std::string links_in_words(const FourBar& bar) {
  return "links l1 = " + mm(bar.l1_m) + ", l2 = " + mm(bar.l2_m) + ", l3 = " + mm(bar.l3_m) +
         " and l4 = " + mm(bar.l4_m) + " mm";
}

Result<void> check_numbers(const FourBar& bar) {
  for (const Parameter& parameter : kParameters) {
    const double value = bar.*parameter.value;
    if (!std::isfinite(value))
      return Error{.what = std::string(parameter.name) + " is not a finite number",
                   .where = "four-bar linkage",
                   .fix = "give lengths in m and angles in rad"};
    if (parameter.link && value < kShortest_m)
      return Error{.what = std::string(parameter.name) + " is " + mm(value) + " mm, in " + links_in_words(bar),
                   .where = "four-bar linkage",
                   .fix = "make each link at least 0.1 mm long"};
  }
  if (bar.needle_m < 0.0 || bar.handle_m < 0.0)
    return Error{.what = "the needle is " + mm(bar.needle_m) + " mm and the handle " + mm(bar.handle_m) + " mm long",
                 .where = "four-bar linkage",
                 .fix = "give lengths of at least 0; turn theta or phi by pi to reverse a direction"};
  return {};
}

}  // namespace

GrashofClass grashof_class(const FourBar& bar) noexcept {
  const std::array<double, 4> links{bar.l4_m, bar.l1_m, bar.l2_m, bar.l3_m};
  const auto shortest = std::min_element(links.begin(), links.end());
  const double longest_m = *std::max_element(links.begin(), links.end());
  const double sum_m = links[0] + links[1] + links[2] + links[3];
  const double excess_m = 2.0 * (*shortest + longest_m) - sum_m;  // s + l - (p + q)
  if (std::abs(excess_m) <= kChangePointTolerance * sum_m) return GrashofClass::ChangePoint;
  if (excess_m > 0.0) return GrashofClass::TripleRocker;
  constexpr GrashofClass kByShortest[] = {GrashofClass::DoubleCrank, GrashofClass::CrankOfLink1,
                                          GrashofClass::DoubleRocker, GrashofClass::CrankOfLink3};
  return kByShortest[shortest - links.begin()];
}

std::string_view name(GrashofClass grashof) noexcept {
  switch (grashof) {
    case GrashofClass::DoubleCrank:
      return "double crank: links 1 and 3 turn fully";
    case GrashofClass::CrankOfLink1:
      return "crank-rocker: link 1 turns fully, link 3 rocks";
    case GrashofClass::CrankOfLink3:
      return "crank-rocker: link 3 turns fully, link 1 rocks";
    case GrashofClass::DoubleRocker:
      return "double rocker: links 1 and 3 rock";
    case GrashofClass::TripleRocker:
      return "triple rocker: no link turns fully";
    case GrashofClass::ChangePoint:
      return "change point: all joints can lie on one line";
  }
  return "";
}

Result<FourBar> checked(const FourBar& bar) {
  if (const Result<void> numbers = check_numbers(bar); !numbers) return numbers.error();
  const double longest_m = std::max({bar.l1_m, bar.l2_m, bar.l3_m, bar.l4_m});
  const double others_m = bar.l1_m + bar.l2_m + bar.l3_m + bar.l4_m - longest_m;
  if (longest_m >= others_m)
    return Error{.what = links_in_words(bar) + " cannot close: the longest is " + mm(longest_m) +
                         " mm, and the other three together are " + mm(others_m) + " mm",
                 .where = "four-bar linkage",
                 .fix = "make the longest link shorter than the sum of the other three"};
  if (lever_of(bar).length_m < kLeastLever_m)
    return Error{.what = "the handle ends " + mm(lever_of(bar).length_m) +
                         " mm from pivot O (h = " + mm(bar.handle_at_m) + ", l_h = " + mm(bar.handle_m) +
                         " mm, phi = " + number_text(bar.handle_rad) + " rad), so a hand cannot turn link 3",
                 .where = "four-bar linkage",
                 .fix = "change h, l_h or phi so that the handle ends at least 1 mm from O"};
  return bar;
}

Result<FourBar> checked_at(const FourBar& bar, double link3_rad) {
  Result<FourBar> good = checked(bar);
  if (!good) return good;
  if (!std::isfinite(link3_rad))
    return Error{.what = "the angle of link 3 is not a finite number", .where = "four-bar linkage", .fix = "give rad"};
  const CrankRange range = crank_range(bar, link3_rad);
  if (range.has(link3_rad)) return good;
  return Error{.what = links_in_words(bar) + " cannot close while link 3 has the angle " + number_text(link3_rad) +
                       " rad: link 3 turns from " + number_text(range.from_rad) + " to " + number_text(range.to_rad) +
                       " rad",
               .where = "four-bar linkage",
               .fix = "begin at an angle of this range, or change a length"};
}

}  // namespace telepalp::mechanism
