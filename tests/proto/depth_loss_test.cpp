#include "proto/wire/depth_loss.h"

#include <gtest/gtest.h>

#include <limits>

namespace telepalp::wire {
namespace {

msg::DepthImage image_of(const std::string& format) {
  msg::DepthImage image;
  image.set_format(format);
  return image;
}

msg::DepthImage bounded_image(double least_m, double per_m) {
  msg::DepthImage image = image_of("bounded");
  image.mutable_bound()->set_least_m(least_m);
  image.mutable_bound()->set_per_m(per_m);
  return image;
}

TEST(DepthFidelity, DepthWithoutLossIsAsMeasured) {
  for (const std::string mode : {"fast", "intra", "temporal"}) {
    const DepthFidelity fidelity = depth_fidelity(image_of(mode));
    EXPECT_FALSE(fidelity.moved);
    EXPECT_EQ(in_words(fidelity), mode + ", lossless");
  }
}

TEST(DepthFidelity, BoundedDepthStatesItsBound) {
  EXPECT_EQ(in_words(depth_fidelity(bounded_image(0.001, 0.00285))), "bounded, off by up to 2.85 mm at 1 m");
  EXPECT_EQ(how_far(depth_fidelity(bounded_image(0.004, 0.00285))), "off by up to 4 mm at 1 m") << "the larger counts";
}

TEST(DepthFidelity, AnAbsurdBoundCountsAsUnknown) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double absurd : {nan, infinite, -0.001, 1.5})
    for (const msg::DepthImage& image : {bounded_image(absurd, 0.003), bounded_image(0.001, absurd)}) {
      const DepthFidelity fidelity = depth_fidelity(image);
      EXPECT_TRUE(fidelity.moved);
      EXPECT_FALSE(fidelity.within);
      EXPECT_EQ(in_words(fidelity), "bounded, off by an unknown amount");
    }
}

TEST(DepthFidelity, NearLosslessDepthWithoutABoundIsNotAsMeasured) {
  EXPECT_EQ(in_words(depth_fidelity(image_of("bounded"))), "bounded, off by an unknown amount");
  EXPECT_EQ(in_words(depth_fidelity(image_of(""))), "not stated");
}

TEST(DepthFidelity, LosslessCodingOfNearLosslessDepthIsNotAsMeasured) {
  msg::DepthImage image = bounded_image(0.001, 0.00285);
  image.set_format("fast");
  EXPECT_EQ(in_words(depth_fidelity(image)), "fast, off by up to 2.85 mm at 1 m");
  EXPECT_EQ(loss_of(depth_fidelity(image))->per_m, 0.00285);
  image.clear_bound();
  EXPECT_FALSE(loss_of(depth_fidelity(image)));
}

TEST(DepthFidelity, ALongNameOfAModeIsShortened) {
  EXPECT_EQ(depth_fidelity(image_of(std::string(100'000, 'x'))).mode.size(), 32u);
}

TEST(DepthFidelity, OfSeveralTheLeastExactIsTheOneThatCounts) {
  const DepthFidelity silent = depth_fidelity(image_of(""));
  const DepthFidelity exact = depth_fidelity(image_of("fast"));
  const DepthFidelity close = depth_fidelity(bounded_image(0.001, 0.001));
  const DepthFidelity coarse = depth_fidelity(bounded_image(0.001, 0.004));
  const DepthFidelity unknown = depth_fidelity(image_of("bounded"));
  const DepthFidelity in_order[] = {silent, exact, close, coarse, unknown};
  for (std::size_t i = 0; i + 1 < std::size(in_order); ++i) {
    const std::string wanted = in_words(in_order[i + 1]);
    EXPECT_EQ(in_words(less_exact(in_order[i], in_order[i + 1])), wanted);
    EXPECT_EQ(in_words(less_exact(in_order[i + 1], in_order[i])), wanted);
  }
  EXPECT_EQ(less_exact(exact, depth_fidelity(image_of("temporal"))).mode, "temporal");
}

TEST(DepthFidelity, TheStationReportsTheFidelityOfTheImage) {
  msg::SurfaceReport report;
  report.set_depth_mode("bounded");
  *report.mutable_depth_bound() = bounded_image(0.001, 0.00285).bound();
  EXPECT_EQ(in_words(depth_fidelity(report)), "bounded, off by up to 2.85 mm at 1 m");
}

}  // namespace
}  // namespace telepalp::wire
