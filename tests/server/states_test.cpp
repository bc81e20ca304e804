// States of resources as latched topics.

#include <gtest/gtest.h>

#include <thread>

#include "messages/playback.pb.h"
#include "server/origin/state_publisher.h"

namespace telepalp::origin {
namespace {

using namespace std::chrono_literals;

/// One resource, whose state is a number, and its publisher.
class States : public testing::Test {
 protected:
  hub::SubscriberId viewer(const std::string& topic = std::string(kNotes.topic.name)) {
    const hub::SubscriberId id = hub_.join("viewer", "here", [] {});
    states_.expect_subscriber({topic});
    hub_.subscribe(id, {topic});
    return id;
  }
  /// The number in the next message of `viewer`; 0: there is none.
  std::uint64_t heard(hub::SubscriberId viewer) {
    const std::optional<wire::Message> message = hub_.next(viewer);
    msg::SessionNotes notes;
    return message && notes.ParseFromString(*message->payload) ? notes.last_number() : 0;
  }

  std::uint64_t number_ = 1;
  int looked_ = 0;
  std::int64_t clock_ns_ = 100;
  hub::Hub hub_;
  Resources resources_{{kNotes.topic.name, {.state = [this] {
                          ++looked_;
                          msg::SessionNotes notes;
                          notes.set_last_number(number_);
                          return state_message(notes);
                        }}}};
  StatePublisher states_{hub_, resources_, [this] { return session_time(++clock_ns_); }};
};

TEST_F(States, ANewcomerGetsTheNewestAtOnceAndOnlyOnce) {
  const auto first = viewer();
  EXPECT_EQ(heard(first), 1u);
  number_ = 2;  // nobody has looked since
  const auto second = viewer();
  EXPECT_EQ(heard(second), 2u);
  EXPECT_EQ(heard(second), 0u);
  EXPECT_EQ(heard(first), 2u);
}

TEST_F(States, WhatHasNotChangedIsNotPublishedAgain) {
  const auto one = viewer();
  EXPECT_EQ(heard(one), 1u);
  const SessionTime at = states_.published_at(kNotes.topic.name);
  states_.commanded();
  EXPECT_EQ(heard(one), 0u);
  EXPECT_EQ(states_.published_at(kNotes.topic.name), at);
  number_ = 2;
  states_.commanded();
  EXPECT_EQ(heard(one), 2u) << "a command's effect is told at once";
  EXPECT_GT(states_.published_at(kNotes.topic.name), at);
}

TEST_F(States, AChangeWithoutACommandIsPublishedWhenItIsDue) {
  const auto one = viewer();
  EXPECT_EQ(heard(one), 1u);
  number_ = 2;
  states_.look();
  EXPECT_EQ(heard(one), 0u) << "the last look was less than its period ago";
  std::this_thread::sleep_for(kNotes.every);
  states_.look();
  EXPECT_EQ(heard(one), 2u);
}

TEST_F(States, WhatNobodySeesIsNotLookedAt) {
  states_.look();
  states_.commanded();
  EXPECT_EQ(looked_, 0);
  const auto one = viewer();
  hub_.leave(one);
  states_.commanded();
  EXPECT_EQ(looked_, 1);
}

TEST_F(States, AResourceThatTheServerDoesNotHaveIsNotPublished) {
  const auto one = viewer(std::string(kRecording.topic.name));
  states_.commanded();
  EXPECT_FALSE(hub_.next(one));
  EXPECT_EQ(states_.published_at(kRecording.topic.name), SessionTime{});
}

}  // namespace
}  // namespace telepalp::origin
