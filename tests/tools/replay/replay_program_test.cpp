// telepalp-replay as its user runs it.

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <thread>
#include <utility>

#include "haptic_station/core/journal/journal_file.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace {

using namespace telepalp;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class ReplayProgram : public testing::Test {
 protected:
  std::string in(const std::string& name) const { return (folder_.path() / name).string(); }

  /// Exit code and output of a program.
  std::pair<int, std::string> run(const std::string& program, std::vector<std::string> words) const {
    words.insert(words.begin(), {"-c", "exec \"$0\" \"$@\" >&2", TELEPALP_BINARY_DIR "/bin/" + program});
    support::ChildProcess process("/bin/sh", words, in("log"));
    const std::optional<int> code = process.wait(120s);
    return {code.value_or(-1), bytes_of(in("log"))};
  }
  std::pair<int, std::string> replay(std::vector<std::string> words) const {
    words.insert(words.begin(), {"synthetic:torso,motion=irregular", "--seconds", "2"});
    return run("telepalp-replay", words);
  }

 private:
  support::TemporaryFolder folder_;
};

TEST_F(ReplayProgram, WritesTheSameBytesTwiceAndFindsWhereTwoRunsDiffer) {
  const std::vector<std::string> network{"--delay-ms", "80", "--jitter-ms", "15", "--loss", "5%", "--burst", "4"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), network.begin(), network.end());
    return more;
  };
  const auto [first, said] = replay(with({"--out", in("a"), "--threads", "1"}));
  ASSERT_EQ(first, 0) << said;
  ASSERT_EQ(replay(with({"--out", in("b"), "--threads", "2"})).first, 0);
  for (const char* file : {"session.mcap", "unimpaired.mcap", "report.txt", "report.json"}) {
    EXPECT_GT(fs::file_size(in("a") + "/" + file), 100U);
    EXPECT_TRUE(bytes_of(in("a") + "/" + file) == bytes_of(in("b") + "/" + file)) << file;
  }
  EXPECT_EQ(run("telepalp-replay", {"diff", in("a/session.mcap"), in("b/session.mcap")}).first, 0);
  const auto [differs, where] = run("telepalp-replay", {"diff", in("a/unimpaired.mcap"), in("a/session.mcap")});
  EXPECT_EQ(differs, 1);
  EXPECT_NE(where.find("message "), std::string::npos) << where;
}

TEST_F(ReplayProgram, ItsSessionIsReadByTheReport) {
  ASSERT_EQ(replay({"--delay-ms", "40", "--out", in("a")}).first, 0);
  const auto [code, said] = run("telepalp-report", {in("a/session.mcap"), "--out", in("report.html")});
  EXPECT_EQ(code, 0) << said;
}

TEST_F(ReplayProgram, FailsWithTheReasonWhenAnAssertionFails) {
  const auto [failed, said] =
      replay({"--delay-ms", "200", "--assert", "surface_age_p50_s<0.1,frames>10", "--junit", in("junit.xml")});
  EXPECT_EQ(failed, 1);
  EXPECT_NE(said.find("FAILS: surface_age_p50_s<0.1  (surface_age_p50_s is 0."), std::string::npos) << said;
  const std::string junit = bytes_of(in("junit.xml"));
  EXPECT_NE(junit.find("tests=\"2\" failures=\"1\""), std::string::npos) << junit;
  EXPECT_EQ(replay({"--assert", "frames>10"}).first, 0);
}

TEST_F(ReplayProgram, SaysWhatIsMisspeltBeforeItRuns) {
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--assert", "force_rsme_N<1"},
                                                {"--sweep", "dealy=0,1"},
                                                {"--loss", "500%"},
                                                {"--outage", "10s"},
                                                {"--profile", "moon"},
                                                {"--hand", "left"},
                                                {"--depth-mode", "zip"},
                                                {"more"},
                                                {"--hand", "recorded"},
                                                {"--junit", in("none/junit.xml"), "--assert", "frames>1"},
                                                {"--sweep", "delay=0,50", "--check"},
                                                {"--sweep", "delay=100:50:0"},
                                                {"--scene", in("none.textproto")}}) {
    const auto [code, said] = replay(wrong);
    EXPECT_EQ(code, 2) << wrong.front() << said;
    EXPECT_NE(said.find("fix: "), std::string::npos) << said;
  }
}

TEST_F(ReplayProgram, ARunThatCannotBeMadeIsToldFromAFailedAssertion) {
  for (const std::vector<std::string>& unreadable : {std::vector<std::string>{in("none.oni"), "--assert", "frames>1"},
                                                     {in("none.mcap"), "--assert", "frames>1"},
                                                     {"synthetic:torso,motion=flying", "--sweep", "delay=0,50"},
                                                     {"diff", in("none.mcap"), in("none.mcap")}}) {
    const auto [code, said] = run("telepalp-replay", unreadable);
    EXPECT_EQ(code, 2) << unreadable.front() << said;
    EXPECT_NE(said.find("fix: "), std::string::npos) << said;
  }
}

TEST_F(ReplayProgram, ASweepWhoseAssertIsMisspeltSaysSoBeforeItRuns) {
  const auto [code, said] = replay(
      {"--sweep", "delay=0,100", "--assert", "force_rsme_N<1", "--out", in("sweep"), "--junit", in("junit.xml")});
  EXPECT_EQ(code, 2) << said;
  EXPECT_NE(said.find("'force_rsme_N' is not a metric; the nearest is force_rmse_N"), std::string::npos) << said;
  EXPECT_FALSE(fs::exists(in("sweep")));
  EXPECT_FALSE(fs::exists(in("junit.xml")));
}

TEST_F(ReplayProgram, AStormRefusesWhatItWouldIgnore) {
  for (const std::vector<std::string>& ignored : {std::vector<std::string>{"--assert", "frames>10"},
                                                  {"--delay-ms", "80"},
                                                  {"--scene", "skin"},
                                                  {"--seconds", "3"},
                                                  {"--json"},
                                                  {"synthetic:torso"}}) {
    std::vector<std::string> words{"--storm", "1"};
    words.insert(words.end(), ignored.begin(), ignored.end());
    const auto [code, said] = run("telepalp-replay", words);
    EXPECT_EQ(code, 2) << said;
    EXPECT_NE(said.find(ignored.front()), std::string::npos) << said;
  }
}

TEST_F(ReplayProgram, SweepsAGridIntoOneTable) {
  const auto [code, said] = replay({"--sweep", "delay=0,100", "loss=0,10%", "--out", in("sweep")});
  ASSERT_EQ(code, 0) << said;
  const std::string csv = bytes_of(in("sweep/sweep.csv"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_TRUE(csv.starts_with("delay,loss,force_rmse_N,"));
  for (const char* file : {"sweep.txt", "sweep.json", "force_rmse_N.svg", "cells/000.json", "cells/003.json"})
    EXPECT_TRUE(fs::exists(in("sweep") + "/" + file)) << file;
}

TEST_F(ReplayProgram, DiffTakesTheFoldersThatTheReportTakes) {
  ASSERT_EQ(replay({"--out", in("a")}).first, 0);
  ASSERT_EQ(replay({"--out", in("b")}).first, 0);
  const auto [code, said] = run("telepalp-replay", {"diff", in("a"), in("b")});
  EXPECT_EQ(code, 0) << said;
}

TEST_F(ReplayProgram, EverySettingStandsInItsReportAndTheRunIsMadeAgainFromIt) {
  const auto [code, said] =
      replay({"--profile", "lte", "--loss", "3%", "--depth-mode", "bounded", "--clock-step", "1s+500ms:40ms",
              "--outage", "1s+100ms", "--hand", "tap", "--seed", "7", "--scene", "skin", "--out", in("a")});
  ASSERT_EQ(code, 0) << said;
  const std::string report = bytes_of(in("a/report.json"));
  for (const char* text :
       {"\"surface_setting\": \"fast\"", "\"depth_coding\": \"bounded, depth within max(1 mm, 2.85 mm",
        "\"clock_step\": \"1000ms+500ms:40ms\"", "\"outage\": \"1000ms+100ms\"", "\"restart\": \"none\"",
        "\"network_down\": \"delay 25 ms, jitter 8 ms, loss 3 % in bursts of 3", "at most 12000 kbit/s",
        "\"depth_camera\": \"640x480 pixels", "\"deadline_ms\": \"125\"", "\"seed\": 7", "\"hand\": \"tap\""})
    EXPECT_NE(report.find(text), std::string::npos) << text << "\n" << report;
  const auto [again, words] = run("telepalp-replay", {"again:" + in("a"), "--out", in("b"), "--baseline", in("a")});
  EXPECT_EQ(again, 0) << words;
  for (const char* file : {"session.mcap", "unimpaired.mcap", "report.json"})
    EXPECT_TRUE(bytes_of(in("a/") + file) == bytes_of(in("b/") + file)) << file;
}

TEST_F(ReplayProgram, AgainTakesGivenOptionsFirstAndRefusesAChangedScene) {
  std::ofstream(in("mine.textproto")) << bytes_of(fs::path(TELEPALP_SOURCE_DIR) /
                                                  "haptic_station/scenes/skin.scene.textproto");
  ASSERT_EQ(replay({"--scene", in("mine.textproto"), "--delay-ms", "40", "--out", in("a")}).first, 0);
  ASSERT_EQ(run("telepalp-replay", {"again:" + in("a/report.json"), "--delay-ms", "60", "--out", in("b")}).first, 0);
  EXPECT_NE(bytes_of(in("b/report.json")).find("delay 60 ms"), std::string::npos);
  std::ofstream(in("mine.textproto"), std::ios::app) << "\n# changed\n";
  const auto [code, said] = run("telepalp-replay", {"again:" + in("a")});
  EXPECT_EQ(code, 2);
  EXPECT_NE(said.find("the scene has changed since the run that again: names"), std::string::npos) << said;
  EXPECT_EQ(run("telepalp-replay", {"again:" + in("none")}).first, 2);
}

TEST_F(ReplayProgram, ABaselineCatchesTenPercentMoreStiffnessAndNamesTheLine) {
  const fs::path shipped = fs::path(TELEPALP_SOURCE_DIR) / "haptic_station/scenes/palpation.scene.textproto";
  std::string scene = bytes_of(shipped);
  scene.replace(scene.find("stiffness_N_per_m: 160"), 22, "stiffness_N_per_m: 176");
  std::ofstream(in("stiff.textproto")) << scene;
  const auto examine = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"synthetic:torso,motion=regular,width=320", "--seconds", "5"});
    return run("telepalp-replay", words);
  };
  ASSERT_EQ(examine({"--out", in("base")}).first, 0);
  const auto [same, holds] = examine({"--baseline", in("base")});
  EXPECT_EQ(same, 0) << holds;
  const auto [code, said] =
      examine({"--scene", in("stiff.textproto"), "--baseline", in("base"), "--junit", in("junit.xml")});
  EXPECT_EQ(code, 1) << said;
  EXPECT_NE(said.find("FAILS: stiffness_pct is "), std::string::npos) << said;
  EXPECT_NE(said.find("  1. scene: line 24: stiffness_N_per_m: 160 in A, stiffness_N_per_m: 176 in B"),
            std::string::npos)
      << said;
  EXPECT_NE(bytes_of(in("junit.xml")).find("from the baseline: stiffness_pct"), std::string::npos);
  EXPECT_EQ(examine({"--baseline", in("none")}).first, 2);
  EXPECT_EQ(examine({"--baseline", in("base") + ",stiffness<=1"}).first, 2);
  EXPECT_EQ(examine({"--baseline", in("base"), "--out", in("base")}).first, 2) << "it would overwrite its baseline";
}

TEST_F(ReplayProgram, AnInterruptedSweepKeepsItsFinishedCellsAndTheSameCommandResumes) {
  const std::vector<std::string> words{
      "synthetic:torso,width=320", "--seconds", "1", "--threads", "1", "--sweep", "delay=0:10:110", "--out", in("s")};
  {
    support::ChildProcess sweep(TELEPALP_BINARY_DIR "/bin/telepalp-replay", words, in("log"));
    for (int i = 0; i < 6000 && !fs::exists(in("s/cells/003.json")); ++i) std::this_thread::sleep_for(10ms);
    sweep.signal(SIGINT);
    EXPECT_EQ(sweep.wait(120s), 1);
  }
  const std::string said = bytes_of(in("log"));
  EXPECT_NE(said.find("of 12 runs of the sweep are finished, and kept in "), std::string::npos) << said;
  EXPECT_NE(said.find("telepalp-replay synthetic:torso,width=320 --seconds 1 --threads 1 --sweep delay=0:10:110 --out"),
            std::string::npos)
      << said;
  EXPECT_FALSE(fs::exists(in("s/sweep.csv")));
  const auto kept = fs::last_write_time(in("s/cells/003.json"));
  const auto [code, resumed] = run("telepalp-replay", words);
  EXPECT_EQ(code, 0) << resumed;
  EXPECT_NE(resumed.find("of 12 runs of the sweep were finished before"), std::string::npos) << resumed;
  EXPECT_EQ(fs::last_write_time(in("s/cells/003.json")), kept);
  std::vector<std::string> whole = words;
  whole.back() = in("whole");
  ASSERT_EQ(run("telepalp-replay", whole).first, 0);
  for (const char* file : {"sweep.csv", "sweep.json", "sweep.txt", "cells/000.json", "cells/011.json"})
    EXPECT_TRUE(bytes_of(in("s/") + file) == bytes_of(in("whole/") + file)) << file;
  std::vector<std::string> other = words;
  other.insert(other.end(), {"--depth-mode", "intra"});
  const auto [changed, from_the_start] = run("telepalp-replay", other);
  EXPECT_EQ(changed, 0);
  EXPECT_EQ(from_the_start.find("were finished before"), std::string::npos) << from_the_start;
}

/// A session of 2 s of a live server.
void record_session(const fs::path& folder, const fs::path& file) {
  const fs::path bin = TELEPALP_BINARY_DIR "/bin";
  const fs::path ready = folder / "ready";
  support::ChildProcess server(bin / "telepalp-server", {"--port", "0", "--ready-file", ready}, folder / "server.log");
  const auto port = support::await_ready(ready, "port");
  ASSERT_TRUE(port) << bytes_of(folder / "server.log");
  support::ChildProcess record(bin / "telepalp-record",
                               {"--connect", "127.0.0.1:" + *port, "--out", file, "--seconds", "2"},
                               folder / "record.log");
  EXPECT_EQ(record.wait(60s), 0) << bytes_of(folder / "record.log");
}

TEST_F(ReplayProgram, SaysThatASourceIsDamaged) {
  record_session(in(""), in("whole.mcap"));
  std::string bytes = bytes_of(in("whole.mcap"));
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2), 40, '\0');
  std::ofstream(in("damaged.mcap"), std::ios::binary) << bytes;
  const auto [whole, nothing] = run("telepalp-replay", {in("whole.mcap"), "--out", in("b")});
  EXPECT_EQ(whole, 0) << nothing;
  EXPECT_EQ(nothing.find("note: "), std::string::npos) << nothing;
  const auto [code, said] = run("telepalp-replay", {in("damaged.mcap"), "--out", in("c")});
  EXPECT_EQ(code, 0) << said;
  EXPECT_NE(said.find("damaged.mcap: 1 damaged part skipped, so images are missing in both runs. fix: "),
            std::string::npos)
      << said;
  EXPECT_NE(bytes_of(in("c/report.json")).find("\"damage\": "), std::string::npos);
}

/// A live station over real sockets with a journal of `seconds`; its exit code and what it said.
std::pair<int, std::string> keep_journal(const fs::path& folder, const std::string& setting,
                                         const std::string& seconds) {
  const fs::path bin = TELEPALP_BINARY_DIR "/bin";
  const fs::path ready = folder / "ready";
  fs::remove(ready);  // of a server before
  support::ChildProcess server(bin / "telepalp-server", {"--port", "0", "--ready-file", ready}, folder / "server.log");
  const auto port = support::await_ready(ready, "port");
  if (!port) return {-1, bytes_of(folder / "server.log")};
  support::ChildProcess station(bin / "telepalp-station",
                                {"--connect", "127.0.0.1:" + *port, "--surface", setting, "--control", "none",
                                 "--state-dir", folder, "--seconds", seconds, "--journal", folder / "a.journal"},
                                folder / "station.log");
  const std::optional<int> code = station.wait(60s);
  return {code.value_or(-1), bytes_of(folder / "station.log")};
}

TEST_F(ReplayProgram, ComputesTheJournalOfALiveStationAgainToTheLastBit) {
  for (const std::string setting : {"fast", "paper"}) {
    const auto [kept, station] = keep_journal(in(""), setting, "4");
    ASSERT_EQ(kept, 0) << station;
    EXPECT_NE(station.find("the journal holds "), std::string::npos) << station;
    const auto [code, said] = run("telepalp-replay", {"--journal", in("a.journal"), "--out", in("forces")});
    EXPECT_EQ(code, 0) << said;
    EXPECT_NE(said.find("force     0\nphase     0\nproxy     0\n"), std::string::npos) << said;
    EXPECT_GT(fs::file_size(in("forces/forces-live.csv")), 100'000U);
    EXPECT_TRUE(bytes_of(in("forces/forces-live.csv")) == bytes_of(in("forces/forces-replayed.csv"))) << setting;
  }
}

TEST_F(ReplayProgram, AJournalIsEncryptedForTheSiteAndReadWithItsKeyAlone) {
  ASSERT_EQ(run("telepalp-keys", {"site-key", "--name", "ward", "--dir", in("keys")}).first, 0);
  ::setenv("TELEPALP_SITE_KEYS", in("keys/ward-site.key").c_str(), 1);
  const auto [kept, station] = keep_journal(in(""), "fast", "2");
  const auto [code, said] = run("telepalp-replay", {"--journal", in("a.journal"), "--out", in("forces")});
  ::unsetenv("TELEPALP_SITE_KEYS");
  ASSERT_EQ(kept, 0) << station;
  EXPECT_EQ(bytes_of(in("a.journal")).find("telepalp-journal"), std::string::npos);
  EXPECT_EQ(code, 0) << said;
  EXPECT_NE(said.find("force     0\nphase     0\nproxy     0\n"), std::string::npos) << said;
  EXPECT_GT(fs::file_size(in("forces/forces-live.csv")), 50'000U);
  const auto [without_key, why] = run("telepalp-replay", {"--journal", in("a.journal")});
  EXPECT_EQ(without_key, 2) << why;
  EXPECT_NE(why.find("TELEPALP_SITE_KEYS"), std::string::npos) << why;
}

TEST_F(ReplayProgram, SaysThatAJournalWasCutOffOrIsNone) {
  ASSERT_EQ(keep_journal(in(""), "fast", "2").first, 0);
  fs::resize_file(in("a.journal"), fs::file_size(in("a.journal")) / 2);
  const auto [code, said] = run("telepalp-replay", {"--journal", in("a.journal")});
  EXPECT_EQ(code, 0) << said;
  EXPECT_NE(said.find("note: the journal was cut off: it is read up to its last whole block"), std::string::npos)
      << said;
  EXPECT_NE(said.find("fix: none for these ticks; to keep later ones, end the station by Ctrl-C or --seconds"),
            std::string::npos)
      << said;
  std::ofstream(in("none")) << "nothing";
  const auto [refused, why] = run("telepalp-replay", {"--journal", in("none")});
  EXPECT_EQ(refused, 2) << why;
  EXPECT_NE(why.find("fix: give a file that telepalp-station --journal FILE wrote"), std::string::npos) << why;
  const auto [beside, which] = run("telepalp-replay", {"synthetic:torso", "--journal", in("a.journal")});
  EXPECT_EQ(beside, 2) << which;
}

/// Writes the journal a.journal again as b.journal, with each block as `change` leaves it; false: without the block.
void change_journal(const fs::path& folder, const std::function<bool(msg::JournalBlock&)>& change) {
  std::ifstream in(folder / "a.journal", std::ios::binary);
  auto reader = core::JournalReader::open(in, "a.journal");
  ASSERT_TRUE(reader.ok());
  msg::JournalBlock header;
  *header.mutable_header() = reader->header();
  ASSERT_TRUE(change(header));
  std::ofstream out(folder / "b.journal", std::ios::binary);
  core::JournalWriter writer(out, header.header());
  while (auto block = reader->next())
    if (change(*block)) writer.add(*block);
}

TEST_F(ReplayProgram, SaysWhatLimitsTheComparisonOfAJournalAndWhatToDo) {
  ASSERT_EQ(keep_journal(in(""), "fast", "2").first, 0);
  const auto verdict = [&] { return run("telepalp-replay", {"--journal", in("b.journal")}); };
  change_journal(in(""), [](msg::JournalBlock& block) {
    if (block.has_header()) block.mutable_header()->set_commit("1a2b3c4d");
    return true;
  });
  const auto [other_build, build_words] = verdict();
  EXPECT_EQ(other_build, 0) << build_words;
  EXPECT_NE(build_words.find("note: another build wrote the journal: "), std::string::npos) << build_words;
  EXPECT_NE(build_words.find("fix: for an exact comparison, run telepalp-replay of that commit"), std::string::npos);
  change_journal(in(""), [](msg::JournalBlock& block) {
    if (block.has_header()) block.mutable_header()->set_machine("An Abacus of 13 Rods");
    return true;
  });
  const auto [other_machine, machine_words] = verdict();
  EXPECT_EQ(other_machine, 0) << machine_words;
  EXPECT_NE(machine_words.find("with the processor An Abacus of 13 Rods; this one has "), std::string::npos)
      << machine_words;
  int runs = 0;
  change_journal(in(""), [&](msg::JournalBlock& block) { return !block.has_surface_run() || ++runs != 3; });
  const auto [missing, missing_words] = verdict();
  EXPECT_EQ(missing, 1) << missing_words;
  EXPECT_NE(missing_words.find(" adopts surface "), std::string::npos) << missing_words;
  EXPECT_NE(missing_words.find(", which the journal does not hold. The ticks before it are compared, "
                               "those behind it cannot be. fix: keep the journal again"),
            std::string::npos)
      << missing_words;
  change_journal(in(""), [](msg::JournalBlock& block) {
    if (!block.has_ticks()) return true;
    for (msg::JournalTick& tick : *block.mutable_ticks()->mutable_ticks())
      if (tick.tick() == 100) tick.set_force(1, tick.force(1) + 0.5);
    return true;
  });
  const auto [differs, differs_words] = verdict();
  EXPECT_EQ(differs, 1) << differs_words;
  EXPECT_NE(differs_words.find("force     1\nphase     0\nproxy     0\nthe first of them is tick 100\n"),
            std::string::npos)
      << differs_words;
  EXPECT_NE(differs_words.find("this is a defect of telepalp. fix: report it"), std::string::npos) << differs_words;
}

TEST_F(ReplayProgram, RunsTheSettingOfThePaperInVirtualTime) {
  std::string scene = bytes_of(TELEPALP_SOURCE_DIR "/haptic_station/scenes/skin.scene.textproto");
  std::ofstream(in("paper.scene.textproto")) << scene << "\nsurface { name: \"paper\" }\n";
  const auto [code, said] = run("telepalp-replay", {"synthetic:torso,motion=irregular,width=160", "--seconds", "4",
                                                    "--scene", in("paper.scene.textproto"), "--out", in("a"),
                                                    "--assert", "force_max_N>0.2,frames_touched_pct>90"});
  EXPECT_EQ(code, 0) << said;
  EXPECT_NE(bytes_of(in("a/report.json")).find("\"surface_setting\": \"paper\""), std::string::npos);
}

}  // namespace
