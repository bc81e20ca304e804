#include <gtest/gtest.h>

#include <limits>

#include "haptic_station/tissue/mesh/surface_mesh.h"
#include "tests/haptic_station/tissue/needle_paths.h"

namespace telepalp::tissue {
namespace {

template <class Change>
std::string refusal(const Change& change) {
  TissueSettings tissue = three_layers();
  change(tissue);
  const auto made = make_tissue(tissue);
  return made ? "made" : to_string(made.error());
}

TEST(MakeTissue, SaysWhichLayerIsWrongAndHowToFixIt) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([&](TissueSettings& t) { t.layers[0].surface->punctures_at_N = 0.0; }),
            "tissue layer \"skin\": punctures_at_N is 0 N. fix: give 0.01 to 1e+09 N");
  EXPECT_EQ(refusal([&](TissueSettings& t) { t.layers[1].bulk->stick_N_per_m = nan; }),
            "tissue layer \"muscle\": stick_N_per_m is nan N/m. fix: give 10 to 20000 N/m");
  EXPECT_EQ(refusal([&](TissueSettings& t) { t.layers[2].top_m = 0.02; }),
            "tissue layer \"sac\": the layer begins above the end of the layer \"muscle\". fix: list layers from the "
            "outside in, and let top_m be at least top_m + thickness_m of the one before");
  EXPECT_EQ(refusal([&](TissueSettings& t) { t.layers.clear(); }),
            "tissue: the tissue has no layer. fix: give at least one layer");
  EXPECT_EQ(refusal([&](TissueSettings& t) { t.layers[1].bulk.reset(); }),
            "tissue layer \"muscle\": the layer has neither a surface nor a bulk. fix: give one of them");
  EXPECT_EQ(refusal([&](TissueSettings& t) { t.layers[2].relaxation.share[0] = 0.9; }),
            "tissue layer \"sac\": the shares of relaxation sum to more than 1. fix: let them sum to at most 1");
  EXPECT_EQ(refusal([](TissueSettings&) {}), "made");
}

TEST(MakeTissue, ABadMeshIsRefused) {
  const std::vector<Eigen::Vector3d> four{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}};
  const auto refusal_of = [&](std::vector<Triangle> triangles) {
    const auto mesh = make_mesh(four, std::move(triangles));
    return mesh ? "made" : mesh.error().what;
  };
  EXPECT_EQ(refusal_of({{0, 2, 1}, {1, 2, 3}}), "made");
  EXPECT_EQ(refusal_of({{0, 2, 1}, {0, 2, 3}}), "triangle 1 and triangle 0 pass the same edge in the same direction");
  EXPECT_EQ(refusal_of({{0, 2, 1}, {1, 2, 3}, {2, 1, 3}}).substr(0, 10), "triangle 2");
  EXPECT_EQ(refusal_of({{0, 2, 9}}), "triangle 0 has the corner 9, which does not exist");
  EXPECT_EQ(refusal_of({{0, 0, 1}}), "triangle 0 has no area");
  EXPECT_EQ(refusal_of({}), "the mesh has no triangle");
}

}  // namespace
}  // namespace telepalp::tissue
