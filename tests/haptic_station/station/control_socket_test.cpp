#include "haptic_station/station/faults/control_socket.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/support/child_process.h"

namespace telepalp::station {
namespace {

namespace fs = std::filesystem;

struct Listening {
  explicit Listening(const fs::path& path) {
    const Result<void> done = socket.listen(path);
    if (!done) problem = to_string(done.error());
    thread = std::thread([this] { io.run(); });
  }
  ~Listening() {
    io.stop();
    thread.join();
  }
  boost::asio::io_context io{1};
  ControlSocket socket{
      io, [](const std::string& command, const ControlSocket::Reply& reply) { reply("heard " + command); }};
  std::string problem;
  std::thread thread;
};

TEST(ControlSocket, AnswersOneLineAndIsGoneAfterwards) {
  const support::TemporaryFolder folder;
  const fs::path path = folder.path() / "run" / "control";
  {
    const Listening station(path);
    ASSERT_EQ(station.problem, "");
    const Result<std::string> answer = ask_station(path, "rearm");
    ASSERT_TRUE(answer) << to_string(answer.error());
    EXPECT_EQ(*answer, "heard rearm");
    EXPECT_FALSE(ask_station(path, std::string(100'000, 'x'))) << "no line is that long";
    EXPECT_TRUE(ask_station(path, "again")) << "and the station goes on";
  }
  EXPECT_FALSE(fs::exists(path));
  EXPECT_FALSE(ask_station(path, "rearm"));
}

TEST(ControlSocket, IsForThisUserAlone) {
  const support::TemporaryFolder folder;
  const Listening station(folder.path() / "run" / "control");
  ASSERT_EQ(station.problem, "");
  const fs::perms others = fs::perms::group_all | fs::perms::others_all;
  EXPECT_EQ(fs::status(folder.path() / "run").permissions() & others, fs::perms::none);
}

TEST(ControlSocket, ALinkInPlaceOfTheFolderIsNotTrusted) {
  const support::TemporaryFolder folder;
  fs::create_directory(folder.path() / "elsewhere");
  fs::create_directory_symlink(folder.path() / "elsewhere", folder.path() / "run");
  const Listening station(folder.path() / "run" / "control");
  EXPECT_NE(station.problem.find("not this user's alone"), std::string::npos) << station.problem;
}

TEST(ControlSocket, APathTooLongForASocketIsToldNotThrown) {
  const Listening station("/tmp/" + std::string(200, 'a') + "/control");
  EXPECT_NE(station.problem.find("too long"), std::string::npos) << station.problem;
  EXPECT_FALSE(ask_station("/tmp/" + std::string(200, 'a'), "rearm"));
}

}  // namespace
}  // namespace telepalp::station
