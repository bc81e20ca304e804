// The live driver of a stage: jobs and hand-overs on the owner's thread, runs on the stage's thread.

#include "haptic_station/station/threads/stage_thread.h"

#include <gtest/gtest.h>

#include <chrono>

#include "haptic_station/station/threads/live_driver.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;

/// Adds one to its input, and notes the threads on which it is called.
class Adder {
 public:
  struct Job {
    int input = 0;
  };
  struct Result {
    int sum = 0;
    SessionTime done{};
  };
  std::optional<Job> take(SessionTime, int input) {
    taken_on = std::this_thread::get_id();
    ++jobs;
    return Job{input};
  }
  Result run(const Job& job, const core::StepTime& time) {
    run_on = std::this_thread::get_id();
    return {job.input + 1, time(core::StageStep::Done)};
  }
  std::thread::id taken_on;
  std::thread::id run_on;
  int jobs = 0;
};

TEST(LiveDriver, TakesAndHandsOverOnTheOwnersThreadAndRunsOnItsOwn) {
  boost::asio::io_context owner{1};
  StageThread thread(owner, [] { return session_time(7); });
  Adder adder;
  std::vector<int> sums;
  std::thread::id handed_over_on;
  LiveDriver<Adder> driver(adder, thread, [&](const Adder::Result& result) {
    EXPECT_EQ(result.done, session_time(7));
    handed_over_on = std::this_thread::get_id();
    sums.push_back(result.sum);
  });
  const auto work = boost::asio::make_work_guard(owner);
  for (int i = 0; i < 3; ++i) {
    driver.begin(session_time(0), 10 * i);
    driver.begin(session_time(0), 99);  // the stage is at work: the second call takes no job
    while (sums.size() < static_cast<std::size_t>(i + 1)) (void)owner.run_one_for(1s);
  }
  EXPECT_EQ(sums, (std::vector{1, 11, 21}));
  EXPECT_EQ(adder.jobs, 3);
  EXPECT_EQ(adder.taken_on, std::this_thread::get_id());
  EXPECT_EQ(handed_over_on, std::this_thread::get_id());
  EXPECT_NE(adder.run_on, std::this_thread::get_id());
}

}  // namespace
}  // namespace telepalp::station
