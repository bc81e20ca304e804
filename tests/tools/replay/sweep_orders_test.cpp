// The messages between sweeps and workers, and what a sweep knows of its cells: bytes in, values out.

#include <gtest/gtest.h>
#include <messages/sweep.pb.h>

#include <functional>
#include <limits>

#include "tools/replay/commands/again.h"
#include "tools/replay/commands/request.h"
#include "tools/replay/workers/cell_answer.h"
#include "tools/replay/workers/cell_maker.h"
#include "tools/replay/workers/cell_order.h"
#include "tools/replay/workers/inbox.h"
#include "tools/replay/workers/present_workers.h"
#include "tools/replay/workers/sweep_board.h"
#include "tools/replay/workers/sweep_subjects.h"
#include "tools/replay/workers/time_left.h"

namespace {

using namespace telepalp;
using namespace telepalp::replay;
using namespace std::chrono_literals;

const std::string kSha(64, 'a');
const std::string kBuild = "telepalp 9, commit 1";

CellOrder an_order() {
  return {.build = kBuild,
          .sweep = "0123456789abcdef",
          .cell = "fedcba9876543210",
          .source = "/home/anna/patient one.mcap",
          .source_digest = "0011223344556677",
          .recording = Recording{.kind = Recording::Kind::Oni, .sha256 = kSha, .size_B = 1'000'001, .chunk_B = 4096},
          .scene_text = "name: 'x'",
          .options = {{"scene", "palpation"}, {"seconds", "2"}, {"loss", "5%"}},
          .assertions = "frames>10",
          .at = {{"delay", 50.0}, {"loss", 0.1 + 0.2}}};
}

OrderRules rules() { return {.build = kBuild, .options = names_of_run_options()}; }

TEST(CellOrder, ComesBackAsItWasSent) {
  const CellOrder sent = an_order();
  const Result<CellOrder> came = parse_order(encode(sent), rules());
  ASSERT_TRUE(came) << to_string(came.error());
  EXPECT_EQ(*came, sent);
  EXPECT_EQ(came->recording->chunks(), 245U);
  EXPECT_EQ(came->recording->size_of_chunk(0), 4096U);
  EXPECT_EQ(came->recording->size_of_chunk(244), 1'000'001U - 244U * 4096U);
}

TEST(CellOrder, ItsValuesKeepTheirLastBitOnTheCommandLine) {
  const Result<std::vector<SweepAxis>> axes = parse_axes(axes_of(an_order()));
  ASSERT_TRUE(axes) << to_string(axes.error());
  EXPECT_EQ((*axes)[1].values, std::vector{0.1 + 0.2});
  EXPECT_NE((*axes)[1].values, std::vector{0.3});
}

TEST(CellOrder, NeitherSourceNorSceneNameReachesTheCommandLineAsAFile) {
  for (const std::string& word : command_of(an_order(), "cache/a.oni", "cache/s.textproto")) {
    EXPECT_EQ(word.find("anna"), word.npos) << word;
    EXPECT_EQ(word.find("palpation"), word.npos) << word;
  }
}

struct BadOrder {
  const char* name;
  std::function<void(msg::SweepOrder&)> spoil;
};
const BadOrder kBadOrders[] = {
    {"another build", [](auto& order) { order.set_build("telepalp 8"); }},
    {"no build", [](auto& order) { order.clear_build(); }},
    {"a cell that is a path", [](auto& order) { order.set_cell("../../etc/passwd"); }},
    {"a sweep with a wildcard", [](auto& order) { order.set_sweep("*"); }},
    {"a recording named by a path", [](auto& order) { order.mutable_recording()->set_sha256("../../../etc/passwd"); }},
    {"a recording of an unknown kind",
     [](auto& order) { order.mutable_recording()->set_kind(static_cast<msg::SweepRecording::Kind>(77)); }},
    {"an empty recording", [](auto& order) { order.mutable_recording()->set_size_b(0); }},
    {"a recording of 16 EiB",
     [](auto& order) { order.mutable_recording()->set_size_b(std::numeric_limits<std::uint64_t>::max()); }},
    {"chunks of no size", [](auto& order) { order.mutable_recording()->set_chunk_b(0); }},
    {"chunks of 4 GiB", [](auto& order) { order.mutable_recording()->set_chunk_b(0xffffffff); }},
    {"a file of the worker as source", [](auto& order) { order.clear_recording(); }},
    {"a folder of the worker as source",
     [](auto& order) {
       order.clear_recording();
       order.set_source("images:/home");
     }},
    {"a patient's mesh on the worker",
     [](auto& order) {
       order.clear_recording();
       order.set_source("synthetic:/etc/passwd,motion=regular");
     }},
    {"a source with a line break", [](auto& order) { order.set_source("a\nb.mcap"); }},
    {"an option that writes a file", [](auto& order) { (*order.mutable_options())["out"] = "/tmp/x"; }},
    {"an option that begins with dashes", [](auto& order) { (*order.mutable_options())["--help"] = "x"; }},
    {"an option with a NUL", [](auto& order) { (*order.mutable_options())["loss"] = std::string("5%\0x", 4); }},
    {"an empty option", [](auto& order) { (*order.mutable_options())["loss"] = ""; }},
    {"a huge option", [](auto& order) { (*order.mutable_options())["loss"] = std::string(5000, '1'); }},
    {"a huge scene", [](auto& order) { order.set_scene_text(std::string(300'000, '#')); }},
    {"no place on the axes", [](auto& order) { order.clear_at(); }},
    {"a place that is not a number", [](auto& order) { order.mutable_at(0)->set_value(std::nan("")); }},
    {"an axis that is an option", [](auto& order) { order.mutable_at(0)->set_axis("--out"); }},
    {"a thousand axes",
     [](auto& order) {
       for (int i = 0; i < 1000; ++i) *order.add_at() = order.at(0);
     }},
};

TEST(CellOrder, IsRefusedWithItsReasonIfAnythingInItIsBad) {
  for (const BadOrder& bad : kBadOrders) {
    msg::SweepOrder message;
    ASSERT_TRUE(message.ParseFromString(encode(an_order())));
    bad.spoil(message);
    const Result<CellOrder> order = parse_order(message.SerializeAsString(), rules());
    ASSERT_FALSE(order) << bad.name;
    EXPECT_FALSE(order.error().fix.empty()) << bad.name;
  }
  EXPECT_FALSE(parse_order("garbage", rules()));
  EXPECT_FALSE(parse_order("", rules()));
  EXPECT_FALSE(parse_order(std::string(kMostOrder_B + 1, '\0'), rules()));
}

TEST(CellOrder, ASceneThatNamesAFileIsKnown) {
  EXPECT_FALSE(names_a_file("name: 'x' patient_surface { streamed {} } effects { organ { unit_m: 1 } }"));
  EXPECT_TRUE(names_a_file("name: 'x' patient_surface { static_model { file: '/etc/passwd' } }"));
  EXPECT_TRUE(names_a_file("effects { organ { file: 'liver.ply' } }"));
  EXPECT_TRUE(names_a_file("no scene at all {")) << "nobody knows what it names";
}

TEST(CellOrder, ASceneOfTheLibraryIsTakenOnlyWithItsText) {
  EXPECT_FALSE(scene_of_library("palpation", "another text"));
  EXPECT_FALSE(scene_of_library("../palpation", ""));
  EXPECT_FALSE(scene_of_library("", ""));
}

TEST(CellAnswer, ComesBackAndIsRefusedIfDamaged) {
  const CellAnswer sent{.build = kBuild, .cell = "fedcba9876543210", .report = "{}", .worker = "w"};
  const std::string bytes = encode(sent);
  const Result<CellAnswer> came = parse_answer(bytes, kBuild, sent.cell);
  ASSERT_TRUE(came) << to_string(came.error());
  EXPECT_EQ(came->report, "{}");
  EXPECT_EQ(came->worker, "w");
  EXPECT_FALSE(parse_answer(bytes, "another build", sent.cell));
  EXPECT_FALSE(parse_answer(bytes, kBuild, "0000000000000000"));
  EXPECT_FALSE(parse_answer("garbage", kBuild, sent.cell));
  EXPECT_FALSE(parse_answer(encode(CellAnswer{.build = kBuild, .cell = sent.cell}), kBuild, sent.cell));
  msg::SweepAnswer message;
  ASSERT_TRUE(message.ParseFromString(bytes));
  message.set_report("{} ");
  const Result<CellAnswer> damaged = parse_answer(message.SerializeAsString(), kBuild, sent.cell);
  ASSERT_FALSE(damaged);
  EXPECT_NE(damaged.error().what.find("digest"), std::string::npos);
}

TEST(SweepCommand, TheLineToResumeWithHasNoPassword) {
  for (const std::vector<std::string>& workers :
       {std::vector<std::string>{"--workers", "nats://anna:secret@host:4222?creds=a.creds"},
        {"--workers=nats://anna:secret@host:4222?creds=a.creds"}}) {
    std::vector<std::string> words{"synthetic", "--sweep", "delay=0:50:300"};
    words.insert(words.end(), workers.begin(), workers.end());
    std::vector<const char*> all{"telepalp-replay"};
    for (const std::string& word : words) all.push_back(word.c_str());
    const auto arguments = program::read_arguments(usage(), static_cast<int>(all.size()), all.data());
    ASSERT_TRUE(arguments && *arguments);
    const Result<Request> request = read_command_line(**arguments, words);
    ASSERT_TRUE(request) << to_string(request.error());
    EXPECT_EQ(request->command.find("anna"), std::string::npos) << request->command;
    EXPECT_EQ(request->command.find("secret"), std::string::npos) << request->command;
    EXPECT_NE(request->command.find("nats://host:4222?creds=a.creds"), std::string::npos) << request->command;
    EXPECT_EQ(request->workers->url, "nats://anna:secret@host:4222");
  }
}

TEST(Inbox, HoldsABoundedNumberOfBytes) {
  Inbox inbox;
  const std::string large(Inbox::kMost_B / 4, 'x');
  for (int i = 0; i < 10; ++i) inbox.put({.subject = "s", .payload = large, .reply_to = ""});
  EXPECT_EQ(inbox.take().size(), 3U);
  EXPECT_TRUE(inbox.take().empty());
  inbox.put({.subject = "s", .payload = large, .reply_to = ""});
  EXPECT_EQ(inbox.take().size(), 1U) << "there is room again";
}

TEST(SweepSubjects, ThePlaceOfACellIsReadFromItsSubject) {
  const std::string order = order_subject(kBuild, "0123456789abcdef", "fedcba9876543210");
  EXPECT_EQ(place_of(order)->cell, "fedcba9876543210");
  EXPECT_EQ(place_of(order)->sweep, "0123456789abcdef");
  EXPECT_EQ(place_of(answer_subject("0123456789abcdef", "fedcba9876543210"))->cell, "fedcba9876543210");
  for (const char* wrong : {"", "telepalp-sweep.cell.x", "telepalp-sweep.cell.b.0123456789abcdef.fedcba987654321*",
                            "telepalp-sweep.answer.0123456789abcdefXfedcba9876543210"})
    EXPECT_FALSE(place_of(wrong)) << wrong;
  EXPECT_NE(build_token(kBuild), build_token("telepalp 9, commit 2"));
}

TEST(SweepBoard, ThePhaseOfACellAfterEachEvent) {
  std::string matrix;
  for (std::size_t phase = 0; phase < kCellPhases; ++phase)
    for (std::size_t event = 0; event < kCellEvents; ++event) {
      const auto from = static_cast<CellPhase>(phase);
      const auto on = static_cast<CellEvent>(event);
      matrix +=
          std::string(name(from)) + " + " + std::string(name(on)) + " -> " + std::string(name(next(from, on))) + "\n";
    }
  EXPECT_EQ(matrix,
            "Missing + Order -> Ordered\n"
            "Missing + Report -> Finished\n"
            "Missing + Refusal -> Missing\n"
            "Missing + Vanished -> Missing\n"
            "Ordered + Order -> Ordered\n"
            "Ordered + Report -> Finished\n"
            "Ordered + Refusal -> Refused\n"
            "Ordered + Vanished -> Missing\n"
            "Finished + Order -> Finished\n"
            "Finished + Report -> Finished\n"
            "Finished + Refusal -> Finished\n"
            "Finished + Vanished -> Finished\n"
            "Refused + Order -> Refused\n"
            "Refused + Report -> Finished\n"
            "Refused + Refusal -> Refused\n"
            "Refused + Vanished -> Refused\n");
}

TEST(SweepBoard, CountsItsCellsAndIsSettledWhenEachIsFinishedOrRefused) {
  SweepBoard board({"a", "b", "b", "c"});
  EXPECT_EQ(board.size(), 3U) << "equal cells are one";
  EXPECT_EQ(board.in(CellPhase::Missing), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_FALSE(board.on("d", CellEvent::Report)) << "of another grid";
  for (const char* cell : {"a", "b", "c"}) EXPECT_TRUE(board.on(cell, CellEvent::Order));
  EXPECT_TRUE(board.on("a", CellEvent::Report));
  EXPECT_FALSE(board.on("a", CellEvent::Report)) << "done twice changes nothing";
  EXPECT_TRUE(board.on("c", CellEvent::Refusal));
  EXPECT_FALSE(board.is_settled());
  EXPECT_EQ(board.in(CellPhase::Ordered), std::vector<std::string>{"b"});
  EXPECT_TRUE(board.on("b", CellEvent::Report));
  EXPECT_TRUE(board.is_settled());
  EXPECT_EQ(board.count(CellPhase::Finished), 2U);
  EXPECT_EQ(board.count(CellPhase::Refused), 1U);
}

TEST(TimeLeft, FollowsThePaceOfTheNewestCells) {
  TimeLeft left(100.0);
  EXPECT_FALSE(left.left_s(10, 130.0)) << "nobody knows before the first cell";
  for (int i = 1; i <= 40; ++i) left.finished(100.0 + 4.0 * i);
  EXPECT_NEAR(*left.left_s(10, 260.0), 40.0, 1e-9);
  for (int i = 1; i <= 40; ++i) left.finished(260.0 + 2.0 * i);  // a second worker has come
  EXPECT_NEAR(*left.left_s(10, 340.0), 20.0, 1e-9);
  EXPECT_GT(*left.left_s(10, 940.0), 150.0) << "nothing comes any more";
}

TEST(TimeLeft, IsSaidInWords) {
  EXPECT_EQ(span_of_time(0.2), "0 s");
  EXPECT_EQ(span_of_time(89.0), "89 s");
  EXPECT_EQ(span_of_time(100.0), "2 min");
  EXPECT_EQ(span_of_time(12'000.0), "3 h 20 min");
}

TEST(PresentWorkers, AreThoseThatHaveSpokenLately) {
  PresentWorkers workers;
  const PresentWorkers::TimePoint start{};
  EXPECT_TRUE(workers.hear({.name = "a", .build = kBuild}, start));
  EXPECT_FALSE(workers.hear({.name = "a", .build = kBuild}, start + 2s));
  EXPECT_TRUE(workers.hear({.name = "b", .build = "another"}, start));
  EXPECT_EQ(workers.count(kBuild), 1U);
  workers.forget_silent(start + 8s);
  EXPECT_EQ(workers.count(kBuild), 1U);
  EXPECT_EQ(workers.count("another"), 0U);
  EXPECT_FALSE(parse_presence(encode(Presence{.name = std::string(300, 'x'), .build = kBuild})));
}

}  // namespace
