#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "server/capture/synthetic/shape/mesh.h"

namespace telepalp::capture {
namespace {

Result<TriangleMesh> parsed(const std::string& text, const std::string& name) {
  Result<models::PointModel> model = models::parse_ply(std::as_bytes(std::span{text}), name);
  if (!model) return model.error();
  return mesh_of(std::move(model).value(), name);
}

const std::string kSquare =
    "ply\nformat ascii 1.0\ncomment a unit square\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nproperty uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 9\n1 0 0 9\n1 1 0 9\n0 1 0 9\n4 0 1 2 3\n";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(Mesh, APolygonBecomesAFanAndOtherPropertiesAreSkipped) {
  const auto mesh = parsed(kSquare, "square.ply");
  ASSERT_TRUE(mesh.ok()) << to_string(mesh.error());
  ASSERT_EQ(mesh->vertices.size(), 4u);
  ASSERT_EQ(mesh->triangles.size(), 2u);
  EXPECT_EQ(mesh->triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
  for (const Eigen::Vector3f& normal : vertex_normals(*mesh)) EXPECT_EQ(normal, Eigen::Vector3f::UnitZ());
}

TEST(Mesh, EachFaultIsNamedWithAFix) {
  const std::pair<std::string, std::string> kBad[] = {
      {"", "is not a PLY file"},
      {"solid", "is not a PLY file"},
      {"ply\nformat ascii 1.0\n", "no line end_header"},
      {replaced(kSquare, "format ascii", "format binary_big_endian"), "binary_big_endian"},
      {replaced(kSquare, "element vertex 4", "element vertex four"),
       "declares a number of elements of the kind 'vertex'"},
      {replaced(kSquare, "element vertex 4", "element vertex 4000000000"),
       "declares a number of elements of the kind 'vertex'"},
      {replaced(kSquare, "element face 1", "element face 9999"), "declares a number of elements of the kind 'face'"},
      {replaced(kSquare, "element face 1", "element face 2"), "face 1"},
      {replaced(kSquare, "element face 1", "element vertex 1\nproperty float nx\nelement face 1"),
       "two elements called"},
      {replaced(kSquare, "4 0 1 2 3", "4 0 1 2 7"), "has 4 vertices, but a face names vertex 7"},
      {replaced(kSquare, "4 0 1 2 3", "4 0 1 2 -1"), "names vertex"},
      {replaced(kSquare, "4 0 1 2 3", "2000 0 1 2"), "the list of face 0"},
      {replaced(kSquare, "1 1 0 9", "1 nan 0 9"), "not a finite number"},
      {replaced(kSquare, "4 0 1 2 3", "2 0 1 2 3"), "no triangles"},
  };
  for (const auto& [text, says] : kBad) {
    const auto mesh = parsed(text, "bad.ply");
    ASSERT_FALSE(mesh.ok()) << says;
    EXPECT_NE(mesh.error().what.find(says), std::string::npos) << mesh.error().what;
    EXPECT_EQ(mesh.error().where, "bad.ply");
    EXPECT_FALSE(mesh.error().fix.empty());
  }
}

TEST(Mesh, FlippedBytesNeverCrash) {
  constexpr unsigned kSeed = 4;
  std::mt19937 random{kSeed};
  for (int i = 0; i < 3000; ++i) {
    std::string text = kSquare;
    if (i % 2 == 0) text = replaced(text, "ascii", "binary_little_endian");
    for (int k = 0; k < 3; ++k) text[random() % text.size()] = static_cast<char>(random());
    (void)parsed(text, "flipped.ply");
  }
  SUCCEED() << "seed " << kSeed;
}

}  // namespace
}  // namespace telepalp::capture
