// telepalp-link as its user runs it, between real sockets on loopback.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <boost/asio.hpp>
#include <csignal>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "tests/support/child_process.h"
#include "where.h"

namespace {

using namespace telepalp;
using namespace std::chrono_literals;
namespace asio = boost::asio;
using asio::ip::tcp;
using asio::ip::udp;

const asio::ip::address kLoopback = asio::ip::make_address("127.0.0.1");

/// The program between a client and `server_port`.
class RunningLink {
 public:
  RunningLink(std::uint16_t server_port, std::vector<std::string> options) {
    const std::vector<std::string> always{"--listen",     "127.0.0.1:0",
                                          "--connect",    "127.0.0.1:" + std::to_string(server_port),
                                          "--ready-file", (folder_.path() / "ready").string()};
    options.insert(options.begin(), always.begin(), always.end());
    process_.emplace(TELEPALP_BINARY_DIR "/bin/telepalp-link", options, folder_.path() / "log");
    const auto port = support::await_ready(folder_.path() / "ready", "port");
    if (port) port_ = static_cast<std::uint16_t>(std::stoi(*port));
  }
  [[nodiscard]] std::uint16_t port() const noexcept { return port_; }
  [[nodiscard]] support::ChildProcess& process() noexcept { return *process_; }
  [[nodiscard]] std::string log() const {
    std::ostringstream text;
    text << std::ifstream(folder_.path() / "log").rdbuf();
    return text.str();
  }

 private:
  support::TemporaryFolder folder_;
  std::optional<support::ChildProcess> process_;
  std::uint16_t port_ = 0;
};

/// Sends each datagram that arrives back, for as long as the object lives.
class UdpEcho {
 public:
  UdpEcho() : socket_(io_, udp::endpoint(kLoopback, 0)) {
    receive();
    thread_ = std::thread([this] { io_.run(); });
  }
  ~UdpEcho() {
    io_.stop();
    thread_.join();
  }
  [[nodiscard]] std::uint16_t port() const { return socket_.local_endpoint().port(); }

 private:
  void receive() {
    socket_.async_receive_from(asio::buffer(buffer_), from_,
                               [this](boost::system::error_code failed, std::size_t bytes) {
                                 boost::system::error_code lost;
                                 if (!failed) socket_.send_to(asio::buffer(buffer_, bytes), from_, 0, lost);
                                 receive();
                               });
  }
  asio::io_context io_;
  udp::socket socket_;
  udp::endpoint from_;
  std::array<char, 2048> buffer_{};
  std::thread thread_;
};

/// Sends `count` numbered datagrams 2 ms apart and returns the round trips in ms of those that come back within 1 s.
std::vector<double> udp_round_trips(std::uint16_t port, int count) {
  asio::io_context io;
  udp::socket socket(io, udp::endpoint(kLoopback, 0));
  socket.connect({kLoopback, port});
  socket.non_blocking(true);
  std::vector<std::chrono::steady_clock::time_point> sent;
  std::vector<double> round_trips;
  const auto receive = [&](std::chrono::milliseconds span) {
    const auto until = std::chrono::steady_clock::now() + span;
    while (std::chrono::steady_clock::now() < until) {
      std::array<char, 2048> answer{};
      boost::system::error_code none;
      if (socket.receive(asio::buffer(answer), 0, none) > 0 && !none)
        round_trips.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() -
                                                                        sent.at(std::stoul(answer.data())))
                                  .count());
      else
        std::this_thread::sleep_for(200us);
    }
  };
  for (int i = 0; i < count; ++i) {
    sent.push_back(std::chrono::steady_clock::now());
    socket.send(asio::buffer(std::to_string(i) + '\0'));
    receive(2ms);
  }
  receive(1s);
  return round_trips;
}

TEST(LinkProgram, DelaysAndLosesDatagramsBetweenRealSockets) {
  const UdpEcho server;
  RunningLink link(server.port(), {"--delay-ms", "30", "--loss-percent", "20", "--seed", "7"});
  ASSERT_NE(link.port(), 0) << link.log();
  const std::vector<double> round_trips = udp_round_trips(link.port(), 500);
  EXPECT_GE(*std::min_element(round_trips.begin(), round_trips.end()), 60.0);
  EXPECT_NEAR(static_cast<double>(round_trips.size()), 500 * 0.8 * 0.8, 40.0);
}

TEST(LinkProgram, ForwardsAStreamWholeThroughLossAndAThinPipe) {
  asio::io_context io;
  tcp::acceptor acceptor(io, tcp::endpoint(kLoopback, 0));
  RunningLink link(acceptor.local_endpoint().port(), {"--profile", "hostile", "--rate-kbit-per-s", "16000"});
  ASSERT_NE(link.port(), 0) << link.log();
  std::string sent(600'000, ' ');
  for (std::size_t i = 0; i < sent.size(); ++i) sent[i] = static_cast<char>('a' + i % 23);

  std::thread server([&] {
    tcp::socket peer = acceptor.accept();
    boost::system::error_code ignored;
    asio::write(peer, asio::buffer(sent), ignored);
    peer.shutdown(tcp::socket::shutdown_send, ignored);
    std::string rest;
    asio::read(peer, asio::dynamic_buffer(rest), ignored);  // until the client closes
  });
  const auto began = std::chrono::steady_clock::now();
  tcp::socket client(io);
  client.connect({kLoopback, link.port()});
  std::string received;
  boost::system::error_code end;
  asio::read(client, asio::dynamic_buffer(received), end);
  const auto took = std::chrono::steady_clock::now() - began;
  client.close();
  server.join();
  EXPECT_EQ(end, asio::error::eof);
  EXPECT_EQ(received, sent);
  EXPECT_GE(took, 300ms);  // 0.6 MB at 2 MB/s
}

TEST(LinkProgram, ClosesTheClientWhenTheServerCannotBeReached) {
  asio::io_context io;
  std::uint16_t nobody = 0;
  {
    tcp::acceptor acceptor(io, tcp::endpoint(kLoopback, 0));
    nobody = acceptor.local_endpoint().port();
  }
  RunningLink link(nobody, {});
  ASSERT_NE(link.port(), 0) << link.log();
  tcp::socket client(io);
  client.connect({kLoopback, link.port()});
  boost::system::error_code end;
  char byte = 0;
  asio::read(client, asio::buffer(&byte, 1), end);
  EXPECT_TRUE(end) << "a byte came from nowhere";
  EXPECT_EQ(link.process().wait(0ms), std::nullopt);
}

/// The processor time that `process` has used.
std::chrono::milliseconds processor_time(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string word;
  std::array<long, 2> ticks{};  // utime and stime, the fields 14 and 15; the name has no space
  for (int field = 1; field <= 13; ++field) stat >> word;
  stat >> ticks[0] >> ticks[1];
  return std::chrono::milliseconds((ticks[0] + ticks[1]) * 1000 / ::sysconf(_SC_CLK_TCK));
}

TEST(LinkProgram, WaitsWithoutWorkWhileNoFileDescriptorIsFreeAndAcceptsAfterwards) {
  asio::io_context io;
  tcp::acceptor acceptor(io, tcp::endpoint(kLoopback, 0));
  RunningLink link(acceptor.local_endpoint().port(), {});
  ASSERT_NE(link.port(), 0) << link.log();
  rlimit before{};
  ASSERT_EQ(::prlimit(link.process().pid(), RLIMIT_NOFILE, nullptr, &before), 0);
  const rlimit full{.rlim_cur = 3, .rlim_max = before.rlim_max};
  ASSERT_EQ(::prlimit(link.process().pid(), RLIMIT_NOFILE, &full, nullptr), 0);
  tcp::socket client(io);
  client.connect({kLoopback, link.port()});  // the kernel connects it, and the program cannot accept it
  const auto used = processor_time(link.process().pid());
  std::this_thread::sleep_for(1s);
  EXPECT_LT(processor_time(link.process().pid()) - used, 40ms);
  ASSERT_EQ(::prlimit(link.process().pid(), RLIMIT_NOFILE, &before, nullptr), 0);
  tcp::socket server = acceptor.accept();
  EXPECT_TRUE(server.is_open());
}

TEST(LinkProgram, LogsEachSecondAndEndsWithSuccessOnCtrlC) {
  const UdpEcho server;
  RunningLink link(server.port(), {"--profile", "lan"});
  ASSERT_NE(link.port(), 0) << link.log();
  (void)udp_round_trips(link.port(), 10);
  std::this_thread::sleep_for(1200ms);
  link.process().signal(SIGINT);
  EXPECT_EQ(link.process().wait(5s), 0);
  EXPECT_NE(link.log().find("10 new packets, lost 0.0 %"), std::string::npos) << link.log();
}

/// glibc overwrites freed memory, so that a part of the proxy that is used after its end ends the program.
TEST(LinkProgram, EndsWithSuccessWhileConnectionsThroughItAreOpen) {
  ::setenv("MALLOC_PERTURB_", "165", 1);
  for (int run = 0; run < 5; ++run) {
    asio::io_context io;
    tcp::acceptor server(io, {kLoopback, 0});
    RunningLink link(server.local_endpoint().port(), {"--profile", "lan", "--quiet"});
    ASSERT_NE(link.port(), 0) << link.log();
    tcp::socket client(io);
    client.connect({kLoopback, link.port()});
    tcp::socket accepted = server.accept();
    asio::write(client, asio::buffer(std::string(100'000, 'x')));
    asio::write(accepted, asio::buffer(std::string(100'000, 'y')));
    link.process().signal(SIGTERM);
    EXPECT_EQ(link.process().wait(5s), 0) << "139: a segmentation fault";
  }
  ::unsetenv("MALLOC_PERTURB_");
}

TEST(LinkProgram, WhatIsAskedWronglyEndsWithTwo) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--profile", "wifi"},
                                                {"--loss-percent", "101"},
                                                {"--delay-ms", "-1"},
                                                {"--trace", "/nonexistent.csv"},
                                                {"--connect", "somewhere"},
                                                {"--connect", "127.0.0.1:7401"},
                                                {"--seed", "many"},
                                                {"--listen", "127.0.0.1:-1"}}) {
    support::ChildProcess process(TELEPALP_BINARY_DIR "/bin/telepalp-link", words, "/dev/null");
    EXPECT_EQ(process.wait(10s), 2) << words[0] << " " << words[1];
  }
}

}  // namespace
