#include "haptic_station/station/faults/control_socket.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <fstream>
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

TEST(ControlSocket, OnlyThisUserCanConnect) {
  const support::TemporaryFolder folder;
  const Listening station(folder.path() / "run" / "control");
  ASSERT_EQ(station.problem, "");
  const fs::perms others = fs::perms::group_all | fs::perms::others_all;
  EXPECT_EQ(fs::status(folder.path() / "run").permissions() & others, fs::perms::none);
}

fs::perms permissions(const fs::path& path) { return fs::status(path).permissions(); }

std::string problem_at(const fs::path& path) { return Listening(path).problem; }

TEST(ControlSocket, ALinkInPlaceOfTheFolderIsNotFollowedAndItsTargetStaysAsItIs) {
  const support::TemporaryFolder folder;
  fs::create_directory(folder.path() / "elsewhere");
  fs::permissions(folder.path() / "elsewhere", fs::perms{0755});
  fs::create_directory_symlink(folder.path() / "elsewhere", folder.path() / "run");
  for (const fs::path& path : {folder.path() / "run" / "control", folder.path() / "run" / "." / "control"})
    EXPECT_NE(problem_at(path).find("is a symbolic link"), std::string::npos) << problem_at(path);
  EXPECT_EQ(permissions(folder.path() / "elsewhere"), fs::perms{0755});
  EXPECT_TRUE(fs::is_empty(folder.path() / "elsewhere"));
}

TEST(ControlSocket, AFolderThatOthersMayWriteToIsRefusedAndStaysAsItIs) {
  const support::TemporaryFolder folder;
  const fs::path run = folder.path() / "run";
  fs::create_directory(run);
  for (const unsigned mode : {01777U, 0777U, 0770U}) {  // the first is /tmp's
    fs::permissions(run, fs::perms{mode});
    EXPECT_NE(problem_at(run / "control").find("other users may write"), std::string::npos)
        << problem_at(run / "control");
    EXPECT_EQ(permissions(run), fs::perms{mode});
    EXPECT_TRUE(fs::is_empty(run));
  }
}

TEST(ControlSocket, AFolderOfAnotherUserIsRefused) {
  const support::TemporaryFolder folder;
  fs::path others = "/";  // root's; root itself can give one away
  if (::geteuid() == 0) {
    others = folder.path() / "others";
    fs::create_directory(others);
    ASSERT_EQ(::chown(others.c_str(), 1, 1), 0);
  }
  EXPECT_NE(problem_at(others / "control").find("belongs to another user"), std::string::npos);
  EXPECT_FALSE(fs::exists(others / "control"));
}

TEST(ControlSocket, AFolderOfOursThatOthersMayReadIsTakenAsItIsAndTheSocketIsForUsAlone) {
  const support::TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms{0755});
  const Listening station(folder.path() / "control");
  ASSERT_EQ(station.problem, "");
  EXPECT_EQ(permissions(folder.path()), fs::perms{0755});
  EXPECT_EQ(permissions(folder.path() / "control"), fs::perms{0600});
}

TEST(ControlSocket, AFileThatIsNoSocketStaysAsItIs) {
  const support::TemporaryFolder folder;
  const fs::path path = folder.path() / "letter.txt";
  std::ofstream(path) << "mine";
  EXPECT_NE(problem_at(path).find("not a socket"), std::string::npos) << problem_at(path);
  std::string kept;
  std::ifstream(path) >> kept;
  EXPECT_EQ(kept, "mine");
  fs::create_directory(folder.path() / "sub");
  EXPECT_NE(problem_at(folder.path() / "sub").find("not a socket"), std::string::npos);
  EXPECT_NE(problem_at(folder.path() / "sub/").find("is a folder, not a socket"), std::string::npos);
}

TEST(ControlSocket, ALinkInPlaceOfTheSocketIsRefusedAndItsTargetStaysAsItIs) {
  const support::TemporaryFolder folder;
  std::ofstream(folder.path() / "letter.txt") << "mine";
  fs::create_symlink(folder.path() / "letter.txt", folder.path() / "control");
  fs::create_symlink(folder.path() / "nothing", folder.path() / "dangling");
  for (const char* name : {"control", "dangling"})
    EXPECT_NE(problem_at(folder.path() / name).find("is a symbolic link"), std::string::npos) << name;
  EXPECT_TRUE(fs::is_symlink(folder.path() / "control"));
  EXPECT_EQ(fs::file_size(folder.path() / "letter.txt"), 4u);
}

TEST(ControlSocket, ASocketThatACrashedStationLeftIsReplacedAndALiveOneIsNot) {
  const support::TemporaryFolder folder;
  const fs::path path = folder.path() / "control";
  {
    boost::asio::io_context io;
    const boost::asio::local::stream_protocol::acceptor crashed(io, {path.string()});  // its file stays
  }
  ASSERT_TRUE(fs::is_socket(path));
  const Listening station(path);
  ASSERT_EQ(station.problem, "");
  EXPECT_NE(problem_at(path).find("another station listens on this socket"), std::string::npos);
  const Result<std::string> answer = ask_station(path, "rearm");
  ASSERT_TRUE(answer) << to_string(answer.error());
  EXPECT_EQ(*answer, "heard rearm");
}

TEST(ControlSocket, AFileThatReplacedTheSocketIsNotRemovedAtTheEnd) {
  const support::TemporaryFolder folder;
  const fs::path path = folder.path() / "control";
  {
    const Listening station(path);
    ASSERT_EQ(station.problem, "");
    fs::remove(path);
    std::ofstream(path) << "mine";
  }
  EXPECT_TRUE(fs::is_regular_file(path));
}

TEST(ControlSocket, AFallBackFolderThatIsALinkIsNeitherUsedNorLookedInto) {
  const support::TemporaryFolder folder;
  fs::create_directory(folder.path() / "victim");
  fs::permissions(folder.path() / "victim", fs::perms{0755});
  fs::create_directory_symlink(folder.path() / "victim", folder.path() / "telepalp");
  ::setenv("XDG_RUNTIME_DIR", folder.path().c_str(), 1);
  EXPECT_NE(problem_at(own_control_path()).find("is a symbolic link"), std::string::npos);
  const Result<fs::path> found = find_control_socket();
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().what.find("is a symbolic link"), std::string::npos) << to_string(found.error());
  EXPECT_EQ(permissions(folder.path() / "victim"), fs::perms{0755});
  ::unsetenv("XDG_RUNTIME_DIR");
}

TEST(ControlSocket, ATooLongPathIsAnErrorAndNoException) {
  const Listening station("/tmp/" + std::string(200, 'a') + "/control");
  EXPECT_NE(station.problem.find("too long"), std::string::npos) << station.problem;
  EXPECT_FALSE(ask_station("/tmp/" + std::string(200, 'a'), "rearm"));
}

}  // namespace
}  // namespace telepalp::station
