#include "haptic_station/tissue/fem/elastic_motion.h"

#include <numbers>

#include "tests/haptic_station/tissue/fem/prisms.h"

namespace telepalp::tissue {
namespace {

using Eigen::Vector3d;

constexpr double kSize_m = 0.1;
const PrismGrid kGrid{};

/// Deflection of a clamped beam per newton at its end: bending and shear (Timoshenko; Cowper's shear coefficient).
double beam_N_per_m(double young_Pa, double poisson, double side_m, double long_m) {
  const double area_m2 = side_m * side_m;
  const double shear = 10.0 * (1.0 + poisson) / (12.0 + 11.0 * poisson) * young_Pa / (2.0 * (1.0 + poisson)) * area_m2;
  return 1.0 / (std::pow(long_m, 3) / (3.0 * young_Pa * area_m2 * area_m2 / 12.0) + long_m / shear);
}

TEST(TopStiffness, IsThatOfABeamWithShear) {
  EXPECT_NEAR(stiffness_per_Pa(2, 10, ElementOrder::Quadratic, 0.3) / beam_N_per_m(1.0, 0.3, 0.02, 0.1), 1.0, 0.03);
  EXPECT_NEAR(stiffness_per_Pa(2, 10, ElementOrder::Quadratic, 0.0) / beam_N_per_m(1.0, 0.0, 0.02, 0.1), 1.0, 0.015);
}

TEST(TopStiffness, LinearTetrahedraLock) {
  const double right = stiffness_per_Pa(2, 10, ElementOrder::Quadratic, 0.45);
  EXPECT_GT(stiffness_per_Pa(2, 10, ElementOrder::Linear, 0.45), 2.5 * right);
}

TEST(PrismModel, ItsYoungsModulusGivesTheStiffnessThatIsAskedFor) {
  const auto model = make_prism_model({});
  ASSERT_TRUE(model.ok());
  EXPECT_NEAR(top_stiffness_N_per_m((*model)->body), 1400.0, 1e-6);
  EXPECT_NEAR((*model)->young_Pa, 34e6, 1e6);
}

TEST(PrismModel, RefusesNumbersOutOfRange) {
  const auto what = [](const PrismSettings& settings) {
    const auto model = make_prism_model(settings);
    return model.ok() ? std::string() : to_string(model.error());
  };
  EXPECT_NE(what({.poisson = 0.5}).find("poisson is 0.5"), std::string::npos);
  EXPECT_NE(what({.top_N_per_m = std::nan("")}).find("top_N_per_m is nan"), std::string::npos);
  EXPECT_NE(what({.grid = {.across = 5}}).find("across is 5"), std::string::npos);
  EXPECT_NE(what({.coupling_N_per_m = -1.0}).find("coupling_N_per_m"), std::string::npos);
  EXPECT_NE(what({.foot_m = {0, 99, 0}}).find("foot_m is 99"), std::string::npos);
}

TEST(Patch, IsAMeanOverItsSide) {
  const TetMesh mesh = *make_prism(kGrid);
  const auto body = rubber(kGrid);
  const Vector3d center_m(0.01, 0.06, 0.0);
  const Patch patch = patch_around(mesh, PrismSide::Right, center_m, 0.008);
  double sum = 0.0;
  for (const auto& [node, share] : patch.shares) sum += share;
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_LT((place_of(patch, body->rest()) - center_m).norm(), 3e-4) << "inside the side it is centred";
  EXPECT_NEAR(place_of(patch_around(mesh, PrismSide::Right, {0.01, 0.0, 0.0}, 0.008), body->rest()).x(), 0.01, 1e-12)
      << "with fixed nodes, too";
  EXPECT_LT((place_of(top_of(mesh), body->rest()) - Vector3d(0.0, 0.1, 0.0)).norm(), 1e-12);
}

TEST(ElasticMotion, ComesBackFromInvertedStates) {
  const auto body = rubber(kGrid);
  for (const auto& [name, at] : inverted_states(*body)) {
    ElasticMotion motion(body, 40.0);
    motion.put(at);
    settle(motion, 2.0);
    EXPECT_LE(away_m(motion), 1e-6 * kSize_m) << name;
  }
}

TEST(ElasticMotion, NeverGainsEnergyWhileItIsFree) {
  for (const double dt_s : {1.0 / 60.0, 0.002}) {
    ElasticMotion motion(rubber({.across = 1, .along = 3}), 0.0);
    motion.put(shaken(motion.body(), 0.01, 5));
    double before_J = motion.elastic_J();
    for (int i = 0; i < 100; ++i) {
      ASSERT_TRUE(motion.step(dt_s, nullptr).finite);
      const double now_J = motion.elastic_J() + motion.kinetic_J();
      ASSERT_LE(now_J, before_J * (1.0 + 1e-12) + 1e-15) << "step " << i;
      before_J = now_J;
    }
  }
}

/// The first bending mode of a clamped beam: 3.516 / L^2 sqrt(E I / (rho A)), Euler and Bernoulli; shear and rotary
/// inertia lower it by some percent at this slenderness.
TEST(ElasticMotion, SwingsAtTheFrequencyOfABeam) {
  constexpr double kStep_s = 2e-4;
  const auto body = rubber({.size_m = {0.01, 0.1, 0.01}, .across = 1, .along = 4}, 0.3, 1e8);
  ElasticMotion motion(body, 0.0);
  NodeField bent = body->rest();
  for (Eigen::Index i = 0; i < bent.cols(); ++i) bent(0, i) += 0.001 * std::pow(bent(1, i) / 0.1, 2);
  motion.put(bent);
  const Patch top = top_of(body->mesh());
  std::vector<double> crossings_s;
  double before_m = 0.001;
  for (int i = 1; i < 400; ++i) {
    (void)motion.step(kStep_s, nullptr);
    const double now_m = place_of(top, motion.at()).x();
    if (before_m > 0.0 && now_m <= 0.0) crossings_s.push_back(i * kStep_s);
    before_m = now_m;
  }
  ASSERT_GE(crossings_s.size(), 3U);
  const double period_s = (crossings_s.back() - crossings_s.front()) / static_cast<double>(crossings_s.size() - 1);
  const double beam_rad_per_s = 3.516 / 0.01 * std::sqrt(1e8 * 1e-8 / 12.0 / (1000.0 * 1e-4));
  EXPECT_NEAR(2.0 * std::numbers::pi / period_s / beam_rad_per_s, 1.0, 0.06);
}

TEST(ElasticMotion, HoldsAContactInEquilibrium) {
  const auto model = *make_prism_model({});
  ElasticMotion motion(model->body, 40.0);
  PatchContact contact{.patch = top_of(motion.body().mesh()),
                       .normal = Vector3d::UnitX(),
                       .limit_m = -0.0011,
                       .stiffness_N_per_m = 14000.0};
  for (int i = 0; i < 60; ++i) (void)motion.step(1.0 / 60.0, &contact);
  const double force_N = 14000.0 * contact.depth_m(motion.at());
  EXPECT_NEAR(force_N, 1400.0 * 0.001, 0.01) << "1.1 mm over the springs of 1400 and 14000 N/m in series";
  EXPECT_NEAR(1.0 / motion.compliance_m_per_N(contact.patch, contact.normal), 1400.0, 14.0);
}

TEST(ElasticMotion, ComplianceDoesNotDependOnTheStep) {
  for (const double dt_s : {1.0 / 60.0, 0.0005}) {
    ElasticMotion motion((*make_prism_model({}))->body, 40.0);
    motion.put(shaken(motion.body(), 1e-9, 2));
    (void)motion.step(dt_s, nullptr);
    EXPECT_NEAR(1.0 / motion.compliance_m_per_N(top_of(motion.body().mesh()), Vector3d::UnitX()), 1400.0, 0.1);
  }
}

TEST(ElasticMotion, ANodeThatIsNoNumberSetsItBackToRest) {
  ElasticMotion motion(rubber({.across = 1, .along = 1}), 0.0);
  NodeField bad = motion.body().rest();
  bad(0, 0) = std::nan("");
  motion.put(bad);
  EXPECT_FALSE(motion.step(1.0 / 60.0, nullptr).finite);
  EXPECT_EQ(away_m(motion), 0.0);
  EXPECT_TRUE(motion.step(1.0 / 60.0, nullptr).finite);
}

}  // namespace
}  // namespace telepalp::tissue
