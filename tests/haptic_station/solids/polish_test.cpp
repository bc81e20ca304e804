#include "haptic_station/solids/polish.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <fstream>
#include <locale>
#include <numbers>

#include "haptic_station/solids/solid_tree.h"
#include "tests/haptic_station/solids/random_solid.h"

namespace telepalp::solids {
namespace {

/// S2 III.A as printed, with the second operand of the last union in place of the paper's dots.
constexpr const char* kPrinted =
    "tr 0.5 0.35 0.015 tx -0.6 -0.3 -0.06 -30 0 0 1 + tr -0.03 0.0 0.0 torusx 0.182 0.009 + tr -0.01 0.0 0.0 "
    "torusx 0.184 0.01 tr 0.01 0.0 0.0 torusx 0.186 0.01";

TEST(Polish, ReadsThePapersRibsAsPrinted) {
  const Result<Solid> solid = parse_polish(kPrinted, "paper");
  ASSERT_TRUE(solid.ok()) << to_string(solid.error());
  const auto tree = build_tree(*solid);
  ASSERT_TRUE(tree.ok());
  EXPECT_EQ((*tree)->shapes, 3U);
  // The first rib's uppermost point: about x after -30 degrees about z, then both shifts.
  const Eigen::Vector3d local(-0.03, 0.182 + 0.009, 0.0);
  const Eigen::Vector3d turned = Eigen::AngleAxisd(-std::numbers::pi / 6.0, Eigen::Vector3d::UnitZ()) * local;
  const Eigen::Vector3d top = turned + Eigen::Vector3d(-0.6, -0.3, -0.06) + Eigen::Vector3d(0.5, 0.35, 0.015);
  EXPECT_NEAR(solid_at(**tree, top).m, 0.0, 1e-12);
}

TEST(Polish, WritesWhatItReads) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomSolid random(seed);
    const auto solid = parse_polish(random.tree(static_cast<int>(seed % 6)), "random");
    ASSERT_TRUE(solid.ok());
    const auto again = parse_polish(to_polish(*solid), "again");
    ASSERT_TRUE(again.ok()) << to_string(again.error());
    ASSERT_EQ(*solid, *again) << "seed " << seed;
  }
}

TEST(Polish, ReadsARigidMatrixAsATurnAndAScale) {
  const auto solid = parse_polish("tm 0 -2 0 1  2 0 0 2  0 0 2 3 box 0.1 0.2 0.3", "matrix");
  ASSERT_TRUE(solid.ok()) << to_string(solid.error());
  const auto tree = build_tree(*solid);
  // The box's +y face, at 0.2, is turned to -x and lies twice as far out.
  EXPECT_NEAR(solid_at(**tree, {1.0 - 0.5, 2.0, 3.0}).m, 0.1, 1e-12);
}

struct Refusal {
  const char* name;
  std::string text;
  const char* where;
  const char* what;
};

std::string repeated(const std::string& word, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += word;
  return text;
}

TEST(Polish, SaysWhereAndWhatItExpected) {
  const Refusal kRefusals[] = {
      {"unknown word", "+ sphere 1\n  orb 2", "f:2:3", "expected the solid that is operand 2 of +, found 'orb'"},
      {"nothing", "", "f:1:1", "expected a solid, found the end of the text"},
      {"missing operand", "+ sphere 0.1", "f:1:13", "expected the solid that is operand 2 of +"},
      {"missing number", "torusx 0.1 + sphere 1 sphere 1", "f:1:12", "expected tube_radius_m of torusx, found '+'"},
      {"negative radius", "sphere -0.1", "f:1:8", "radius_m of sphere is -0.1"},
      {"no radius", "capsule 0 0 0 0 0 0 0", "f:1:21", "radius_m of capsule is 0"},
      {"not a number", "sphere nan", "f:1:8", "radius_m of sphere is nan"},
      {"infinite", "tr inf 0 0 sphere 1", "f:1:4", "x_m of tr is inf"},
      {"overflow", "sphere 1e999", "f:1:8", "expected radius_m of sphere, found '1e999'"},
      {"decimal comma", "sphere 0,1", "f:1:8", "found '0,1'"},
      {"no axis", "ro 30 0 0 0 sphere 1", "f:1:7", "the direction of ro is zero"},
      {"arc backwards", "arcx 0.1 0.01 90 30", "f:1:18", "arcx goes from 90 to 30 deg"},
      {"scale by axis", "sc 1 2 1 sphere 1", "f:1:6", "found '2'"},
      {"shear", "tm 1 0.5 0 0  0 1 0 0  0 0 1 0 sphere 1", "f:1:1", "shears, mirrors"},
      {"mirror", "tm -1 0 0 0  0 1 0 0  0 0 1 0 sphere 1", "f:1:1", "shears, mirrors"},
      {"two solids", "sphere 1\nsphere 1", "f:2:1", "found 'sphere' after the end of the solid"},
      {"the paper's dots", "+ sphere 1 ...", "f:1:12", "found '...'"},
      {"a mesh without reader", "mesh liver.ply 1 0.004", "f:1:1",
       "liver.ply: the solid's Polish notation names this mesh file, but only shapes are accepted here"},
      {"deep nesting", repeated("tr 0 0 0 ", 100'000) + "sphere 1", "f:1:910", "nest deeper than 100"},
      {"too many words", repeated("+ sphere 1 ", 110'000) + "sphere 1", "f:1:1100001",
       "more than 200000 shapes and operators"},
      {"too long", std::string((4 << 20) + 1, ' '), "f", "larger than 4 MiB"},
  };
  for (const Refusal& refusal : kRefusals) {
    const auto solid = parse_polish(refusal.text, "f");
    ASSERT_FALSE(solid.ok()) << refusal.name;
    EXPECT_EQ(solid.error().where, refusal.where) << refusal.name;
    EXPECT_NE(solid.error().what.find(refusal.what), std::string::npos) << refusal.name << ": " << solid.error().what;
    EXPECT_FALSE(solid.error().fix.empty()) << refusal.name;
  }
}

/// The punctuation of a locale that writes 0,5.
struct DecimalComma : std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
};

TEST(Polish, ReadsAndWritesADecimalPointInEveryLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  const auto solid = parse_polish("tr 0.5 -0.25 0 sphere 0.125", "f");
  const std::string text = solid ? to_polish(*solid) : "";
  std::locale::global(before);
  ASSERT_TRUE(solid.ok()) << to_string(solid.error());
  EXPECT_EQ((*solid)[0].numbers[0], 0.5);
  EXPECT_EQ(text, "tr 0.5 -0.25 0 sphere 0.125");
}

TEST(Polish, RefusesAHugeFileBeforeReadingIt) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "huge.solid";
  std::ofstream(file).put(' ');
  std::filesystem::resize_file(file, std::uintmax_t{1} << 30);  // sparse: takes no room on the disk
  const auto solid = read_polish(file);
  std::filesystem::remove(file);
  ASSERT_FALSE(solid.ok());
  EXPECT_NE(solid.error().what.find("larger than 4 MiB"), std::string::npos);
}

TEST(Polish, AChainOfUnionsDoesNotNest) {
  const auto solid = parse_polish(repeated("+ sphere 1 ", 50'000) + "sphere 1", "chain");
  ASSERT_TRUE(solid.ok()) << to_string(solid.error());
  EXPECT_TRUE(build_tree(*solid).ok());
}

}  // namespace
}  // namespace telepalp::solids
