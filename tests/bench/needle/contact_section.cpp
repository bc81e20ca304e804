#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "haptic_station/device/random.h"
#include "haptic_station/station/bill/thread_time.h"
#include "haptic_station/tissue/mesh/closest_vertex.h"
#include "haptic_station/tissue/mesh/triangle_tree.h"
#include "tests/bench/distribution.h"
#include "tests/bench/needle/section.h"
#include "tests/haptic_station/periods.h"
#include "tests/haptic_station/tissue/meshes.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;
using tissue::SurfaceMesh;
using tissue::TriangleTree;

constexpr int kTicks = 250'000;  // of each mesh and speed

/// A tip that goes straight from one random place in a box around the mesh to the next, at one speed.
std::vector<Vector3d> tip_path(double speed_m_per_s) {
  device::Random random(7);
  std::vector<Vector3d> path;
  path.reserve(kTicks + 1);
  Vector3d at_m(0.0, 0.04, 0.0);
  Vector3d goal_m = at_m;
  path.push_back(at_m);
  for (int i = 0; i < kTicks; ++i) {
    const double most_m = speed_m_per_s * kTick_s;
    if ((goal_m - at_m).norm() <= most_m)
      goal_m = {random.uniform(-0.045, 0.045), random.uniform(-0.045, 0.045), random.uniform(-0.045, 0.045)};
    const Vector3d way_m = goal_m - at_m;
    at_m += std::min(1.0, most_m / way_m.norm()) * way_m;
    path.push_back(at_m);
  }
  return path;
}

/// Six times the signed volume of a tetrahedron.
double volume(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// Whether a segment passes through a triangle, by signed volumes.
bool passes(const Vector3d& from, const Vector3d& to, const SurfaceMesh& mesh, const tissue::Triangle& triangle) {
  const Vector3d& a = mesh.vertices()[triangle[0]];
  const Vector3d& b = mesh.vertices()[triangle[1]];
  const Vector3d& c = mesh.vertices()[triangle[2]];
  if (volume(a, b, c, from) * volume(a, b, c, to) > 0.0) return false;
  const double u = volume(from, to, a, b);
  const double v = volume(from, to, b, c);
  const double w = volume(from, to, c, a);
  return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
}

/// The triangles around each vertex, which S4's swept test looks at.
std::vector<std::vector<std::uint32_t>> triangles_around(const SurfaceMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> around(mesh.vertices().size());
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)
    for (const std::uint32_t v : mesh.triangles()[t]) around[v].push_back(t);
  return around;
}

/// Answers of a method at each tick of a path, and the processor time of one: p50 over blocks of answers.
template <class Answer>
struct Answers {
  std::vector<Answer> at;
  double ns = 0.0;
};

template <class Find>
auto answers_of(const std::vector<Vector3d>& path, const Find& find) {
  Answers<decltype(find(path[0], path[1]))> answers;
  answers.at.reserve(path.size());
  Distribution taken_ns;
  for (std::size_t i = 1; i < path.size();) {
    constexpr std::size_t kBlock = 1000;  // the clock takes as long as some answers
    const std::size_t begun = i;
    const std::int64_t before_ns = station::thread_ns();
    for (; i < path.size() && i < begun + kBlock; ++i) answers.at.push_back(find(path[i - 1], path[i]));
    taken_ns.add(static_cast<double>(station::thread_ns() - before_ns) / static_cast<double>(i - begun));
  }
  answers.ns = taken_ns.p50();
  return answers;
}

/// The methods on one mesh at one speed.
class Contest {
 public:
  Contest(const char* name, const SurfaceMesh& mesh, double speed_m_per_s)
      : mesh_(mesh), tree_(mesh), path_(tip_path(speed_m_per_s)) {
    case_.mesh = name;
    case_.speed_m_per_s = speed_m_per_s;
    case_.ticks = path_.size() - 1;
  }
  [[nodiscard]] ContactCase run() {
    find_vertices();
    find_crossings();
    return case_;
  }

 private:
  void find_vertices() {
    const auto truth =
        answers_of(path_, [&](const Vector3d&, const Vector3d& to) { return tissue::brute_force_vertex(mesh_, to); });
    const auto add = [&](const char* name, const Answers<std::uint32_t>& answers) {
      ContactCost cost{.method = name, .ns = answers.ns};
      for (std::size_t i = 0; i < answers.at.size(); ++i)
        cost.wrong += away_m(answers.at[i], i) > away_m(truth.at[i], i) ? 1 : 0;
      case_.vertex.push_back(cost);
    };
    std::uint32_t walked = truth.at.front();
    add("S4's walk", answers_of(path_, [&](const Vector3d&, const Vector3d& to) {
          return walked = tissue::ClosestVertex::walk(mesh_, walked, to);
        }));
    tissue::ClosestVertex closest(mesh_, tree_);
    add("proven walk", answers_of(path_, [&](const Vector3d&, const Vector3d& to) { return closest.at(to); }));
    case_.searches = closest.searches();
    add("tree", answers_of(path_, [&](const Vector3d&, const Vector3d& to) {
          return tree_.nearest_vertex(to, [](std::uint32_t) { return true; });
        }));
    add("all vertices", truth);
  }

  void find_crossings() {
    const auto truth = answers_of(path_, [&](const Vector3d& from, const Vector3d& to) {
      return std::ranges::any_of(mesh_.triangles(), [&](const auto& t) { return passes(from, to, mesh_, t); });
    });
    case_.crossings = static_cast<std::uint64_t>(std::ranges::count(truth.at, true));
    const auto add = [&](const char* name, const Answers<bool>& answers) {
      ContactCost cost{.method = name, .ns = answers.ns};
      for (std::size_t i = 0; i < answers.at.size(); ++i) cost.wrong += answers.at[i] != truth.at[i] ? 1 : 0;
      case_.crossing.push_back(cost);
    };
    const auto around = triangles_around(mesh_);
    std::uint32_t walked = 0;
    add("S4's swept test", answers_of(path_, [&](const Vector3d& from, const Vector3d& to) {
          walked = tissue::ClosestVertex::walk(mesh_, walked, to);
          return std::ranges::any_of(around[walked],
                                     [&](std::uint32_t t) { return passes(from, to, mesh_, mesh_.triangles()[t]); });
        }));
    add("tree", answers_of(path_, [&](const Vector3d& from, const Vector3d& to) {
          return tree_.first_hit(from, to).has_value();
        }));
    add("all triangles", truth);
  }

  [[nodiscard]] double away_m(std::uint32_t vertex, std::size_t i) const {
    return (mesh_.vertices()[vertex] - path_[i + 1]).norm();
  }

  const SurfaceMesh& mesh_;
  TriangleTree tree_;
  std::vector<Vector3d> path_;
  ContactCase case_;
};

void add_rows(std::vector<Row>& rows, const ContactCase& one, const std::vector<ContactCost>& costs, const char* what) {
  for (const ContactCost& cost : costs) {
    const std::string_view method = cost.method;
    const std::string name = std::string("contact: ") + what + ", " + one.mesh + " mesh, " +
                             (one.speed_m_per_s < 1.0 ? "0.1 m/s" : "10 m/s") + ": " + cost.method;
    rows.push_back(measured(name + ": processor time", cost.ns, "ns"));
    if (method.starts_with("all ")) continue;  // it is the truth
    const auto wrong = static_cast<double>(cost.wrong);
    const std::string of = name + ": wrong answers of " + std::to_string(one.ticks);
    rows.push_back(method.starts_with("S4") ? measured(of, wrong, "") : at_most(of, wrong, "", 0.0));
  }
}

}  // namespace

std::vector<ContactCase> contact_cases() {
  const SurfaceMesh flat = tissue::lattice_disc(0.05, 0.004);
  const SurfaceMesh concave = tissue::groove();
  std::vector<ContactCase> all;
  for (const double speed_m_per_s : {0.1, 10.0}) {
    all.push_back(Contest("flat", flat, speed_m_per_s).run());
    all.push_back(Contest("concave", concave, speed_m_per_s).run());
  }
  return all;
}

std::vector<Row> run_needle_contact_section() {
  std::vector<Row> rows;
  for (const ContactCase& one : contact_cases()) {
    add_rows(rows, one, one.vertex, "closest vertex");
    add_rows(rows, one, one.crossing, "a way through the mesh");
    const std::string name =
        std::string("contact: ") + one.mesh + " mesh, " + (one.speed_m_per_s < 1.0 ? "0.1 m/s" : "10 m/s");
    rows.push_back(measured(name + ": ticks with a way through the mesh", static_cast<double>(one.crossings), ""));
    rows.push_back(measured(name + ": searches of the proven walk", static_cast<double>(one.searches), ""));
  }
  return rows;
}

}  // namespace telepalp::bench
