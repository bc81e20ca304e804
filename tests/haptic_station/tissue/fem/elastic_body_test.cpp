#include "haptic_station/tissue/fem/elastic_body.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "haptic_station/tissue/fem/corotated.h"
#include "tests/haptic_station/tissue/fem/prisms.h"

namespace telepalp::tissue {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr Lame kMaterial = lame(1.0, 0.45);

Matrix3d random_matrix(device::Random& random, double size) {
  Matrix3d matrix;
  for (int i = 0; i < 9; ++i) matrix.data()[i] = random.uniform(-size, size);
  return matrix;
}

/// Stretched, sheared, compressed and inverted.
Matrix3d deformation(device::Random& random) {
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1))
          .normalized();
  Vector3d stretch(random.uniform(0.3, 1.8), random.uniform(0.3, 1.8), random.uniform(0.3, 1.8));
  if (random.uniform() < 0.3) stretch.z() *= -0.5;
  return turn.toRotationMatrix() * stretch.asDiagonal() * (Matrix3d::Identity() + random_matrix(random, 0.1));
}

TEST(Corotated, ItsStressIsTheGradientOfItsEnergyAlsoWhereInverted) {
  constexpr double kStep = 1e-6;
  device::Random random(7);
  for (int run = 0; run < 500; ++run) {
    const Matrix3d at = deformation(random);
    const Matrix3d stress = Corotated(at, kMaterial).stress_Pa();
    for (int i = 0; i < 9; ++i) {
      Matrix3d more = at;
      Matrix3d less = at;
      more.data()[i] += kStep;
      less.data()[i] -= kStep;
      const double slope =
          (Corotated(more, kMaterial).energy_J_per_m3() - Corotated(less, kMaterial).energy_J_per_m3()) / (2.0 * kStep);
      ASSERT_NEAR(stress.data()[i], slope, 1e-7 * (1.0 + std::abs(slope))) << "run " << run << "\n" << at;
    }
  }
}

/// The derivative of the stress, as a matrix over the nine numbers of F.
Eigen::Matrix<double, 9, 9> second_of(const Matrix3d& at, Curvature curvature) {
  Corotated law(at, kMaterial);
  law.prepare(curvature);
  Eigen::Matrix<double, 9, 9> all;
  for (int j = 0; j < 3; ++j)
    for (int l = 0; l < 3; ++l) all.block<3, 3>(3 * j, 3 * l) = law.block(Vector3d::Unit(j), Vector3d::Unit(l));
  return all;
}

TEST(Corotated, ItsSecondDerivativeIsThatOfItsStress) {
  constexpr double kStep = 1e-6;
  device::Random random(8);
  for (int run = 0; run < 200; ++run) {
    const Matrix3d at = deformation(random);
    const auto second = second_of(at, Curvature::Exact);
    for (int i = 0; i < 9; ++i) {
      Matrix3d more = at;
      Matrix3d less = at;
      more.data()[i] += kStep;
      less.data()[i] -= kStep;
      const Matrix3d slope =
          (Corotated(more, kMaterial).stress_Pa() - Corotated(less, kMaterial).stress_Pa()) / (2.0 * kStep);
      for (int k = 0; k < 9; ++k)
        ASSERT_NEAR(second(k, i), slope.data()[k], 2e-6 * second.norm()) << "run " << run << "\n" << at;
    }
  }
}

TEST(Corotated, PositiveCurvatureHasNoNegativeEigenvalue) {
  device::Random random(9);
  double least_exact = 0.0;
  for (int run = 0; run < 500; ++run) {
    const Matrix3d at = deformation(random);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>> positive(second_of(at, Curvature::Positive));
    ASSERT_GE(positive.eigenvalues().minCoeff(), -1e-9) << at;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>> exact(second_of(at, Curvature::Exact));
    least_exact = std::min(least_exact, exact.eigenvalues().minCoeff());
  }
  EXPECT_LT(least_exact, -0.1) << "the cases include compression, where the exact curvature is negative";
}

TEST(Corotated, ARotationStoresNoEnergyAndAFlatElementPushesBack) {
  const Matrix3d turned = Eigen::AngleAxisd(2.5, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  EXPECT_NEAR(Corotated(turned, kMaterial).energy_J_per_m3(), 0.0, 1e-14);
  EXPECT_LT(Corotated(turned, kMaterial).stress_Pa().norm(), 1e-12);
  for (const Vector3d& stretch : {Vector3d(1, 1, 0), Vector3d(1, 0, 0), Vector3d(0, 0, 0), Vector3d(1, 1, -1)}) {
    const Matrix3d stress = Corotated(stretch.asDiagonal().toDenseMatrix(), kMaterial).stress_Pa();
    EXPECT_TRUE(stress.allFinite());
    EXPECT_LT(stress(2, 2), -0.1) << "it wants to be longer along z: " << stretch.transpose();
  }
}

TEST(ElasticBody, ItsGradientIsThatOfItsEnergyAndItsHessianThatOfItsGradient) {
  constexpr double kStep = 1e-7;
  for (const ElementOrder order : {ElementOrder::Linear, ElementOrder::Quadratic}) {
    const auto body = rubber({.across = 1, .along = 2, .order = order});
    const NodeField at = shaken(*body, 0.004, 3);
    NodeField gradient_N;
    body->gradient(at, gradient_N);
    StiffnessMatrix hessian = body->pattern();
    body->hessian(at, Curvature::Exact, hessian);
    const Eigen::MatrixXd whole = Eigen::MatrixXd(hessian).selfadjointView<Eigen::Lower>();
    for (Eigen::Index i = 0; i < at.size(); i += 5) {
      NodeField more = at;
      NodeField less = at;
      more.data()[i] += kStep;
      less.data()[i] -= kStep;
      const double slope = (body->energy_J(more) - body->energy_J(less)) / (2.0 * kStep);
      ASSERT_NEAR(gradient_N.data()[i], slope, 1e-5 * (1.0 + std::abs(slope)));
      NodeField up_N;
      NodeField down_N;
      body->gradient(more, up_N);
      body->gradient(less, down_N);
      const NodeField change = (up_N - down_N) / (2.0 * kStep);
      for (Eigen::Index k = 0; k < at.size(); ++k)
        ASSERT_NEAR(whole(k, i), change.data()[k], 1e-5 * whole.norm()) << "row " << k << ", column " << i;
    }
  }
}

TEST(ElasticBody, ItsMassesAreThoseOfTheFreeNodes) {
  const auto body = rubber({.across = 2, .along = 6});
  const double whole_kg = 1000.0 * 0.02 * 0.02 * 0.1;
  EXPECT_LT(body->masses().sum(), whole_kg);
  EXPECT_GT(body->masses().sum(), 0.9 * whole_kg) << "the fixed nodes have the rest";
  EXPECT_GT(body->masses().minCoeff(), 0.0);
}

TEST(TetMesh, APrismHasRightTetrahedraThatFillIt) {
  for (const ElementOrder order : {ElementOrder::Linear, ElementOrder::Quadratic}) {
    const TetMesh mesh = *make_prism({.across = 2, .along = 3, .order = order});
    EXPECT_TRUE(check(mesh).ok());
    double volume_m3 = 0.0;
    for (const auto& nodes : mesh.tetrahedra) {
      Matrix3d edges;
      for (int i = 0; i < 3; ++i)
        edges.col(i) = mesh.nodes[nodes[static_cast<std::size_t>(i) + 1]] - mesh.nodes[nodes[0]];
      EXPECT_GT(edges.determinant(), 0.0);
      volume_m3 += edges.determinant() / 6.0;
    }
    EXPECT_NEAR(volume_m3, 0.02 * 0.02 * 0.1, 1e-12);
  }
}

TEST(TetMesh, ItsSidesLookOutwards) {
  const TetMesh mesh = *make_prism({.across = 2, .along = 3});
  const Vector3d outwards[]{-Vector3d::UnitX(), Vector3d::UnitX(), -Vector3d::UnitZ(), Vector3d::UnitZ(),
                            Vector3d::UnitY()};
  const double area_m2[]{0.002, 0.002, 0.002, 0.002, 0.0004};
  for (std::size_t side = 0; side < kPrismSides; ++side) {
    double sum_m2 = 0.0;
    for (const auto& t : flat_triangles(mesh, static_cast<PrismSide>(side))) {
      const Vector3d normal = (mesh.nodes[t[1]] - mesh.nodes[t[0]]).cross(mesh.nodes[t[2]] - mesh.nodes[t[0]]);
      EXPECT_NEAR(normal.normalized().dot(outwards[side]), 1.0, 1e-12);
      sum_m2 += 0.5 * normal.norm();
    }
    EXPECT_NEAR(sum_m2, area_m2[side], 1e-12);
  }
}

TEST(TetMesh, RefusesWhatIsNoTetrahedron) {
  const auto fault = [](const auto& spoil) {
    TetMesh mesh = *make_prism({.across = 1, .along = 1});
    spoil(mesh);
    const Result<void> right = check(mesh);
    return right.ok() ? std::string() : to_string(right.error());
  };
  EXPECT_EQ(fault([](TetMesh&) {}), "");
  EXPECT_NE(fault([](TetMesh& mesh) {
              mesh.nodes[mesh.tetrahedra[0][1]] = mesh.nodes[mesh.tetrahedra[0][0]];
            }).find("an edge without length"),
            std::string::npos);
  EXPECT_NE(fault([](TetMesh& mesh) {
              std::swap(mesh.tetrahedra[2][0], mesh.tetrahedra[2][1]);
            }).find("tetrahedron 2 is turned inside out"),
            std::string::npos);
  EXPECT_NE(fault([](TetMesh& mesh) {
              const auto& n = mesh.tetrahedra[0];
              mesh.nodes[n[3]] =
                  0.5 * (mesh.nodes[n[1]] + mesh.nodes[n[2]]) + 0.01 * (mesh.nodes[n[1]] - mesh.nodes[n[0]]);
            }).find("tetrahedron"),
            std::string::npos);
  EXPECT_NE(fault([](TetMesh& mesh) { mesh.nodes[7].x() = std::nan(""); }).find("not a number"), std::string::npos);
  EXPECT_NE(fault([](TetMesh& mesh) { mesh.tetrahedra[1][2] = 9999; }).find("does not exist"), std::string::npos);
  EXPECT_NE(fault([](TetMesh& mesh) { mesh.fixed = 0; }).find("no node"), std::string::npos);
  EXPECT_FALSE(make_prism({.size_m = {0.02, std::nan(""), 0.02}}).ok());
  EXPECT_FALSE(make_prism({.across = 0}).ok());
  EXPECT_FALSE(make_prism({.across = 16, .along = 64}).ok()) << "too many nodes are not allocated";
}

}  // namespace
}  // namespace telepalp::tissue
