// telepalp-codec as its user runs it.

#include <gtest/gtest.h>

#include <boost/property_tree/json_parser.hpp>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>
#include <utility>

#include "support/images/image_file.h"
#include "support/program/files/whole_file.h"
#include "tests/codec/depth_frames.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::server {
namespace {

using namespace std::chrono_literals;

class CodecProgram : public testing::Test {
 protected:
  CodecProgram() {
    std::filesystem::create_directories(folder_.path() / "original");
    for (unsigned i = 0; i < 3; ++i) {
      DepthImage depth = codec::kinect_like(64, 48, i);
      const images::GrayImage16 image{depth.width, depth.height, std::move(depth.samples)};
      EXPECT_TRUE(program::write_whole_file(in("original/" + std::to_string(i) + ".png"), images::encode_png(image),
                                            program::Readers::Group)
                      .ok());
    }
  }
  std::string in(const std::string& name) const { return (folder_.path() / name).string(); }

  /// Its exit code and its output.
  std::pair<int, std::string> run(std::vector<std::string> words) const {
    words.insert(words.begin(), {"-c", "exec \"$0\" \"$@\" >&2", TELEPALP_BINARY_DIR "/bin/telepalp-codec"});
    support::ChildProcess process("/bin/sh", words, in("log"));
    const std::optional<int> code = process.wait(20s);
    std::ifstream log(in("log"));
    return {code.value_or(-1), {std::istreambuf_iterator<char>(log), {}}};
  }

 private:
  support::TemporaryFolder folder_;
};

TEST_F(CodecProgram, KeepsTheBoundThatItWasGivenAndSaysSoWhenAsked) {
  const auto [encoded, about_it] =
      run({"encode", in("original"), in("bounded.mcap"), "--mode", "bounded", "--bound", "3,10"});
  ASSERT_EQ(encoded, 0) << about_it;
  const auto [held, said] = run({"compare", in("original"), in("bounded.mcap"), "--bound", "3,10"});
  EXPECT_EQ(held, 0) << said;
  EXPECT_NE(said.find("no pixel of the second input differs from the first input by more than --bound allows"),
            std::string::npos)
      << said;
  const auto [info, printed] = run({"info", in("bounded.mcap")});
  EXPECT_EQ(info, 0);
  EXPECT_NE(printed.find("off by up to 10 mm at 1 m"), std::string::npos) << printed;
}

TEST_F(CodecProgram, LeavesNoFileBehindWhenItIsInterrupted) {
  for (int i = 3; i < 4000; ++i)
    std::filesystem::create_hard_link(in("original/0.png"), in("original/" + std::to_string(i) + ".png"));
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string partial = in("depth.mcap.partial");
    support::ChildProcess process(TELEPALP_BINARY_DIR "/bin/telepalp-codec",
                                  {"encode", in("original"), in("depth.mcap")}, in("log"));
    for (int i = 0; i < 2000 && !std::filesystem::exists(partial); ++i) std::this_thread::sleep_for(2ms);
    ASSERT_TRUE(std::filesystem::exists(partial)) << "it has begun to write";
    process.signal(signal);
    EXPECT_EQ(process.wait(20s), 1);
    EXPECT_FALSE(std::filesystem::exists(partial));
    EXPECT_FALSE(std::filesystem::exists(in("depth.mcap")));
  }
}

TEST_F(CodecProgram, DescribesARecordingInJsonToo) {
  ASSERT_EQ(run({"encode", in("original"), in("depth.mcap"), "--mode", "temporal", "--key-every", "2"}).first, 0);
  const auto [code, printed] = run({"info", in("depth.mcap"), "--json"});
  ASSERT_EQ(code, 0) << printed;
  std::istringstream text(printed);
  boost::property_tree::ptree json;
  boost::property_tree::read_json(text, json);
  ASSERT_EQ(json.get_child("frames").size(), 3u);
  const boost::property_tree::ptree& second = std::next(json.get_child("frames").begin())->second;
  EXPECT_EQ(second.get<int>("width"), 64);
  EXPECT_EQ(second.get<int>("since_key"), 1);
  EXPECT_EQ(second.get<std::string>("moved"), "null") << "nothing is moved without loss";
  EXPECT_EQ(json.get<int>("total.sample_bytes"), 3 * 64 * 48 * 2);
}

TEST_F(CodecProgram, FailsWhereACloserBoundIsNotKeptAndNamesAPixel) {
  ASSERT_EQ(run({"encode", in("original"), in("bounded.mcap"), "--mode", "bounded", "--bound", "3,10"}).first, 0);
  const auto [code, said] = run({"compare", in("original"), in("bounded.mcap"), "--bound", "1,1"});
  EXPECT_EQ(code, 1);
  EXPECT_NE(said.find("pixels differ from the first input by more than --bound allows, the first in frame 0, column "),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("fix: "), std::string::npos) << said;
  EXPECT_EQ(run({"compare", in("original"), in("bounded.mcap")}).first, 0) << "nothing is asked without a bound";
}

TEST_F(CodecProgram, LosslessDepthKeepsABoundOfZero) {
  for (const std::string mode : {"fast", "intra", "temporal"}) {
    const std::string file = in(mode + ".mcap");
    ASSERT_EQ(run({"encode", in("original"), file, "--mode", mode}).first, 0);
    EXPECT_EQ(run({"compare", in("original"), file, "--bound", "0,0"}).first, 0);
    const auto [info, printed] = run({"info", file});
    EXPECT_EQ(printed.find("off by"), std::string::npos) << printed;
  }
}

TEST_F(CodecProgram, NearLosslessDepthIsNotCalledLosslessWhenItIsEncodedAgain) {
  ASSERT_EQ(run({"encode", in("original"), in("bounded.mcap"), "--mode", "bounded", "--bound", "3,10"}).first, 0);
  ASSERT_EQ(run({"encode", in("bounded.mcap"), in("again.mcap"), "--mode", "fast"}).first, 0);
  const auto [code, printed] = run({"info", in("again.mcap")});
  EXPECT_EQ(code, 0);
  EXPECT_NE(printed.find("off by up to 10 mm at 1 m"), std::string::npos) << printed;
}

TEST_F(CodecProgram, ABoundThatMakesNoSenseIsRefusedBeforeAnythingIsWritten) {
  const std::vector<std::vector<std::string>> wrong = {
      {"encode", in("original"), in("out.mcap"), "--bound", "1,2.85"},  // temporal is lossless
      {"encode", in("original"), in("out.mcap"), "--mode", "bounded", "--bound", "1"},
      {"encode", in("original"), in("out.mcap"), "--mode", "bounded", "--bound", "-1,2"},
      {"compare", in("original"), in("original"), "--bound", "a,b"}};
  for (const std::vector<std::string>& words : wrong) {
    const auto [code, said] = run(words);
    EXPECT_EQ(code, 2) << said;
    EXPECT_NE(said.find("error: --bound: "), std::string::npos) << said;
    EXPECT_NE(said.find("fix: "), std::string::npos) << said;
  }
  EXPECT_FALSE(std::filesystem::exists(in("out.mcap")));
}

}  // namespace
}  // namespace telepalp::server
