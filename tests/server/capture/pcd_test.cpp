#include "server/capture/pcd/pinhole_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "support/models/lzf.h"
#include "where.h"

namespace telepalp::capture {
namespace {

const std::string kData = TELEPALP_SOURCE_DIR "/tests/data/pcd/";

using models::lzf_decompress;
using models::parse_pcd;

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span{text}); }

template <class T>
void append(std::string& to, T value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  to.append(bytes, sizeof value);
}

/// A 16 x 12 cloud of a tilted plane with colour, as each of PCD's three encodings. One point is not measured.
struct Point3 {
  float x, y, z;
  std::uint32_t argb;
};
std::vector<Point3> plane() {
  std::vector<Point3> points;
  for (int v = 0; v < 12; ++v)
    for (int u = 0; u < 16; ++u) {
      const float z = 1.0F + 0.01F * static_cast<float>(u);
      const float a = (static_cast<float>(u) - 7.5F) / 20.0F;
      const float b = (static_cast<float>(v) - 5.5F) / 21.0F;
      points.push_back({a * z, b * z, z, 0xFF000000U | static_cast<std::uint32_t>(u << 16 | v << 8 | 7)});
    }
  points[17].x = points[17].y = points[17].z = std::nanf("");
  return points;
}
std::string header(const std::string& data) {
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 16\nHEIGHT 12\n"
         "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 192\nDATA " +
         data + "\n";
}
std::string as_ascii() {
  std::string text = header("ascii");
  for (const Point3& p : plane()) {
    char line[128];
    std::snprintf(line, sizeof line, "%.9g %.9g %.9g %u\n", static_cast<double>(p.x), static_cast<double>(p.y),
                  static_cast<double>(p.z), p.argb);
    text += line;
  }
  return text;
}
std::string as_binary() {
  std::string text = header("binary");
  for (const Point3& p : plane()) append(text, p);
  return text;
}
/// LZF data of literals only, as for data without repetitions.
std::string as_compressed() {
  std::string fields;
  for (const Point3& p : plane()) append(fields, p.x);
  for (const Point3& p : plane()) append(fields, p.y);
  for (const Point3& p : plane()) append(fields, p.z);
  for (const Point3& p : plane()) append(fields, p.argb);
  std::string packed;
  for (std::size_t at = 0; at < fields.size(); at += 32) {
    packed += static_cast<char>(31);
    packed += fields.substr(at, 32);
  }
  std::string text = header("binary_compressed");
  append(text, static_cast<std::uint32_t>(packed.size()));
  append(text, static_cast<std::uint32_t>(fields.size()));
  return text + packed;
}

TEST(Pcd, SaysTheSameInAllThreeEncodings) {
  for (const std::string& text : {as_ascii(), as_binary(), as_compressed()}) {
    const auto cloud = parse_pcd(bytes_of(text), "plane.pcd");
    ASSERT_TRUE(cloud.ok()) << to_string(cloud.error());
    EXPECT_EQ(cloud->width, 16);
    ASSERT_EQ(cloud->points.size(), 192U);
    const std::vector<Point3> expected = plane();
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (i == 17) {
        EXPECT_TRUE(std::isnan(cloud->points[i].z()));
        continue;
      }
      EXPECT_EQ(cloud->points[i].x(), expected[i].x);
      EXPECT_EQ(cloud->points[i].z(), expected[i].z);
      EXPECT_EQ(cloud->colors[i][1], expected[i].argb >> 8U & 255U);
    }
  }
}

TEST(Pcd, TheCameraThatSawTheCloudIsFound) {
  const auto cloud = parse_pcd(bytes_of(as_binary()), "plane.pcd");
  ASSERT_TRUE(cloud.ok());
  const auto frame = frame_of(*cloud, "plane.pcd");
  ASSERT_TRUE(frame.ok()) << to_string(frame.error());
  EXPECT_TRUE(is_well_formed(*frame));
  EXPECT_NEAR(frame->camera.depth.fx, 20.0, 1e-3);
  EXPECT_NEAR(frame->camera.depth.fy, 21.0, 1e-3);
  EXPECT_NEAR(frame->camera.depth.cx, 7.5, 1e-3);
  EXPECT_NEAR(frame->depth.at(3, 0) * frame->depth.unit_m, 1.03, 0.00006);
  EXPECT_EQ(frame->depth.samples[17], 0);
}

TEST(Pcd, ReadsARealCompressedCloud) {
  const auto cloud = models::read_point_model(kData + "person.pcd");
  ASSERT_TRUE(cloud.ok()) << to_string(cloud.error());
  const auto frame = frame_of(*cloud, "person.pcd");
  ASSERT_TRUE(frame.ok()) << to_string(frame.error());
  EXPECT_NEAR(frame->camera.depth.fx, 525.0, 0.5);
  EXPECT_NEAR(frame->camera.depth.cx, 319.5, 0.5);
  EXPECT_NEAR(frame->camera.depth.cy, 239.5, 0.5);
  EXPECT_TRUE(frame->color.rgb.empty());
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

/// The frame that the source `pcd:` makes.
Result<RgbdFrame> frame_in(const std::string& text) {
  const auto cloud = parse_pcd(bytes_of(text), "bad.pcd");
  if (!cloud) return cloud.error();
  return frame_of(*cloud, "bad.pcd");
}

TEST(Pcd, EachFaultIsNamedWithAFix) {
  const std::pair<std::string, std::string> kBad[] = {
      {"hello", "is not a PCD file"},
      {"", "is not a PCD file"},
      {header("binary"), "ends after 0 of 192 points"},
      {as_binary().substr(0, as_binary().size() - 1), "ends after 191 of 192 points"},
      {as_compressed().substr(0, as_compressed().size() - 1), "compressed sizes"},
      {as_ascii().substr(0, as_ascii().size() / 2), "is missing or not a number"},
      {replaced(as_binary(), "WIDTH 16\nHEIGHT 12", "WIDTH 192\nHEIGHT 1"), "not organised"},
      {replaced(as_binary(), "WIDTH 16", "WIDTH 99999999"), "a value of WIDTH that is not allowed"},
      {replaced(as_binary(), "HEIGHT 12", "HEIGHT 1"), "disagree"},
      {replaced(as_binary(), "x y z", "a y z"), "all three fields x, y and z"},
      {replaced(as_binary(), "COUNT 1", "COUNT 9999999999"), "a value of COUNT that is not allowed"},
      {replaced(as_binary(), "DATA binary", "DATA zipped"), "DATA 'zipped'"},
      {"VERSION 0.7\nFIELDS x y z\n", "no DATA line"},
  };
  for (const auto& [text, says] : kBad) {
    const auto frame = frame_in(text);
    ASSERT_FALSE(frame.ok()) << says;
    EXPECT_NE(frame.error().what.find(says), std::string::npos) << frame.error().what;
    EXPECT_EQ(frame.error().where, "bad.pcd");
    EXPECT_FALSE(frame.error().fix.empty());
  }
  const auto unorganised = models::read_point_model(kData + "milk_color.pcd");
  ASSERT_TRUE(unorganised.ok());
  EXPECT_NE(to_string(frame_of(*unorganised, "milk_color.pcd").error()).find("not organised"), std::string::npos);
}

TEST(Pcd, ACloudThatWasMovedOrMirroredIsNoDepthImage) {
  auto moved = parse_pcd(bytes_of(as_binary()), "moved.pcd");
  ASSERT_TRUE(moved.ok());
  for (Eigen::Vector3f& point : moved->points) point.x() += 0.6F * point.y();
  EXPECT_FALSE(frame_of(*moved, "moved.pcd").ok());
  auto mirrored = parse_pcd(bytes_of(as_binary()), "mirrored.pcd");
  for (Eigen::Vector3f& point : mirrored->points) point.x() = -point.x();
  EXPECT_FALSE(frame_of(*mirrored, "mirrored.pcd").ok());
  auto empty = parse_pcd(bytes_of(as_binary()), "empty.pcd");
  for (Eigen::Vector3f& point : empty->points) point.z() = std::nanf("");
  EXPECT_FALSE(frame_of(*empty, "empty.pcd").ok());
}

TEST(Lzf, ExpandsLiteralsAndOverlappingReferences) {
  // "ab", then a reference two back and six long.
  const unsigned char packed[] = {1, 'a', 'b', 0x80, 1};
  std::string out(8, '?');
  ASSERT_TRUE(lzf_decompress(std::as_bytes(std::span{packed}), std::as_writable_bytes(std::span{out})));
  EXPECT_EQ(out, "abababab");
}

TEST(Lzf, RandomBytesNeitherCrashNorRunOver) {
  constexpr unsigned kSeed = 9;
  std::mt19937 random{kSeed};
  for (int i = 0; i < 5000; ++i) {
    std::string packed(random() % 40, '\0');
    for (char& byte : packed) byte = static_cast<char>(random());
    std::string out(random() % 300, '\0');
    (void)lzf_decompress(bytes_of(packed), std::as_writable_bytes(std::span{out}));
  }
  SUCCEED() << "seed " << kSeed;
}

}  // namespace
}  // namespace telepalp::capture
