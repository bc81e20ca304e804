// Sessions that are opened for one reader: the network thread goes on while their files are read.

#include "server/origin/reading.h"

#include <gtest/gtest.h>

#include <future>
#include <thread>

namespace telepalp::origin {
namespace {

using namespace std::chrono_literals;

/// An origin that counts its starts.
class CountedOrigin final : public Origin {
 public:
  explicit CountedOrigin(int& starts) : starts_(starts) {}
  void start(Handlers) override { ++starts_; }
  void stop() override {}
  void show_again(std::string_view) override {}
  [[nodiscard]] bool is_still() const override { return false; }
  [[nodiscard]] bool withholds(const wire::Topic&, std::size_t) const override { return false; }
  [[nodiscard]] bool chooses_prediction() const override { return false; }
  void let_predict(bool) override {}
  [[nodiscard]] std::uint64_t images() const override { return 0; }
  [[nodiscard]] std::string in_words(const msg::CaptureStatus&) const override { return {}; }
  [[nodiscard]] Offer offer() override {
    Offer offer;
    offer.resources[kNotes.topic.name] = {.state = [] { return state_message(msg::SessionNotes()); }};
    return offer;
  }

 private:
  int& starts_;
};

/// Readings whose sessions are opened when the test says so.
class Opened : public testing::Test {
 protected:
  Result<std::unique_ptr<Origin>> origin() { return std::unique_ptr<Origin>(std::make_unique<CountedOrigin>(starts_)); }

  boost::asio::io_context io_;
  std::vector<Progress> progress_;
  std::vector<OpenedOrigin> done_;
  int starts_ = 0;
  Readings readings_{io_,
                     [this](const ReadingSpec&, Progress progress, OpenedOrigin done) {
                       progress_.push_back(std::move(progress));
                       done_.push_back(std::move(done));
                     },
                     {},
                     [] { return session_time(1); }};
};

TEST_F(Opened, AReaderIsToldHowFarTheFileHasBeenReadAndThenHasTheSession) {
  const auto reading = readings_.join("a", {.session = "long.mcap"});
  EXPECT_EQ(reading->state().phase(), msg::ReadingState::PHASE_OPENING);
  EXPECT_EQ(reading->state().session(), "long.mcap");
  progress_.at(0)(0.4);
  EXPECT_DOUBLE_EQ(reading->state().read_share(), 0.4);
  EXPECT_TRUE(reading->offer().resources.contains(kReading.topic.name));
  EXPECT_FALSE(reading->offer().resources.contains(kNotes.topic.name));
  done_.at(0)(origin());
  EXPECT_EQ(reading->state().phase(), msg::ReadingState::PHASE_OPEN);
  EXPECT_TRUE(reading->offer().resources.contains(kNotes.topic.name));
}

TEST_F(Opened, ItBeginsOnceItIsOpenAndTheReaderHasSubscribedInEitherOrder) {
  const auto patient = readings_.join("a", {});
  patient->subscriptions_changed();
  io_.run_for(200ms);
  EXPECT_EQ(starts_, 0);
  done_.at(0)(origin());
  EXPECT_EQ(starts_, 1) << "the reader has waited";
  const auto late = readings_.join("b", {});
  done_.at(1)(origin());
  EXPECT_EQ(starts_, 1) << "nobody has subscribed";
  late->subscriptions_changed();
  io_.restart();
  io_.run_for(200ms);
  EXPECT_EQ(starts_, 2);
}

TEST_F(Opened, AFailureIsToldToItsReaderAlone) {
  const auto one = readings_.join("a", {});
  const auto other = readings_.join("b", {});
  done_.at(0)(Error{.what = "no session", .where = "a.mcap", .fix = "give another file"});
  EXPECT_EQ(one->state().phase(), msg::ReadingState::PHASE_FAILED);
  EXPECT_NE(one->state().problem().find("no session"), std::string::npos);
  EXPECT_EQ(other->state().phase(), msg::ReadingState::PHASE_OPENING);
}

TEST_F(Opened, ASessionWhoseReaderHasLeftIsNotBegun) {
  auto reading = readings_.join("a", {});
  reading->subscriptions_changed();
  reading.reset();
  progress_.at(0)(0.5);
  done_.at(0)(origin());
  io_.run_for(200ms);
  EXPECT_EQ(starts_, 0);
}

TEST(OpeningPool, TheNetworkThreadGoesOnWhileAFileIsRead) {
  boost::asio::io_context io;
  const auto work = boost::asio::make_work_guard(io);
  OpeningPool pool(io);
  std::promise<void> network_went_on;
  std::thread::id opener;
  std::vector<double> told;
  std::optional<int> opened;
  pool.run<int>(
      [&](const Progress& progress) -> Result<int> {
        opener = std::this_thread::get_id();
        progress(0.5);
        network_went_on.get_future().wait();  // an opener on the network thread would wait for itself
        return 7;
      },
      [&](double share) {
        told.push_back(share);
        network_went_on.set_value();
      },
      [&](const Result<int>& result) {
        opened = *result;
        io.stop();
      });
  io.run_for(20s);
  EXPECT_EQ(opened, 7);
  EXPECT_EQ(told, std::vector<double>{0.5});
  EXPECT_NE(opener, std::this_thread::get_id());
}

TEST(OpeningPool, ItsEndDropsWhatIsStillBeingOpened) {
  boost::asio::io_context io;
  bool done = false;
  {
    OpeningPool pool(io);
    pool.run<int>([](const Progress&) -> Result<int> { return 7; }, [](double) {},
                  [&](const Result<int>&) { done = true; });
  }
  io.run_for(50ms);
  EXPECT_FALSE(done);
}

}  // namespace
}  // namespace telepalp::origin
