#include "tools/edge_plan/edges_command.h"

#include <optional>
#include <string>

#include "proto/words/number_word.h"
#include "support/program/options.h"
#include "tools/edge_plan/edge_plan.h"
#include "tools/edge_plan/edges_text.h"

namespace telepalp::edge_plan {
namespace {

constexpr double kSeenViewers = 20.0;
constexpr double kMessages_per_s = 60.0;  // depth and colour, 30 images a second of each

program::Usage usage() {
  return {
      .program = "telepalp-link edges",
      .purpose = "says how many edges and computers a number of viewers needs",
      .positional = {},
      .options = {{"viewers", "N", "programs that watch at the same time", "10000"},
                  {"content", "CONTENT",
                   "the site's --depth-mode, or what a viewer takes in Mbit/s: 'telepalp-link check' tells it", "fast"},
                  {"cores", "N", "cores of each computer for edges", "4"},
                  {"network", "MBIT/S", "network of each of these computers", "1000"},
                  {"seen-percent", "P",
                   "of a core, as 'top' shows it for your edge with 20 viewers of this content; default: as "
                   "measured by telepalp's developers"}},
      .example = "telepalp-link edges --viewers 10000 --content bounded --network 10000"};
}

Result<Stream> stream_of(const std::string& content) {
  std::string modes;
  for (const Content& known : kContents) {
    if (content == known.depth_mode) return known.stream;
    modes += std::string(known.depth_mode) + ", ";
  }
  constexpr double kLeast = 0.01, kMost = 10'000.0;
  const std::optional<double> Mbit_per_s = number_of(content);
  if (Mbit_per_s && *Mbit_per_s >= kLeast && *Mbit_per_s <= kMost)
    return Stream{.bytes_per_s = *Mbit_per_s / 8e-6, .messages_per_s = kMessages_per_s};
  return Error{.what = "'" + content + "' is neither a depth mode nor a rate",
               .where = "--content",
               .fix = "give " + modes + "or a number of Mbit/s from 0.01 to 10000"};
}

/// The measured costs, for computers that are as fast as the one that the user saw.
EdgeCosts scaled(EdgeCosts costs, double by) {
  costs.idle_cores *= by;
  costs.s_per_byte_in *= by;
  costs.s_per_message_out *= by;
  costs.s_per_byte_out *= by;
  return costs;
}

Result<Asked> asked_of(const program::Arguments& arguments) {
  const Result<std::int64_t> viewers = arguments.whole("viewers", 1, 10'000'000);
  if (!viewers) return viewers.error();
  const Result<Stream> stream = stream_of(arguments.text("content"));
  if (!stream) return stream.error();
  const Result<double> cores = arguments.number("cores", 0.1, 1024.0);
  if (!cores) return cores.error();
  const Result<double> Mbit_per_s = arguments.number("network", 0.1, 1e6);
  if (!Mbit_per_s) return Mbit_per_s.error();
  return Asked{.viewers = static_cast<std::size_t>(*viewers),
               .stream = *stream,
               .computer = {.cores = *cores, .Mbit_per_s = *Mbit_per_s},
               .limits = {}};
}

int run(const program::Arguments& arguments) {
  const Result<Asked> asked = asked_of(arguments);
  if (!asked) return program::fail(asked.error(), program::kAskedWrongly);
  double slower = 1.0;
  if (arguments.has("seen-percent")) {
    const Result<double> seen = arguments.number("seen-percent", 0.1, 1000.0);
    if (!seen) return program::fail(seen.error(), program::kAskedWrongly);
    slower = 0.01 * *seen / kMeasuredEdge.cores_of(asked->stream, kSeenViewers);
  }
  const EdgeCosts edge = scaled(kMeasuredEdge, slower);
  const ClusterCosts cluster{.s_per_byte_in = slower * kMeasuredCluster.s_per_byte_in,
                             .s_per_byte_out = slower * kMeasuredCluster.s_per_byte_out};
  const Result<EdgePlan> plan = plan_edges(*asked, edge, cluster);
  if (!plan) return program::fail(plan.error());
  return program::print(in_lines(*asked, edge, *plan));
}

}  // namespace

int edges_command(int argc, const char* const* argv) { return program::run_program(usage(), argc, argv, run); }

}  // namespace telepalp::edge_plan
