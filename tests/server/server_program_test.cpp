#include <gtest/gtest.h>
#include <signal.h>

#include <boost/asio/io_context.hpp>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "messages/camera.pb.h"
#include "proto/wire/client/client_link.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::server {
namespace {

using namespace std::chrono_literals;

const std::filesystem::path kServer = TELEPALP_BINARY_DIR "/bin/telepalp-server";

/// telepalp-server on a free port.
struct RunningServer {
  support::TemporaryFolder folder;
  std::filesystem::path log = folder.path() / "log";
  std::filesystem::path ready = folder.path() / "ready";
  support::ChildProcess process;

  explicit RunningServer(std::vector<std::string> arguments)
      : process(kServer, with_ports(std::move(arguments)), log) {}

  std::uint16_t port() const {
    const std::optional<std::string> port = support::await_ready(ready, "port");
    EXPECT_TRUE(port) << logged();
    return port ? static_cast<std::uint16_t>(std::stoi(*port)) : 0;
  }
  std::string logged() const {
    std::ifstream file(log);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  std::vector<std::string> with_ports(std::vector<std::string> arguments) const {
    for (const std::string& word :
         {std::string("--port"), std::string("0"), std::string("--ready-file"), ready.string()})
      arguments.push_back(word);
    return arguments;
  }
};

/// Runs the program to its end; returns its exit code and stderr.
std::pair<int, std::string> outcome(const std::vector<std::string>& arguments) {
  const support::TemporaryFolder folder;
  support::ChildProcess process(kServer, arguments, folder.path() / "log");
  const std::optional<int> code = process.wait(20s);
  std::ifstream log(folder.path() / "log");
  return {code.value_or(-1), {std::istreambuf_iterator<char>(log), {}}};
}

TEST(ServerProgram, ServesASyntheticPatientUntilItIsStoppedAndThenSaysGoodbye) {
  RunningServer server({"--source", "synthetic"});
  boost::asio::io_context io;
  std::set<std::string_view> topics;
  std::string lost;
  bool stopped = false;
  wire::ClientLink link(io, {.port = server.port(), .name = "test", .subscribes = {"*"}},
                        {.on_message =
                             [&](const wire::Message& message) {
                               topics.insert(message.topic.name);
                               if (topics.size() == 7 && !std::exchange(stopped, true)) server.process.signal(SIGINT);
                             },
                         .on_state =
                             [&](wire::LinkState state, const std::string& detail) {
                               if (state != wire::LinkState::Lost) return;
                               lost = detail;
                               link.stop();
                             }});
  link.start();
  io.run_for(20s);
  EXPECT_EQ(topics.size(), 7u) << "color, depth, info, color info, status, clock, stats";
  EXPECT_EQ(lost, "peer left: Ctrl-C or another program stopped the server");
  EXPECT_EQ(server.process.wait(5s), 0) << server.logged();
  EXPECT_NE(server.logged().find("listening on 127.0.0.1:"), std::string::npos);
  EXPECT_NE(server.logged().find("frames captured"), std::string::npos);
}

TEST(ServerProgram, PublishesTheGivenBoundWithEveryImage) {
  RunningServer server({"--source", "synthetic", "--depth-mode", "bounded", "--depth-bound", "2,4"});
  boost::asio::io_context io;
  std::vector<msg::DepthImage> images;
  wire::ClientLink link(io, {.port = server.port(), .name = "test", .subscribes = {"/camera/depth"}},
                        {.on_message =
                             [&](const wire::Message& message) {
                               images.emplace_back();
                               EXPECT_TRUE(images.back().ParseFromString(*message.payload));
                               if (images.size() == 3) link.stop();
                             },
                         .on_state = {}});
  link.start();
  io.run_for(20s);
  ASSERT_GE(images.size(), 3u) << server.logged();
  for (const msg::DepthImage& image : images) {
    EXPECT_EQ(image.format(), "bounded");
    EXPECT_EQ(image.bound().least_m(), 0.002);
    EXPECT_EQ(image.bound().per_m(), 0.004);
  }
}

TEST(ServerProgram, StopsByItselfAfterTheSecondsAskedFor) {
  RunningServer server({"--source", "synthetic", "--seconds", "0.5"});
  EXPECT_EQ(server.process.wait(20s), 0) << server.logged();
}

TEST(ServerProgram, OpensBothItsPortsAtLocalhost) {
  RunningServer server({"--source", "synthetic", "--seconds", "0.5", "--bind", "localhost", "--http-port", "0"});
  EXPECT_EQ(server.process.wait(20s), 0) << server.logged();
}

TEST(ServerProgram, NamesThePortThatIsInUse) {
  RunningServer first({"--source", "synthetic"});
  const std::string port = std::to_string(first.port());
  const auto [code, said] = outcome({"--source", "synthetic", "--port", port});
  EXPECT_EQ(code, 1);
  EXPECT_EQ(said, "error: 127.0.0.1:" + port +
                      ": the port is in use. fix: stop the program that listens there, or give another --port\n");
}

TEST(ServerProgram, BadInputIsOneLineWithItsFixAndItsExitCode) {
  struct Case {
    std::vector<std::string> arguments;
    int code;
    std::string part;
  };
  const Case cases[] = {
      {{"--source", "oni:/no/such/file.oni", "--port", "0"}, 1, "/no/such/file.oni"},
      {{"--source", "teleporter", "--port", "0"}, 2, "teleporter"},
      {{"--source", "synthetic:colour=1", "--port", "0"}, 2, "'colour' is not a setting"},
      {{"--source", "synthetic", "--port", "0", "--ready-file", "/no/such/folder/ready"}, 1, "/no/such/folder/ready"},
      {{"--bind", "0.0.0.0"}, 2, "no key to protect the patient. fix: telepalp-keys authority"},
      {{"--port", "70000"}, 2, "--port"},
      {{"--jpeg-quality", "0"}, 2, "--jpeg-quality"},
      {{"--seconds", "soon"}, 2, "--seconds"},
      {{"--loop", "maybe"}, 2, "--loop"},
      {{"--depth-mode", "magic"}, 2, "--depth-mode"},
      {{"--depth-bound", "1,2.85"}, 2, "--depth-bound: the mode fast is lossless"},
      {{"--depth-mode", "bounded", "--depth-bound", "2"}, 2, "--depth-bound: '2' is not two numbers"},
      {{"--depth-mode", "bounded", "--depth-bound", "101,1"}, 2, "a number from 0 to 100"},
      {{"--depth-mode", "bounded", "--depth-bound", "1,-2"}, 2, "a number from 0 to 20"},
      {{"--depth-mode", "bounded", "--depth-bound", "nan,2"}, 2, "--depth-bound"},
      {{"--depth-mode", "bounded", "--depth-bound", "1,2,3"}, 2, "--depth-bound"},
      {{"--allow-origin", "https://app.example"}, 2, "--allow-origin: this option has no effect without --http-port"},
      {{"--viewer", "/no/such/folder"}, 2, "--viewer: this option has no effect without --http-port"},
      {{"--audit", "log"}, 2, "--audit: this option has no effect without --key"},
      {{"--record-key", "some.key"}, 2, "--record-key: this option has no effect without --record-dir"},
      {{"--sauce", "synthetic"}, 2, "sauce"}};
  for (const Case& asked : cases) {
    const auto [code, said] = outcome(asked.arguments);
    EXPECT_EQ(code, asked.code) << said;
    EXPECT_NE(said.find(asked.part), std::string::npos) << said;
    EXPECT_NE(said.find("fix: "), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace telepalp::server
