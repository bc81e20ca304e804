#include "tests/bench/cluster/model_rows.h"

#include <Eigen/Dense>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "proto/keys/key_file.h"
#include "tests/bench/cluster/nats_cluster.h"
#include "tests/bench/cluster/running_server.h"
#include "tests/bench/cluster/watching.h"
#include "tests/bench/distribution.h"
#include "tests/bench/process_load.h"
#include "tools/edge_plan/edge_plan.h"
#include "where.h"

namespace telepalp::bench {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using edge_plan::ClusterCosts;
using edge_plan::EdgeCosts;

/// Edges of one site, and their viewers.
struct Class {
  const char* depth_mode;
  std::size_t edges;
  std::size_t viewers_per_edge;
};

constexpr int kRounds = 3;  // in turns, so that a slow minute of the machine meets all classes

// The costs are fitted to these. Contents and numbers of viewers differ, so that bytes and messages are told apart.
constexpr std::array kFitted{Class{"fast", 1, 1}, Class{"fast", 1, 20}, Class{"bounded", 1, 1}, Class{"bounded", 1, 20},
                             Class{"fast", 3, 1}};
// The model must tell these, of which none has been fitted.
constexpr std::array kTold{Class{"fast", 1, 24}, Class{"fast", 2, 12}, Class{"fast", 4, 6}, Class{"temporal", 2, 8}};

/// What one class used and got in each second.
struct Used {
  double edges = 0.0;       ///< their number
  double edge_cores = 0.0;  ///< of all edges
  double nats_cores = 0.0;
  double stream_B = 0.0;     ///< what one viewer gets
  double viewers_B = 0.0;    ///< what all viewers get
  double messages = 0.0;     ///< what all viewers get
  double MiB = 0.0;          ///< of one edge
  double descriptors = 0.0;  ///< of one edge
};

Error no_keys(const fs::path& log) {
  return {.what = "telepalp-keys made no key", .where = log.string(), .fix = "read this file"};
}

/// Makes keys/server.key and keys/view.key.
Result<void> make_keys(const fs::path& scratch) {
  const std::string folder = (scratch / "keys").string();
  const fs::path log = scratch / "keys.log";
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"authority", "--dir", folder, "--host", "127.0.0.1"},
                                             {"server", "--dir", folder, "--host", "127.0.0.1"},
                                             {"client", "--dir", folder, "--name", "view", "--role", "viewer"}})
    if (support::ChildProcess(TELEPALP_BINARY_DIR "/bin/telepalp-keys", command, log).wait(10s) != 0)
      return no_keys(log);
  return {};
}

/// The processes of a class, which are ready.
class RunningClass {
 public:
  static Result<std::unique_ptr<RunningClass>> start(const Class& asked, const fs::path& scratch) {
    Result<NatsCluster> cluster = NatsCluster::start(1, scratch);
    if (!cluster) return cluster.error();
    std::unique_ptr<RunningClass> made(new RunningClass(*std::move(cluster)));
    const std::string site = made->cluster_.url(0) + "/bench";
    Result<RunningServer> server =
        start_server(scratch, "site", {"--source", "synthetic", "--depth-mode", asked.depth_mode, "--publish", site});
    if (!server) return server.error();
    made->site_ = *std::move(server);
    for (std::size_t i = 0; i < asked.edges; ++i)
      if (const Result<void> added = made->add_edge(scratch, i, site); !added) return added.error();
    const auto key = keys::load_client_key(scratch / "keys" / "view.key", std::chrono::system_clock::now());
    if (!key) return key.error();
    made->viewers_ = std::make_unique<Viewers>(Viewers::Options{.key = *key});
    for (const RunningServer& edge : made->edges_) made->viewers_->add(edge.port, asked.viewers_per_edge);
    if (!made->viewers_->all_see()) return sees_nothing();
    return made;
  }

  Used use(double seconds) {
    viewers_->run_for(2s);
    const double edges_s = edges_run_s(), nats_s = run_s(cluster_.node(0).pid());
    const auto bytes = static_cast<double>(viewers_->bytes()), messages = static_cast<double>(viewers_->messages());
    const auto began = std::chrono::steady_clock::now();
    viewers_->run_for(std::chrono::duration<double>(seconds));
    const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    Used used{.edges = static_cast<double>(edges_.size()),
              .edge_cores = (edges_run_s() - edges_s) / took_s,
              .nats_cores = (run_s(cluster_.node(0).pid()) - nats_s) / took_s,
              .viewers_B = (static_cast<double>(viewers_->bytes()) - bytes) / took_s,
              .messages = (static_cast<double>(viewers_->messages()) - messages) / took_s,
              .MiB = resident_MiB(edges_.front().process->pid()),
              .descriptors = descriptors(edges_.front().process->pid())};
    used.stream_B = used.viewers_B / static_cast<double>(viewers_->count());
    return used;
  }

 private:
  explicit RunningClass(NatsCluster cluster) : cluster_(std::move(cluster)) {}
  Result<void> add_edge(const fs::path& scratch, std::size_t number, const std::string& site) {
    const std::string name = "edge" + std::to_string(number);
    fs::create_directories(scratch / name);
    Result<RunningServer> edge = start_server(
        scratch, name,
        {"--source", site, "--key", scratch / "keys" / "server.key", "--audit", scratch / name / "audit.log"});
    if (!edge) return edge.error();
    edges_.push_back(*std::move(edge));
    return {};
  }
  [[nodiscard]] double edges_run_s() const {
    double sum_s = 0.0;
    for (const RunningServer& edge : edges_) sum_s += run_s(edge.process->pid());
    return sum_s;
  }

  NatsCluster cluster_;
  RunningServer site_;
  std::vector<RunningServer> edges_;
  std::unique_ptr<Viewers> viewers_;  // ends first
};

Result<Used> used_by(const Class& asked, const fs::path& scratch, double seconds) {
  auto running = RunningClass::start(asked, scratch);
  if (!running) return running.error();
  return (*running)->use(seconds);
}

/// Of each figure the median.
Used median(const std::vector<Used>& rounds) {
  Used middle;
  for (const auto figure : {&Used::edges, &Used::edge_cores, &Used::nats_cores, &Used::stream_B, &Used::viewers_B,
                            &Used::messages, &Used::MiB, &Used::descriptors}) {
    Distribution all;
    for (const Used& used : rounds) all.add(used.*figure);
    middle.*figure = all.p50();
  }
  return middle;
}

/// What each class uses, in the order of `classes`.
Result<std::vector<Used>> measured_classes(const std::vector<Class>& classes, const fs::path& scratch, double seconds) {
  std::vector<std::vector<Used>> all(classes.size());
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < classes.size(); ++i) {
      const Result<Used> used = used_by(classes[i], scratch, seconds);
      if (!used) return used.error();
      all[i].push_back(*used);
    }
  std::vector<Used> middle;
  for (const std::vector<Used>& rounds : all) middle.push_back(median(rounds));
  return middle;
}

/// Solves the rows of a linear system in the sense of least squares. Each row is divided by its right side, so that
/// the relative errors of small and of large classes count alike.
Eigen::VectorXd solved(Eigen::MatrixXd factors, const Eigen::VectorXd& right) {
  for (Eigen::Index i = 0; i < right.size(); ++i) factors.row(i) /= right(i);
  return factors.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(right.size()));
}

EdgeCosts fitted_edge(const std::vector<Used>& all) {
  const auto count = static_cast<Eigen::Index>(all.size());
  Eigen::MatrixXd factors(count, 4);
  Eigen::VectorXd cores(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Used& used = all[static_cast<std::size_t>(i)];
    factors.row(i) << used.edges, used.edges * used.stream_B, used.messages, used.viewers_B;
    cores(i) = used.edge_cores;
  }
  const Eigen::VectorXd costs = solved(factors, cores);
  const Used &few = all[0], &many = all[1];  // kFitted: 1 and 20 viewers
  const double more = many.viewers_B / many.stream_B - few.viewers_B / few.stream_B;
  EdgeCosts edge{.idle_cores = costs(0),
                 .s_per_byte_in = costs(1),
                 .s_per_message_out = costs(2),
                 .s_per_byte_out = costs(3),
                 .viewer_MiB = (many.MiB - few.MiB) / more,
                 .viewer_descriptors = (many.descriptors - few.descriptors) / more};
  edge.idle_MiB = few.MiB - edge.viewer_MiB;
  edge.idle_descriptors = few.descriptors - edge.viewer_descriptors;
  return edge;
}

ClusterCosts fitted_cluster(const std::vector<Used>& all) {
  const auto count = static_cast<Eigen::Index>(all.size());
  Eigen::MatrixXd factors(count, 2);
  Eigen::VectorXd cores(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Used& used = all[static_cast<std::size_t>(i)];
    factors.row(i) << used.stream_B, used.edges * used.stream_B;
    cores(i) = used.nats_cores;
  }
  const Eigen::VectorXd costs = solved(factors, cores);
  return {.s_per_byte_in = costs(0), .s_per_byte_out = costs(1)};
}

std::string in_words(const Class& asked) {
  const std::size_t viewers = asked.edges * asked.viewers_per_edge;
  return " " + std::to_string(asked.edges) + (asked.edges == 1 ? " edge, " : " edges, ") + std::to_string(viewers) +
         " viewers, " + asked.depth_mode + ": ";
}

double off_percent(double told, double measured) { return 100.0 * std::abs(told / measured - 1.0); }

/// The figures that tools/edge_plan/edge_plan.h ships, as this machine has them.
void add_costs(const EdgeCosts& edge, const ClusterCosts& cluster, std::vector<Row>& rows) {
  rows.push_back(measured("edge: idle", 1e3 * edge.idle_cores, "core/1000"));
  rows.push_back(measured("edge: a MB from the cluster", 1e9 * edge.s_per_byte_in, "ms"));
  rows.push_back(measured("edge: a message to a viewer", 1e6 * edge.s_per_message_out, "us"));
  rows.push_back(measured("edge: a MB to a viewer", 1e9 * edge.s_per_byte_out, "ms"));
  rows.push_back(measured("edge: memory without viewers", edge.idle_MiB, "MiB"));
  rows.push_back(measured("edge: memory of a viewer", edge.viewer_MiB, "MiB"));
  rows.push_back(measured("edge: descriptors without viewers", edge.idle_descriptors, ""));
  rows.push_back(measured("edge: descriptors of a viewer", edge.viewer_descriptors, ""));
  rows.push_back(measured("NATS server: a MB from the site", 1e9 * cluster.s_per_byte_in, "ms"));
  rows.push_back(measured("NATS server: a MB to an edge", 1e9 * cluster.s_per_byte_out, "ms"));
}

/// How far the bytes of a message are from those that `telepalp-link edges` has for this content. A busy machine sends
/// fewer messages, not smaller ones.
void add_content(const Class& asked, const Used& used, std::vector<Row>& rows) {
  for (const edge_plan::Content& content : edge_plan::kContents)
    if (content.depth_mode == asked.depth_mode)
      rows.push_back(at_most(
          std::string("model, ") + asked.depth_mode + ": bytes of a message, off by",
          off_percent(content.stream.bytes_per_s / content.stream.messages_per_s, used.viewers_B / used.messages), "%",
          15.0));
}

/// Compares the model with a class to which it was not fitted.
void add_told(const Class& asked, const Used& used, const EdgeCosts& edge, const ClusterCosts& cluster,
              std::vector<Row>& rows) {
  const std::string what = "model," + in_words(asked);
  const double cores = used.edges * edge.cores(used.stream_B, 0.0, 0.0) +
                       edge.cores(0.0, used.messages, used.viewers_B) - edge.idle_cores;
  const double nats_cores = used.stream_B * (cluster.s_per_byte_in + used.edges * cluster.s_per_byte_out);
  rows.push_back(at_most(what + "processor time of all edges, off by", off_percent(cores, used.edge_cores), "%", 15.0));
  rows.push_back(
      at_most(what + "processor time of the NATS server, off by", off_percent(nats_cores, used.nats_cores), "%", 15.0));
  rows.push_back(measured(what + "cores of all edges", used.edge_cores, ""));
  rows.push_back(measured(what + "cores of the NATS server", used.nats_cores, ""));
  rows.push_back(measured(what + "to all viewers", 8e-6 * used.viewers_B, "Mbit/s"));
}

}  // namespace

Result<void> add_model_rows(const fs::path& scratch, double seconds, std::vector<Row>& rows) {
  if (const Result<void> made = make_keys(scratch); !made) return made.error();
  std::vector<Class> classes(kFitted.begin(), kFitted.end());
  classes.insert(classes.end(), kTold.begin(), kTold.end());
  const Result<std::vector<Used>> used = measured_classes(classes, scratch, seconds);
  if (!used) return used.error();
  const std::vector<Used> fitted(used->begin(), used->begin() + kFitted.size());
  const EdgeCosts edge = fitted_edge(fitted);
  const ClusterCosts cluster = fitted_cluster(fitted);
  add_costs(edge, cluster, rows);
  for (std::size_t i = 0; i < kFitted.size(); ++i) {
    rows.push_back(measured("fitted to" + in_words(kFitted[i]) + "cores of all edges", fitted[i].edge_cores, ""));
    rows.push_back(measured("fitted to" + in_words(kFitted[i]) + "cores of the NATS server", fitted[i].nats_cores, ""));
  }
  for (const std::size_t i : {0U, 2U, 8U}) add_content(classes[i], (*used)[i], rows);
  for (std::size_t i = kFitted.size(); i < classes.size(); ++i) add_told(classes[i], (*used)[i], edge, cluster, rows);
  return {};
}

}  // namespace telepalp::bench
