// How many edges a number of viewers needs; `telepalp-bench cluster --part model` compares the model with real edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "server/hub/peer_listener.h"
#include "tools/edge_plan/edge_plan.h"

namespace {

using namespace telepalp;
using edge_plan::Asked;
using edge_plan::ClusterCosts;
using edge_plan::EdgeCosts;
using edge_plan::EdgePlan;

/// 8 Mbit/s and 60 messages a second.
constexpr edge_plan::Stream kStream{.bytes_per_s = 1e6, .messages_per_s = 60.0};
/// An edge uses 0.01 cores for each viewer and 0.02 cores besides.
constexpr EdgeCosts kEdge{.idle_cores = 0.01, .s_per_byte_in = 1e-8, .s_per_message_out = 1e-4, .s_per_byte_out = 4e-9};
constexpr ClusterCosts kCluster{.s_per_byte_in = 1e-9, .s_per_byte_out = 1e-9};

EdgePlan plan_of(const Asked& asked) {
  const auto plan = edge_plan::plan_edges(asked, kEdge, kCluster);
  EXPECT_TRUE(plan.ok());
  return plan.ok() ? *plan : EdgePlan{};
}

TEST(EdgePlan, KnowsThePlacesOfAServer) {
  EXPECT_EQ(edge_plan::Limits{}.places, hub::PlaceLimits{}.viewers) << "tools/edge_plan has a copy of this limit";
}

TEST(EdgePlan, ADistributionIsLimitedByTheNetwork) {
  const EdgePlan plan = plan_of({.viewers = 1000, .stream = kStream, .computer = {.cores = 8, .Mbit_per_s = 500}});
  EXPECT_EQ(plan.computer_bound, EdgePlan::ComputerBound::Network);
  EXPECT_EQ(plan.viewers_per_computer, 50U) << "80 % of 500 Mbit/s are 50 streams of 8 Mbit/s";
  EXPECT_EQ(plan.computers, 20U);
  EXPECT_EQ(plan.viewers_per_edge, 48U);
  EXPECT_EQ(plan.edges_per_computer, 2U) << "50 viewers need more places than one edge has";
  EXPECT_NEAR(plan.edge_cores, 40 * 0.02 + 1000 * 0.01, 1e-9);
  EXPECT_NEAR(plan.to_viewers_Mbit_per_s, 8000.0, 1e-9);
  EXPECT_NEAR(plan.to_edges_Mbit_per_s, 320.0, 1e-9);
  EXPECT_EQ(plan.nats_servers, 1U) << "40 streams are 320 of 400 Mbit/s";
}

TEST(EdgePlan, ADistributionIsLimitedByTheCores) {
  const EdgePlan plan = plan_of({.viewers = 1000, .stream = kStream, .computer = {.cores = 2, .Mbit_per_s = 1e5}});
  EXPECT_EQ(plan.computer_bound, EdgePlan::ComputerBound::Cores);
  EXPECT_EQ(plan.viewers_per_computer, 134U) << "1.4 cores, of which three edges use 0.06 without viewers";
  EXPECT_EQ(plan.edges_per_computer, 3U);
}

TEST(EdgePlan, AnEdgeOfASlowComputerServesFewerViewersThanItHasPlaces) {
  EdgeCosts slow = kEdge;
  slow.s_per_message_out *= 5.0;
  const auto plan = edge_plan::plan_edges({.viewers = 10, .stream = kStream}, slow, kCluster);
  ASSERT_TRUE(plan.ok());
  EXPECT_EQ(plan->edge_bound, EdgePlan::EdgeBound::Core);
  EXPECT_EQ(plan->viewers_per_edge, 20U) << "0.68 of 0.7 cores, at 0.034 each";
}

TEST(EdgePlan, FewViewersNeedOneEdgeAndMoreViewersNeverNeedFewerEdges) {
  const EdgePlan one = plan_of({.viewers = 1, .stream = kStream});
  EXPECT_EQ(one.computers, 1U);
  EXPECT_EQ(one.edges, 1U);
  EdgePlan before = one;
  for (std::size_t viewers = 2; viewers < 30'000; viewers += 1 + viewers / 3) {
    const EdgePlan plan = plan_of({.viewers = viewers, .stream = kStream});
    EXPECT_GE(plan.computers, before.computers) << viewers;
    EXPECT_GE(plan.edges * plan.viewers_per_edge, viewers) << "each viewer has a place";
    EXPECT_GE(plan.computers * plan.viewers_per_computer, viewers);
    before = plan;
  }
}

TEST(EdgePlan, SaysWhenOneClusterOfNatsServersIsTooSmall) {
  const auto servers = [](std::size_t viewers) {
    return plan_of({.viewers = viewers, .stream = kStream, .computer = {.cores = 8, .Mbit_per_s = 100}}).nats_servers;
  };
  EXPECT_EQ(servers(100), 1U) << "10 edges of 10 viewers: 80 Mbit/s";
  EXPECT_EQ(servers(110), 3U) << "one for the site, two for 11 edges";
  EXPECT_EQ(servers(1000), 11U);
  EXPECT_EQ(servers(1010), 0U) << "the site's one cannot send to 11 others";
}

TEST(EdgePlan, RefusesAComputerThatIsTooSmallForOneViewer) {
  EXPECT_FALSE(edge_plan::plan_edges({.stream = kStream, .computer = {.Mbit_per_s = 9}}, kEdge, kCluster).ok());
  EXPECT_FALSE(edge_plan::plan_edges({.stream = kStream, .computer = {.cores = 0.03}}, kEdge, kCluster).ok());
}

TEST(EdgePlan, TheMeasuredCostsAreOfARealMachine) {
  for (const edge_plan::Content& content : edge_plan::kContents) {
    const auto plan =
        edge_plan::plan_edges({.stream = content.stream}, edge_plan::kMeasuredEdge, edge_plan::kMeasuredCluster);
    ASSERT_TRUE(plan.ok()) << content.depth_mode;
    EXPECT_GT(plan->edge_cores, 1.0) << "ten thousand viewers are not served for nothing";
  }
}

}  // namespace
