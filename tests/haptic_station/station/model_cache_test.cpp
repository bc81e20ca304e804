#include "haptic_station/station/rigs/model_cache.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "tests/support/child_process.h"

namespace telepalp::station {
namespace {

namespace fs = std::filesystem;

/// Writes a dome of 40 x 40 vertices, 0.2 m wide, as an OBJ file.
void write_dome(const fs::path& file, double height_m) {
  std::ofstream out(file);
  constexpr int kSide = 40;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const double x = 0.2 * i / (kSide - 1) - 0.1, z = 0.2 * j / (kSide - 1) - 0.1;
      out << "v " << x << " " << height_m * std::cos(10.0 * x) * std::cos(10.0 * z) << " " << z << "\n";
    }
  for (int i = 1; i < kSide; ++i)
    for (int j = 1; j < kSide; ++j) {
      const int at = i * kSide + j + 1;
      out << "f " << at - kSide - 1 << " " << at - kSide << " " << at << "\n"
          << "f " << at - kSide - 1 << " " << at << " " << at - 1 << "\n";
    }
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class ModelCacheTest : public testing::Test {
 protected:
  ModelCacheTest() { write_dome(model(), 0.03); }

  [[nodiscard]] fs::path model() const { return folder_.path() / "dome.obj"; }
  [[nodiscard]] fs::path cached() const { return cache_.file_of(*cache_.key_of(model(), settings_)); }
  surface::StaticModel sampled() {
    said_.clear();
    Result<surface::StaticModel> made = sampled_once(model(), settings_, cache_);
    EXPECT_TRUE(made.ok()) << to_string(made.error());
    return made ? *made : surface::StaticModel{};
  }
  [[nodiscard]] bool said(const std::string& phrase) const { return said_.find(phrase) != std::string::npos; }

  support::TemporaryFolder folder_;
  ModelCache cache_{folder_.path() / "cache"};
  std::string said_;
  surface::StaticModelSettings settings_{
      .samples = 2000, .anyway = true, .on_progress = [this](const std::string& line) { said_ += line + "\n"; }};
};

void expect_equal(const surface::StaticModel& one, const surface::StaticModel& other) {
  ASSERT_TRUE(one.snapshot && other.snapshot);
  EXPECT_EQ(one.remarks, other.remarks);
  EXPECT_EQ(one.sampling, other.sampling);
  EXPECT_EQ(one.snapshot->shape().origin_m, other.snapshot->shape().origin_m);
  EXPECT_EQ(one.snapshot->shape().support_m, other.snapshot->shape().support_m);
  const auto& a = one.snapshot->cloud();
  const auto& b = other.snapshot->cloud();
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(static_cast<const void*>(a.data()), static_cast<const void*>(b.data()), a.size() * sizeof a[0]),
            0);
}

TEST_F(ModelCacheTest, TheSecondStartReadsTheSamePointsFromTheCache) {
  const surface::StaticModel first = sampled();
  EXPECT_TRUE(said("spreading 2000 points")) << said_;
  EXPECT_TRUE(said("kept for the next start in " + cached().string())) << said_;
  const surface::StaticModel second = sampled();
  EXPECT_TRUE(said("is read from the cache")) << said_;
  EXPECT_FALSE(said("spreading")) << said_;
  expect_equal(first, second);
}

TEST_F(ModelCacheTest, AnotherShapeOrAnotherSettingIsSampledAnew) {
  (void)sampled();
  const std::string key = *cache_.key_of(model(), settings_);
  write_dome(model(), 0.031);
  EXPECT_NE(*cache_.key_of(model(), settings_), key);
  write_dome(model(), 0.03);
  EXPECT_EQ(*cache_.key_of(model(), settings_), key);
  const auto with = [&](auto change) {
    surface::StaticModelSettings other = settings_;
    change(other);
    return *cache_.key_of(model(), other);
  };
  EXPECT_NE(with([](auto& s) { s.unit_m = 1.001; }), key);
  EXPECT_NE(with([](auto& s) { s.samples = 2001; }), key);
  EXPECT_NE(with([](auto& s) { s.spacing_m = 0.01; }), key);
  EXPECT_NE(with([](auto& s) { s.anyway = false; }), key);
  EXPECT_NE(with([](auto& s) { s.seed = 2; }), key);
  EXPECT_NE(with([](auto& s) { s.normal_neighbors = 17; }), key);
  EXPECT_NE(with([](auto& s) { s.viewpoint_m.z() = 1.0; }), key);
  EXPECT_NE(with([](auto& s) { s.support_m = 0.01; }), key);
  EXPECT_NE(with([](auto& s) { s.flip_normals = true; }), key);
}

TEST_F(ModelCacheTest, ADamagedFileOfTheCacheIsNamedAndMadeAgain) {
  const surface::StaticModel first = sampled();
  const std::string whole = bytes_of(cached());
  for (const double share : {0.0, 0.0002, 0.001, 0.01, 0.5, 0.999}) {
    const auto at = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x10);
    for (const std::string& damaged : {flipped, whole.substr(0, at)}) {
      std::ofstream(cached(), std::ios::binary) << damaged;
      const surface::StaticModel again = sampled();
      EXPECT_TRUE(said(cached().string() + ": the cached sampling is damaged. fix: it is made again")) << at << said_;
      expect_equal(first, again);
      EXPECT_EQ(bytes_of(cached()), whole) << at;
    }
  }
}

TEST_F(ModelCacheTest, KeepsTheTwentySamplingsThatWereUsedLast) {
  const surface::StaticModel model = sampled();
  const fs::path oldest = cached();
  fs::last_write_time(oldest, fs::file_time_type::clock::now() - std::chrono::hours(1));
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(cache_.keep("key" + std::to_string(i), model).ok());
  EXPECT_FALSE(fs::exists(oldest));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path() / "cache"), {}), 20);
}

TEST_F(ModelCacheTest, WithoutAFolderThatCanBeWrittenTheModelIsTouchedAndTheReasonIsSaid) {
  std::ofstream(folder_.path() / "cache") << "a file where the folder should be";
  (void)sampled();
  EXPECT_TRUE(said("its sampling cannot be kept")) << said_;
  cache_ = ModelCache({});
  (void)sampled();
  EXPECT_FALSE(said("cannot be kept")) << said_;
}

}  // namespace
}  // namespace telepalp::station
