#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <sstream>
#include <thread>
#include <utility>

#include "messages/camera.pb.h"
#include "proto/words/formats.h"
#include "support/program/address.h"
#include "support/program/ending.h"
#include "support/program/files/shipped.h"
#include "support/program/json.h"
#include "support/program/log.h"
#include "support/program/options.h"
#include "support/program/terminal.h"
#include "support/program/text/text_format.h"

namespace telepalp::program {
namespace {

Usage usage() {
  return {.program = "telepalp-x",
          .purpose = "does x",
          .positional = "FILE",
          .options = {{"rate", "HZ", "how fast", "30"}, {"loop", "", "again and again"}},
          .example = "telepalp-x --rate 10 a.file"};
}

Result<std::optional<Arguments>> read(std::vector<const char*> words) {
  words.insert(words.begin(), "telepalp-x");
  return read_arguments(usage(), static_cast<int>(words.size()), words.data());
}

TEST(Arguments, AnOmittedOptionHasItsDefault) {
  const auto arguments = read({"a.file"});
  ASSERT_TRUE(arguments.ok());
  EXPECT_EQ((*arguments)->number("rate", 1, 100).value(), 30);
  EXPECT_FALSE((*arguments)->has("loop"));
  EXPECT_EQ((*arguments)->positional(), std::vector<std::string>{"a.file"});
}

TEST(Arguments, AnUnknownOptionOrAnAbbreviatedOneIsAnError) {
  EXPECT_FALSE(read({"--speed", "3"}).ok());
  EXPECT_FALSE(read({"--rat", "3"}).ok());
}

TEST(Arguments, AnOptionGivenTwiceIsAnError) {
  for (const auto& words :
       {std::vector<const char*>{"--rate", "10", "--rate", "70"}, std::vector<const char*>{"--rate=10", "--rate=10"},
        std::vector<const char*>{"--loop", "--loop"}}) {
    const auto arguments = read(words);
    ASSERT_FALSE(arguments.ok()) << words[0];
    EXPECT_NE(arguments.error().what.find("is given twice"), std::string::npos) << arguments.error().what;
  }
}

TEST(Arguments, AnEmptyValueIsAnError) {
  EXPECT_FALSE(read({"--rate", ""}).ok());
  EXPECT_FALSE(read({"--rate="}).ok());
}

TEST(Arguments, ANumberOutOfItsRangeNamesTheRange) {
  const auto arguments = read({"--rate", "1000"});
  ASSERT_TRUE(arguments.ok());
  const auto rate = (*arguments)->number("rate", 1, 100);
  ASSERT_FALSE(rate.ok());
  EXPECT_NE(to_string(rate.error()).find("from 1 to 100"), std::string::npos);
  const auto word = read({"--rate", "fast"});
  EXPECT_FALSE((*word)->number("rate", 1, 100).ok());
}

TEST(Help, EndsWithALineToPaste) {
  const std::string text = help_text(usage());
  EXPECT_TRUE(text.ends_with("example: telepalp-x --rate 10 a.file\n")) << text;
}

TEST(Help, HasTheSamePartsInTheSameOrderAndFitsAScreen) {
  Usage wide = usage();
  wide.purpose = "does x, and does it for so long and in so many words that they do not fit on one line of a terminal";
  wide.options.push_back({"bound", "A-WORD-FOR-ARGUMENT,WITH-ANOTHER", "how far z² may be off"});
  wide.commands = {{"look", "FILE", "tell what is in it"}};
  const std::string text = help_text(wide);
  std::size_t at = 0;
  for (const char* part :
       {"telepalp-x: does x", "\nusage: telepalp-x [options] FILE\n", "       telepalp-x COMMAND [options]\n",
        "\ncommands:\n  look FILE  tell", "\noptions:\n  --rate HZ ", "how fast [30]\n", "  -h, --help ",
        "  --version ", "\nexample: "}) {
    const std::size_t found = text.find(part, at);
    ASSERT_NE(found, std::string::npos) << part << " in\n" << text;
    at = found;
  }
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), kHelpColumns + 1) << line;
}

TEST(Help, IsAskedForByTheShortOptionToo) {
  testing::internal::CaptureStdout();
  const auto arguments = read({"-h"});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), help_text(usage()));
  ASSERT_TRUE(arguments.ok());
  EXPECT_FALSE(arguments->has_value());
}

TEST(Version, NamesProgramVersionCommitAndTheFormatsSpoken) {
  const std::string text = version_text("telepalp-x sub");
  EXPECT_TRUE(text.starts_with("telepalp-x ")) << text;
  EXPECT_NE(text.find("wire protocol 2, depth codec " + std::to_string(kDepthPacketVersion) + ", MCAP 0\n"),
            std::string::npos)
      << text;
}

/// A new terminal, as a stream that writes to it.
struct Terminal {
  Terminal() : master(::posix_openpt(O_RDWR | O_NOCTTY)) {
    ::grantpt(master);
    ::unlockpt(master);
    stream = std::fopen(::ptsname(master), "w");
  }
  ~Terminal() {
    if (stream != nullptr) std::fclose(stream);
    ::close(master);
  }
  int master;
  std::FILE* stream = nullptr;
};

TEST(Terminal, HasColoursUnlessTheUserWantsNoneAndAFileNeverHas) {
  ::setenv("TERM", "xterm", 1);
  ::unsetenv("NO_COLOR");
  const Terminal terminal;
  ASSERT_NE(terminal.stream, nullptr);
  EXPECT_TRUE(takes_colour(terminal.stream));
  ::setenv("NO_COLOR", "1", 1);
  EXPECT_FALSE(takes_colour(terminal.stream));
  EXPECT_TRUE(takes_progress(terminal.stream)) << "a progress line is no colour";
  ::unsetenv("NO_COLOR");
  ::setenv("TERM", "dumb", 1);
  EXPECT_FALSE(takes_colour(terminal.stream));
  EXPECT_FALSE(takes_progress(terminal.stream));
  ::setenv("TERM", "xterm", 1);
  std::FILE* file = std::tmpfile();
  EXPECT_FALSE(takes_colour(file));
  EXPECT_FALSE(takes_progress(file));
  std::fclose(file);
}

TEST(Address, HostAndPortAreReadAndAnythingElseIsRefused) {
  EXPECT_EQ(parse_address("127.0.0.1:7400", "--connect")->port, 7400);
  EXPECT_EQ(parse_address("[::1]:7400", "--connect")->host, "::1");
  for (const char* wrong : {"", "host", "host:", ":7400", "host:0", "host:70000", "host:74x", "::1:7400", "a:b:3"})
    EXPECT_FALSE(parse_address(wrong, "--connect").ok()) << wrong;
}

TEST(Address, WithoutAPortItIsTheDefaultOne) {
  EXPECT_EQ(parse_address("patient.example", "--connect", "7400")->port, 7400);
  EXPECT_EQ(parse_address("[::1]", "--connect", "7400")->host, "::1");
  for (const char* text : {"127.0.0.1:7400", "[::1]:7400", "patient.example:1"})
    EXPECT_EQ(to_text(*parse_address(text, "--connect")), text);
  EXPECT_EQ(parse_address("10.0.0.5:81", "--connect", "7400")->port, 81);
  for (const char* wrong : {"", "host:", ":7400", "host:0", "::1", "[::1", "[]", "[::1]:", "a]:7"})
    EXPECT_FALSE(parse_address(wrong, "--connect", "7400").ok()) << wrong;
}

/// Exit code and duration of a child process that is asked three times to end while it has `work` left.
std::pair<int, std::chrono::milliseconds> end_with(std::chrono::milliseconds work) {
  const auto begun = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child == 0) {
    end_within_when_signalled(std::chrono::seconds(1), "the test's child was not done in time");
    for (int signals = 0; signals < 3; ++signals) (void)std::raise(signals == 1 ? SIGTERM : SIGINT);
    std::this_thread::sleep_for(work);
    work_is_done();
    (void)::kill(::getpid(), SIGINT);
    ::_exit(kDone);
  }
  int status = 0;
  (void)::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begun)};
}

TEST(Ending, IsBoundedByTimeAndNotByTheNumberOfSignals) {
  EXPECT_EQ(end_with(std::chrono::milliseconds(300)).first, kDone);
  const auto [code, took] = end_with(std::chrono::seconds(60));
  EXPECT_EQ(code, kFailed);
  EXPECT_GE(took, std::chrono::milliseconds(900));
  EXPECT_LT(took, std::chrono::seconds(20));
}

TEST(ShippedFile, IsFoundAboveTheProgramAndAMissingOneIsNot) {
  EXPECT_TRUE(shipped_file("LICENSE").has_value());
  EXPECT_FALSE(shipped_file("no/such/file").has_value());
}

TEST(TextFormat, ANumberIsFoundWhereItStands) {
  msg::CameraFile camera;
  const auto read = parse_text_format("depth {\n  fx: 3\n  width: 7 }\ndepth_unit_m: 1\n", "c.textproto", camera);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->where("c.textproto", "depth.fx", 3.0), "c.textproto:2:3");
  EXPECT_EQ(read->where("c.textproto", "width", 7.0), "c.textproto:3:3");
  EXPECT_EQ(read->where("c.textproto", "depth_unit_m", 1.0), "c.textproto:4:1");
  EXPECT_EQ(read->where("c.textproto", "depth_unit_m", 2.0), "c.textproto");
}

TEST(TextFormat, ANumberIsFoundInItsOwnMessageAndAMessageByItsName) {
  msg::CameraFile camera;
  const auto read = parse_text_format("depth { fx: 3 }\n\n  color {\n fx: 3 }\n", "c.textproto", camera);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->where("c.textproto", camera.color(), "color.fx", 3.0), "c.textproto:4:2");
  EXPECT_EQ(read->where("c.textproto", camera.depth(), "depth.fx", 3.0), "c.textproto:1:9");
  EXPECT_EQ(read->where("c.textproto", camera.color()), "c.textproto:3:3");
  EXPECT_EQ(read->where("c.textproto", camera.color(), "cx", 0.0), "c.textproto:3:3") << "the field is not given";
  const msg::CameraFile another;
  EXPECT_EQ(read->where("c.textproto", another.color()), "c.textproto");
}

TEST(TextFormat, AnUnknownFieldIsNamedWithLineAndColumn) {
  msg::CameraFile camera;
  const auto read = parse_text_format("depth {\n  fx_px: 3\n}\n", "camera.textproto", camera);
  ASSERT_FALSE(read.ok());
  EXPECT_TRUE(read.error().where.starts_with("camera.textproto:2:")) << read.error().where;
  EXPECT_NE(read.error().what.find("fx_px"), std::string::npos) << read.error().what;
}

int command_of_seven(int argc, const char* const*) { return argc == 2 ? 7 : kFailed; }

/// The exit code of `words`, after the program's name, and how often the program itself ran.
std::pair<int, int> run_with(std::vector<const char*> words) {
  words.insert(words.begin(), "telepalp-x");
  Usage with_command = usage();
  with_command.commands = {{"look", "FILE", "tell"}, {"seven", "", "has options of its own", command_of_seven}};
  int runs = 0;
  const int code = run_program(with_command, static_cast<int>(words.size()), words.data(), [&](const Arguments& given) {
    ++runs;
    return given.has("loop") ? 5 : 6;
  });
  return {code, runs};
}

TEST(RunProgram, RunsTheProgramOrItsCommandAndNothingAfterAWrongWordOrHelp) {
  EXPECT_EQ(run_with({"a.file", "--loop"}), std::pair(5, 1));
  EXPECT_EQ(run_with({"look", "a.file"}), std::pair(6, 1)) << "a command without a function is a word of the program";
  EXPECT_EQ(run_with({"seven", "a.file"}), std::pair(7, 0));
  EXPECT_EQ(run_with({"--speed", "3"}), std::pair(kAskedWrongly, 0));
  EXPECT_EQ(run_with({"--help"}), std::pair(kDone, 0));
}

TEST(Log, IsALineOfTextOrAJsonObject) {
  const std::chrono::system_clock::time_point at{std::chrono::milliseconds(1'795'000'000'125)};
  EXPECT_TRUE(log_line(at, "telepalp-server", "a\nb").ends_with(".125 telepalp-server: a\\x0ab\n"));
  const std::string json = json_log_line(at, "telepalp-server", "says \"a\nb\"");
  EXPECT_EQ(std::ranges::count(json, '\n'), 1) << json;
  EXPECT_NE(json.find(R"("time": "2026-11-18T11:06:40.125Z")"), std::string::npos) << json;
  EXPECT_NE(json.find(R"("text": "says \"a\\x0ab\"")"), std::string::npos) << json;
}

TEST(Log, ControlCharactersOfAPeerAreEscaped) {
  EXPECT_EQ(escaped("a\nb\x1b[2J\x7f"), "a\\x0ab\\x1b[2J\\x7f");
  EXPECT_EQ(escaped("\xc2\x9b"
                    "2J"),
            "\\xc2\\x9b2J")
      << "U+009B begins an escape sequence, as ESC [ does";
  EXPECT_EQ(escaped("Zo\xc3\xab, 5 \xc2\xb5m \xc2"), "Zo\xc3\xab, 5 \xc2\xb5m \xc2") << "other UTF-8 text stays";
}

TEST(Json, NumbersThatAreNotFiniteBecomeNull) {
  Json json;
  json.begin_object();
  json.add("a", std::nan(""));
  json.add("b", INFINITY);
  json.add("c\"\n", 0.5);
  json.end_object();
  EXPECT_EQ(std::move(json).finish(), "{\n  \"a\": null,\n  \"b\": null,\n  \"c\\\"\\u000a\": 0.5\n}\n");
}

}  // namespace
}  // namespace telepalp::program
