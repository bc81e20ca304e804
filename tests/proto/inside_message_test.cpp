// Which images of an ultrasound probe and which structures inside the body a server takes.

#include "proto/wire/inside/inside_message.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace telepalp::wire {
namespace {

using namespace std::string_literals;

msg::UltrasoundImage good_image() {
  msg::UltrasoundImage image;
  image.set_on_skin(true);
  image.set_jpeg("\xff\xd8\xff and more"s);
  image.mutable_face_camera()->set_z(0.8);
  image.mutable_into_body_camera()->set_z(1.0);
  image.mutable_across_camera()->set_x(1.0);
  image.set_width_m(0.06);
  image.set_depth_m(0.1);
  return image;
}

msg::InnerStructures good_structures() {
  msg::InnerStructures inside;
  inside.mutable_haptic_origin_camera()->set_z(0.8);
  inside.mutable_camera_from_haptic()->set_w(1.0);
  msg::InnerStructure& structure = *inside.add_structures();
  structure.mutable_least();
  structure.set_step_m(1e-5);
  structure.set_points(std::string(3 * 6, '\x01'));
  structure.set_triangles("\0\0\1\0\2\0"s);
  return inside;
}

TEST(UltrasoundImage, ThatIsPossibleIsTaken) {
  EXPECT_TRUE(is_valid(good_image()));
  msg::UltrasoundImage in_the_air = good_image();
  in_the_air.set_on_skin(false);
  in_the_air.clear_jpeg();
  in_the_air.clear_face_camera();
  EXPECT_TRUE(is_valid(in_the_air));
}

TEST(UltrasoundImage, ThatIsImpossibleIsRefused) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<const char*, std::function<void(msg::UltrasoundImage&)>> kCases[] = {
      {"too large", [](auto& image) { image.set_jpeg("\xff\xd8\xff"s + std::string(kMaxUltrasoundBytes, 'x')); }},
      {"no JPEG", [](auto& image) { image.set_jpeg("\x89PNG"s); }},
      {"on the skin without image", [](auto& image) { image.clear_jpeg(); }},
      {"an image in the air", [](auto& image) { image.set_on_skin(false); }},
      {"no place", [](auto& image) { image.mutable_face_camera()->set_x(kNan); }},
      {"far away", [](auto& image) { image.mutable_face_camera()->set_x(11.0); }},
      {"no direction", [](auto& image) { image.clear_into_body_camera(); }},
      {"a direction of length 2", [](auto& image) { image.mutable_across_camera()->set_x(2.0); }},
      {"no depth", [](auto& image) { image.set_depth_m(0.0); }},
      {"infinitely wide", [](auto& image) { image.set_width_m(std::numeric_limits<double>::infinity()); }},
  };
  for (const auto& [name, spoil] : kCases) {
    msg::UltrasoundImage image = good_image();
    spoil(image);
    EXPECT_FALSE(is_valid(image)) << name;
  }
}

TEST(InnerStructuresMessage, ThatIsPossibleIsTaken) {
  EXPECT_TRUE(is_valid(good_structures()));
  EXPECT_TRUE(is_valid(msg::InnerStructures())) << "a scene without layers";
}

TEST(InnerStructuresMessage, ThatIsImpossibleIsRefused) {
  const std::pair<const char*, std::function<void(msg::InnerStructures&)>> kCases[] = {
      {"a triangle names a point that is missing",
       [](auto& inside) { inside.mutable_structures(0)->set_triangles("\0\0\1\0\3\0"s); }},
      {"half a triangle", [](auto& inside) { inside.mutable_structures(0)->set_triangles("\0\0\1\0"s); }},
      {"half a point", [](auto& inside) { inside.mutable_structures(0)->set_points("1234567"); }},
      {"too many points",
       [](auto& inside) { inside.mutable_structures(0)->set_points(std::string(6 * (kMostStructurePoints + 1), 0)); }},
      {"larger than a room", [](auto& inside) { inside.mutable_structures(0)->set_step_m(1.0); }},
      {"no step", [](auto& inside) { inside.mutable_structures(0)->set_step_m(std::nan("")); }},
      {"nine structures",
       [](auto& inside) {
         for (int i = 0; i < 8; ++i) *inside.add_structures() = inside.structures(0);
       }},
      {"no attitude", [](auto& inside) { inside.clear_camera_from_haptic(); }},
      {"no place", [](auto& inside) { inside.mutable_haptic_origin_camera()->set_y(std::nan("")); }},
  };
  for (const auto& [name, spoil] : kCases) {
    msg::InnerStructures inside = good_structures();
    spoil(inside);
    EXPECT_FALSE(is_valid(inside)) << name;
  }
}

}  // namespace
}  // namespace telepalp::wire
