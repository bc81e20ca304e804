#pragma once

#include <Eigen/Cholesky>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "haptic_station/tissue/build/base_net.h"
#include "haptic_station/tissue/net/stiffness_map.h"

namespace telepalp::tissue {

/// The net of springs of 1 N/m that is subdivided around one contact triangle (StiffnessMap). Allocates.
///
/// A new vertex's displacement is the mean of its edge's two ends plus an unknown of its own (a hierarchical basis). In
/// this basis a subdivision adds unknowns and leaves the base net's stiffness matrix as it is, so the base net is
/// solved once for all contacts. One Cholesky factor serves all depths: its leading blocks are the factors of the nets
/// with fewer subdivisions.
class LocalNet {
 public:
  LocalNet(const BaseNet& base, const NetSettings& settings, std::uint32_t contact);
  /// The displacement of the tip by 1 N [m] for the net at `depth`: 0 to subdivisions. `shares`: barycentric
  /// coordinates in the contact triangle.
  [[nodiscard]] double compliance(const Eigen::Vector3d& shares, int depth) const { return depths(shares)[depth]; }
  /// The displacement by 1 N that a tip feels [m]: of the limit of infinitely many subdivisions, extrapolated from the
  /// last one. With `subdivisions` 0: of the net itself.
  [[nodiscard]] double limit(const Eigen::Vector3d& shares) const;

 private:
  static constexpr int kMostDepth = 3;
  /// A part of a vertex's displacement. Unknowns of the base net come first, then those of the subdivisions.
  struct Share {
    int unknown;
    double weight;
  };
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  void subdivide(const Eigen::Vector3d& about_m, double within_m);
  void number_unknowns();
  void choose_base_unknowns(const Eigen::Vector3d& about_m, double within_m);
  void assemble(const BaseNet& base);
  void add_spring(const Edge& edge, Eigen::MatrixXd& coupling, Eigen::MatrixXd& own) const;
  [[nodiscard]] bool near(const Triangle& triangle, const Eigen::Vector3d& at_m, double within_m) const;
  [[nodiscard]] bool has_new_vertex(const Triangle& triangle) const;
  [[nodiscard]] int place(int unknown) const noexcept;
  [[nodiscard]] Eigen::VectorXd load(const Eigen::Vector3d& at_m) const;
  [[nodiscard]] std::array<double, kMostDepth + 1> depths(const Eigen::Vector3d& shares) const;

  NetSettings settings_;
  int base_unknowns_;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint8_t> fixed_;
  std::map<Edge, std::uint32_t> middle_of_;                ///< vertex in the middle of an edge
  std::vector<Edge> ends_of_;                              ///< of each new vertex: the ends of its edge
  std::array<std::size_t, kMostDepth + 1> vertices_at_{};  ///< number of vertices after each subdivision
  std::array<int, kMostDepth + 1> added_at_{};             ///< number of own unknowns after each subdivision
  std::vector<std::vector<Share>> shares_;                 ///< of each vertex
  std::vector<int> chosen_;                                ///< unknowns of the base net that are near the contact
  std::vector<int> chosen_at_;  ///< of each unknown of the base net: its place in chosen_; -1: none
  std::array<Eigen::Vector3d, 3> corners_;
  Eigen::MatrixXd base_;               ///< compliance of the chosen unknowns of the base net
  Eigen::MatrixXd carried_;            ///< base_ times the coupling of base and added unknowns
  Eigen::LLT<Eigen::MatrixXd> added_;  ///< factor of the added unknowns' stiffness on the base net
};

}  // namespace telepalp::tissue
