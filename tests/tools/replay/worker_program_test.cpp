// telepalp-replay --workers and telepalp-worker around a real NATS server, with bad orders and answers from others.

#include <gtest/gtest.h>
#include <messages/sweep.pb.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <thread>

#include "support/nats/streams.h"
#include "tests/support/child_process.h"
#include "tools/replay/workers/cell_answer.h"
#include "tools/replay/workers/sweep_subjects.h"
#include "where.h"

namespace {

using namespace telepalp;
using namespace telepalp::replay;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr const char* kServer = "/usr/sbin/nats-server";  // of Debian's package

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

template <class Condition>
bool comes_true(Condition condition, std::chrono::seconds patience = 60s) {
  for (const auto end = std::chrono::steady_clock::now() + patience; std::chrono::steady_clock::now() < end;
       std::this_thread::sleep_for(50ms))
    if (condition()) return true;
  return condition();
}

class WorkerProgram : public testing::Test {
 protected:
  void SetUp() override {
    if (::access(kServer, X_OK) != 0) GTEST_SKIP() << "nats-server is not installed";
  }
  [[nodiscard]] fs::path in(const std::string& name) const { return folder_.path() / name; }

  void start_cluster(const std::string& limits = "") {
    std::ofstream(in("nats.conf")) << "listen: 127.0.0.1:" << port_ << "\njetstream { store_dir: '"
                                   << in("store").string() << "'\n"
                                   << limits << " }\n";
    server_.emplace(kServer, std::vector<std::string>{"-c", in("nats.conf")}, in("nats.log"));
    ASSERT_TRUE(comes_true([&] { return bytes_of(in("nats.log")).find("Server is ready") != std::string::npos; }))
        << bytes_of(in("nats.log"));
    auto connection = nats::NatsConnection::open({.address = {.url = url_}, .name = "test"});
    ASSERT_TRUE(connection) << to_string(connection.error());
    connection_ = *std::move(connection);
    streams_ = *nats::Streams::open(*connection_);
  }
  [[nodiscard]] std::vector<std::string> sweep_words(std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"synthetic:torso,width=160",
                                   "--seconds",
                                   "1",
                                   "--sweep",
                                   "delay=0:10:50",
                                   "--out",
                                   in("out"),
                                   "--workers",
                                   url_};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  [[nodiscard]] std::unique_ptr<support::ChildProcess> start(const std::string& program,
                                                             const std::vector<std::string>& words,
                                                             const std::string& log) const {
    return std::make_unique<support::ChildProcess>(TELEPALP_BINARY_DIR "/bin/" + program, words, in(log));
  }
  [[nodiscard]] auto start_worker(const std::string& name) const {
    return start("telepalp-worker", {"--connect", url_, "--name", name, "--cache", in("cache")}, name + ".log");
  }
  [[nodiscard]] std::vector<std::string> orders() const {
    const auto subjects = streams_->subjects(kOrders, kOrderSubjects);
    return subjects ? *subjects : std::vector<std::string>();
  }
  /// Replaces a stored order by one that `spoil` has changed.
  void spoil(const std::string& subject, const std::function<void(msg::SweepOrder&)>& change) const {
    const auto stored = streams_->newest(kOrders, subject);
    ASSERT_TRUE(stored && *stored) << subject;
    msg::SweepOrder order;
    ASSERT_TRUE(order.ParseFromString(**stored));
    change(order);
    ASSERT_TRUE(streams_->store(subject, order.SerializeAsString()));
  }

  support::TemporaryFolder folder_;
  std::string port_ = std::to_string(20000 + (::getpid() + 7) % 20000);
  std::string url_ = "nats://127.0.0.1:" + port_;
  std::optional<support::ChildProcess> server_;
  std::unique_ptr<nats::NatsConnection> connection_;
  std::unique_ptr<nats::Streams> streams_;
};

TEST_F(WorkerProgram, PoisonedOrdersAreRemovedAndTheRestOfTheSweepGoesOn) {
  start_cluster();
  const auto sweep = start("telepalp-replay", sweep_words(), "sweep.log");
  ASSERT_TRUE(comes_true([&] { return orders().size() == 6; })) << bytes_of(in("sweep.log"));
  const std::vector<std::string> subjects = orders();
  ASSERT_TRUE(streams_->store(subjects[0], "garbage"));
  ASSERT_TRUE(streams_->store(subjects[1], std::string(900'000, 'x')));
  spoil(subjects[2], [](msg::SweepOrder& order) { order.set_source("images:/etc"); });
  spoil(subjects[3], [](msg::SweepOrder& order) {
    order.set_scene_text("name: 'x' patient_surface { static_model { file: '/etc/passwd' } }");
  });
  const auto worker = start_worker("w");
  EXPECT_EQ(sweep->wait(120s), 2) << bytes_of(in("sweep.log"));
  const std::string said = bytes_of(in("sweep.log"));
  EXPECT_NE(said.find("4 runs were given up by the workers"), std::string::npos) << said;
  for (const char* why : {"its bytes are no order", "it has 900000 B", "neither a recording with a digest nor",
                          "the scene names a file", "fix: "})
    EXPECT_NE(said.find(why), std::string::npos) << why << "\n" << said;
  EXPECT_TRUE(orders().empty()) << "bad orders leave the queue";
  std::size_t made = 0;
  for (const auto& file : fs::directory_iterator(in("out") / "cells")) made += file.is_regular_file() ? 1U : 0U;
  EXPECT_EQ(made, 2U);
  EXPECT_NE(bytes_of(in("w.log")).find("is removed from the queue, because it was delivered 3 times"),
            std::string::npos);

  const auto again = start("telepalp-replay", sweep_words(), "again.log");
  EXPECT_EQ(again->wait(120s), 0) << bytes_of(in("again.log"));
  EXPECT_NE(bytes_of(in("again.log")).find("2 of 6 runs of the sweep were finished before"), std::string::npos);
}

TEST_F(WorkerProgram, AnswersOfStrangersAreIgnored) {
  start_cluster();
  const auto sweep = start("telepalp-replay", sweep_words(), "sweep.log");
  ASSERT_TRUE(comes_true([&] { return orders().size() == 6; })) << bytes_of(in("sweep.log"));
  const std::optional<CellPlace> place = place_of(orders()[0]);
  ASSERT_TRUE(place);
  msg::SweepOrder order;
  ASSERT_TRUE(order.ParseFromString(**streams_->newest(kOrders, orders()[0])));
  const std::string subject = answer_subject(place->sweep, place->cell);
  ASSERT_TRUE(streams_->store(subject, "garbage"));
  ASSERT_TRUE(streams_->store(
      subject, encode(CellAnswer{.build = order.build(), .cell = place->cell, .report = "{\"identity\": \"x\"}"})));
  const auto worker = start_worker("w");
  EXPECT_EQ(sweep->wait(120s), 0) << bytes_of(in("sweep.log"));
  EXPECT_NE(bytes_of(in("sweep.log")).find("answer ignored: "), std::string::npos) << bytes_of(in("sweep.log"));
}

TEST_F(WorkerProgram, SweepAndWorkerOfAnotherVersionAreToldSo) {
  start_cluster();
  const auto sweep = start("telepalp-replay", sweep_words(), "sweep.log");
  ASSERT_TRUE(comes_true([&] { return orders().size() == 6; })) << bytes_of(in("sweep.log"));
  const Presence other{.name = "old", .build = "telepalp 0.0.1, commit 0"};
  connection_->publish(kWorkerIsHere, encode(other));
  EXPECT_TRUE(comes_true([&] {
    return bytes_of(in("sweep.log")).find("the worker old is of another version, telepalp 0.0.1") != std::string::npos;
  })) << bytes_of(in("sweep.log"));
  const auto worker = start_worker("w");
  ASSERT_TRUE(comes_true([&] { return bytes_of(in("w.log")).find("ready: ") != std::string::npos; }));
  connection_->publish(kSweepIsHere, encode(other));
  EXPECT_TRUE(comes_true([&] {
    return bytes_of(in("w.log")).find("a sweep of another version waits for workers: telepalp 0.0.1") !=
           std::string::npos;
  })) << bytes_of(in("w.log"));
  EXPECT_EQ(sweep->wait(120s), 0) << bytes_of(in("sweep.log"));
}

TEST_F(WorkerProgram, AFullClusterIsSaidWithItsFix) {
  start_cluster("max_file_store: 2000");
  const auto sweep = start("telepalp-replay", sweep_words(), "sweep.log");
  EXPECT_EQ(sweep->wait(60s), 2);
  const std::string said = bytes_of(in("sweep.log"));
  EXPECT_NE(said.find("fix: JetStream is full: give it more room"), std::string::npos) << said;
}

TEST_F(WorkerProgram, ARecordingIsSentInChunksAndADamagedOneIsSentAgain) {
  start_cluster();
  const fs::path shipped = fs::path(TELEPALP_SOURCE_DIR) / "deploy/demo_data/oni";
  fs::path recording;
  for (const auto& file : fs::recursive_directory_iterator(shipped))
    if (file.path().extension() == ".oni") recording = file.path();
  ASSERT_FALSE(recording.empty());
  std::vector<std::string> words = sweep_words();
  words[0] = recording;
  words[4] = "delay=0,20";
  const auto sweep = start("telepalp-replay", words, "sweep.log");
  ASSERT_TRUE(comes_true([&] { return orders().size() == 2; })) << bytes_of(in("sweep.log"));
  const auto chunks = streams_->subjects(kSweeps, kSourceSubjects);
  ASSERT_TRUE(chunks && !chunks->empty());
  const auto chunk = streams_->newest(kSweeps, chunks->front());
  ASSERT_TRUE(chunk && *chunk);
  ASSERT_TRUE(streams_->store(chunks->front(), std::string((*chunk)->size(), 'x')));  // the same size
  const auto worker = start_worker("w");
  EXPECT_EQ(sweep->wait(120s), 2) << bytes_of(in("sweep.log"));
  EXPECT_NE(bytes_of(in("sweep.log")).find("the recording has another digest than the order states"), std::string::npos)
      << bytes_of(in("sweep.log"));
  const auto again = start("telepalp-replay", words, "again.log");
  EXPECT_EQ(again->wait(120s), 0) << bytes_of(in("again.log"));
  std::vector<std::string> alone{words.begin(), words.end() - 2};
  alone[6] = in("alone");
  EXPECT_EQ(start("telepalp-replay", alone, "alone.log")->wait(120s), 0) << bytes_of(in("alone.log"));
  for (const char* file : {"sweep.csv", "sweep.json", "sweep.txt", "cells/000.json", "cells/001.json"})
    EXPECT_TRUE(bytes_of(in("out") / file) == bytes_of(in("alone") / file)) << file;
}

}  // namespace
