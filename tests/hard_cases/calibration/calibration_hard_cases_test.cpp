#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "haptic_station/calibration/point_registration.h"

namespace telepalp::calibration {
namespace {

using Eigen::Vector3d;

const Eigen::Isometry3d kTruth =
    Eigen::Translation3d(0.2, -0.1, 0.4) * Eigen::AngleAxisd(1.1, Vector3d(1, 2, -1).normalized());
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const std::vector<Vector3d> kTetrahedron{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};

struct Case {
  std::string name;
  std::vector<Vector3d> from;
  std::string says;  ///< text of the expected error; empty: calibration must succeed
  std::string rank = {};
  Eigen::Matrix3d distort = Eigen::Matrix3d::Identity();  ///< applied to `to`
  void (*spoil)(std::vector<PointPair>&) = [](std::vector<PointPair>&) {};
};

std::vector<PointPair> pairs_of(const Case& c) {
  std::vector<PointPair> pairs;
  for (const Vector3d& p : c.from) pairs.push_back({static_cast<int>(pairs.size()), c.distort * (kTruth * p), p});
  c.spoil(pairs);
  return pairs;
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

/// Row 31 of the hard cases: prints a table of its own, grep '^|'.
class CalibrationHardCase : public testing::TestWithParam<Case> {
 protected:
  static void SetUpTestSuite() { std::puts("| 31 calibration from | must | got |\n| --- | --- | --- |"); }
  static void print(const Case& c, const Result<Registration>& fit) {
    const std::string must = c.says.empty() ? "the truth" : "refused: " + c.says;
    std::printf("| %-36s | %-36s | %s |\n", c.name.c_str(), must.c_str(), fit ? "the truth" : fit.error().what.c_str());
  }
};

TEST_P(CalibrationHardCase, IsCalibratedCorrectlyOrRefusedWithAReason) {
  const Case& c = GetParam();
  const Result<Registration> fit = register_points(pairs_of(c));
  print(c, fit);
  if (c.says.empty()) {
    ASSERT_TRUE(fit) << to_string(fit.error());
    EXPECT_LT((fit->to_from_from.matrix() - kTruth.matrix()).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_NEAR(fit->to_from_from.linear().determinant(), 1.0, 1e-12);
    return;
  }
  ASSERT_FALSE(fit);
  const std::string text = to_string(fit.error());
  EXPECT_NE(text.find(c.says), std::string::npos) << text;
  EXPECT_NE(text.find(c.rank), std::string::npos) << text;
  EXPECT_FALSE(fit.error().fix.empty());
}

std::string name_of(const testing::TestParamInfo<Case>& one) {
  std::string name = one.param.name;
  for (char& letter : name)
    if (!isalnum(static_cast<unsigned char>(letter))) letter = '_';
  return name;
}

const Eigen::Matrix3d kMirrorX = Vector3d(-1, 1, 1).asDiagonal();

INSTANTIATE_TEST_SUITE_P(
    Table, CalibrationHardCase,
    testing::Values(
        Case{"none", {}, "0 different places", "rank 0"}, Case{"one", {{0, 0, 0}}, "1 different place is", "rank 0"},
        Case{"two", {{0, 0, 0}, {0.1, 0, 0}}, "2 different places", "rank 1"},
        Case{"one place many times", {4, Vector3d(0.1, 0.2, 0.3)}, "lie at one point", "rank 0"},
        Case{"collinear",
             {{0, 0, 0}, {0.1, 0.1, 0}, {0.2, 0.2, 0}, {0.3, 0.3, 0}},
             "lie on a line (rank 1",
             "beside the line"},
        Case{"collinear but for a millimetre",
             {{0, 0, 0}, {0.1, 0.001, 0}, {0.2, 0, 0.001}, {0.3, 0.001, 0}},
             "lie on a line (rank 1",
             "beside the line"},
        Case{"all within a millimetre",
             {{0, 0, 0}, {0.001, 0, 0}, {0, 0.001, 0}, {0, 0, 0.001}},
             "lie at one point (rank 0",
             "spread"},
        Case{"mirrored", kTetrahedron, "mirror image", "rank 3", kMirrorX},
        Case{"all axes reversed", kTetrahedron, "mirror image", "rank 3", -Eigen::Matrix3d::Identity()},
        Case{"millimetres against metres", kTetrahedron, "the standard deviation of the places is", "metres",
             8.0 * Eigen::Matrix3d::Identity()},
        Case{"not a number", kTetrahedron, "pair 2 is not finite", "", Eigen::Matrix3d::Identity(),
             [](std::vector<PointPair>& p) { p[1].from.y() = kNaN; }},
        Case{"infinite", kTetrahedron, "pair 3 is not finite", "", Eigen::Matrix3d::Identity(),
             [](std::vector<PointPair>& p) { p[2].to.z() = std::numeric_limits<double>::infinity(); }},
        Case{"huge", kTetrahedron, "a coordinate beyond 10 m", "", Eigen::Matrix3d::Identity(),
             [](std::vector<PointPair>& p) { p[0].to.x() = 1e300; }},
        Case{"two places exchanged", kTetrahedron, "", "", Eigen::Matrix3d::Identity(),
             [](std::vector<PointPair>& p) {
               std::swap(p[1], p[2]);  // swaps whole pairs, because their order does not matter
             }},
        Case{"one column shifted by a row",
             {{0, 0, 0}, {0.3, 0, 0}, {0, 0.2, 0}, {0, 0, 0.1}, {0.3, 0.2, 0.1}},
             "do not match",
             "worst is pair",
             Eigen::Matrix3d::Identity(),
             [](std::vector<PointPair>& p) {
               const Vector3d first = p.front().to;
               for (std::size_t i = 0; i + 1 < p.size(); ++i) p[i].to = p[i + 1].to;
               p.back().to = first;
             }},
        Case{"coplanar", {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0.1, 0.1, 0}}, ""},
        Case{"three, not on a line", {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}, ""},
        Case{"a cube, all widths equal",
             {{0, 0, 0}, {.1, 0, 0}, {0, .1, 0}, {0, 0, .1}, {.1, .1, 0}, {.1, 0, .1}, {0, .1, .1}, {.1, .1, .1}},
             ""},
        Case{"far from the origin", {{9, 9, 9}, {9.1, 9, 9}, {9, 9.1, 9}, {9, 9, 9.1}}, "a coordinate beyond 10 m"},
        Case{"five metres from the origin", {{5, 5, 5}, {5.1, 5, 5}, {5, 5.1, 5}, {5, 5, 5.1}}, ""}),
    name_of);

}  // namespace
}  // namespace telepalp::calibration
