// The technician's choice of the source, and a server that shows another one.

#include "server/origin/source_choice.h"

#include <gtest/gtest.h>

#include <boost/asio/executor_work_guard.hpp>

#include "messages/camera.pb.h"
#include "server/origin/camera_origin.h"
#include "server/server.h"
#include "support/program/message_json.h"
#include "tests/server/still_source.h"

namespace telepalp::origin {
namespace {

using namespace std::chrono_literals;

/// A choice whose sources are opened when the test says so.
class Choice : public testing::Test {
 protected:
  msg::SourceState state() {
    msg::SourceState state;
    state.CopyFrom(*choice_.resource().state());
    return state;
  }
  Result<void> command(const std::string& json) {
    Result<void> outcome;
    choice_.resource().change(json, "technician tina", [&](const Result<void>& done) { outcome = done; });
    return outcome;
  }
  std::vector<std::string> names() {
    std::vector<std::string> names;
    const msg::SourceState now = state();
    for (const auto& source : now.sources()) names.push_back(source.name());
    return names;
  }

  boost::asio::io_context io_;
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_ = boost::asio::make_work_guard(io_);
  OpeningPool pool_{io_};
  std::vector<std::string> opened_;
  Progress progress_;
  OpenedOrigin done_;
  int shown_ = 0;
  SourceChoice choice_{
      pool_,
      {.first = {.name = "images:DIR", .title = "as the server was started"},
       .recordings =
           [] { return std::vector<SourceChoice::Source>{{.name = "session:a.mcap", .title = "a recording"}}; },
       .look_for_cameras = [] { return std::vector<SourceChoice::Source>{{.name = "openni2:usb1", .title = "Astra"}}; },
       .open =
           [this](const std::string& name, Progress progress, OpenedOrigin done) {
             opened_.push_back(name);
             progress_ = std::move(progress);
             done_ = std::move(done);
           },
       .show = [this](const std::unique_ptr<Origin>&) { ++shown_; }}};
};

TEST_F(Choice, ListsWhatTheServerMayOpenAndNothingElseCanBeNamed) {
  EXPECT_EQ(names(), (std::vector<std::string>{"images:DIR", "synthetic", "session:a.mcap"}));
  for (int rounds = 0; names().size() < 4 && rounds < 100; ++rounds) io_.run_one_for(50ms);
  EXPECT_EQ(names(), (std::vector<std::string>{"images:DIR", "openni2:usb1", "synthetic", "session:a.mcap"}));
  EXPECT_EQ(state().present(), "images:DIR");
  for (const char* name : {"oni:/etc/passwd", "session:../a.mcap", "synthetic:torso", "", "session:b.mcap"})
    EXPECT_FALSE(command(std::string(R"({"source": ")") + name + "\"}")) << name;
  EXPECT_FALSE(command("{"));
  EXPECT_TRUE(opened_.empty());
}

TEST_F(Choice, ASourceIsShownOnceItIsOpen) {
  ASSERT_TRUE(command(R"({"source": "session:a.mcap"})"));
  EXPECT_EQ(state().opening(), "session:a.mcap");
  progress_(0.5);
  EXPECT_DOUBLE_EQ(state().read_share(), 0.5);
  EXPECT_FALSE(command(R"({"source": "synthetic"})")) << "one at a time";
  EXPECT_EQ(shown_, 0);
  done_(std::unique_ptr<Origin>());
  EXPECT_EQ(shown_, 1);
  EXPECT_EQ(state().present(), "session:a.mcap");
  EXPECT_EQ(state().opening(), "");
}

TEST_F(Choice, ASourceThatCannotBeOpenedLeavesThePresentOne) {
  ASSERT_TRUE(command(R"({"source": "synthetic"})"));
  done_(Error{.what = "no memory", .where = "synthetic", .fix = "free some"});
  EXPECT_EQ(shown_, 0);
  EXPECT_EQ(state().present(), "images:DIR");
  EXPECT_NE(state().problem().find("no memory"), std::string::npos);
  ASSERT_TRUE(command(R"({"source": "synthetic"})"));
  EXPECT_EQ(state().problem(), "");
}

TEST(ServerSource, AnotherOneIsShownAndTheEndOfTheOldOneEndsNothing) {
  boost::asio::io_context io;
  auto server = server::Server::listen(io, {});
  ASSERT_TRUE(server.ok());
  std::vector<std::string> sources;  // of the images, by the last status before each
  int ends = 0;
  const auto viewer = (*server)->hub().join("viewer", "here", [] {});
  (*server)->hub().subscribe(viewer, {"/camera/*"});
  const auto camera = [&](std::uint64_t frames, const char* name) {
    return of_camera(io, std::make_unique<server::StillSource>(frames, 5ms, (*server)->clock()), name, {},
                     (*server)->clock());
  };
  const auto images_of = [&](const char* name) {
    int images = 0;
    std::string now;
    while (const auto message = (*server)->hub().next(viewer)) {
      msg::CaptureStatus status;
      if (message->topic.name == wire::kCameraStatus.name && status.ParseFromString(*message->payload))
        now = status.source();
      if (message->topic.name == wire::kCameraDepth.name) ++images;
    }
    return now == name ? images : 0;
  };
  (*server)->start(camera(1'000'000, "first"), [&] { ++ends; });
  for (int rounds = 0; images_of("first") == 0 && rounds < 100; ++rounds) io.run_for(100ms);
  (*server)->replace(camera(3, "second"));
  io.run_for(500ms);
  EXPECT_EQ(ends, 1) << "the new one has ended, and it alone";
  EXPECT_GT(images_of("second"), 0);
  (*server)->stop("the test ends");
  io.run_for(1s);
}

TEST(ServerSource, TheExposureOfACameraIsSetWithinItsLimits) {
  boost::asio::io_context io;
  const auto work = boost::asio::make_work_guard(io);
  const auto clock = wire::SessionClock::anchored_to_wall_clock();
  auto source = capture::open_source("synthetic", {.clock = clock});
  ASSERT_TRUE(source.ok());
  const auto origin = of_camera(io, std::move(*source), "synthetic", {}, clock);
  origin->start(
      {.on_message = [](const wire::Message&) {}, .on_end = [] {}, .is_wanted = [](std::string_view) { return true; }});
  const Resource exposure = origin->offer().resources.at(kExposure.topic.name);
  const auto state = [&] {
    msg::ExposureState now;
    now.CopyFrom(*exposure.state());
    return now;
  };
  const auto set = [&](const std::string& json) {
    bool done = false;
    exposure.change(json, "", [&](const Result<void>& outcome) { done = outcome.ok(); });
    return done;
  };
  EXPECT_FALSE(set(R"({"exposure": 5})")) << "it is not known yet what may be set";
  for (int rounds = 0; !state().offered() && rounds < 100; ++rounds) io.run_one_for(100ms);
  EXPECT_TRUE(state().automatic());
  EXPECT_EQ(state().unit(), "ms");
  for (const char* wrong : {R"({"exposure": 1000})", R"({"gain": 0})", R"({"gain": "NaN"})", "{"})
    EXPECT_FALSE(set(wrong)) << wrong;
  EXPECT_TRUE(set(R"({"automatic": false, "exposure": 5, "gain": 2})"));
  EXPECT_FALSE(state().automatic());
  EXPECT_DOUBLE_EQ(state().exposure(), 5.0);
  origin->stop();
}

}  // namespace
}  // namespace telepalp::origin
