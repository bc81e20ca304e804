// The real server while peers publish as fast as a socket takes it and one never reads.

#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio/write.hpp>
#include <fstream>
#include <thread>

#include "tests/server/loopback_site.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::server {
namespace {

using boost::asio::ip::tcp;

constexpr double kMiB = 1024.0 * 1024.0;

double resident_MiB(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024.0;
  return 0.0;
}

msg::Control hello() {
  msg::Control control;
  control.mutable_hello()->set_protocol(wire::kProtocolVersion);
  control.mutable_hello()->set_name("flood");
  return control;
}

tcp::socket connected(boost::asio::io_context& io, std::uint16_t port) {
  tcp::socket socket(io);
  socket.connect({boost::asio::ip::make_address("127.0.0.1"), port});
  return socket;
}

/// A message of 0.9 MiB that parses as any type, because parsers skip unknown fields.
std::string heavy_payload() {
  constexpr std::size_t kBytes = 900 << 10;
  std::string payload = "\x7a";  // field 15, length-delimited
  for (std::size_t rest = kBytes; rest != 0; rest >>= 7)
    payload += static_cast<char>((rest & 0x7f) | (rest > 0x7f ? 0x80 : 0));
  return payload + std::string(kBytes, 'x');
}

/// Publishes heavy messages of one topic on a thread of its own until it is destroyed.
class Flood {
 public:
  Flood(std::uint16_t port, const wire::Topic& topic)
      : socket_(connected(io_, port)), topic_(topic), thread_([this] { run(); }) {}
  ~Flood() {
    stop_ = true;
    boost::system::error_code ignored;
    socket_.shutdown(tcp::socket::shutdown_both, ignored);
    thread_.join();
  }
  double sent_MiB() const { return static_cast<double>(sent_bytes_) / kMiB; }

 private:
  void run() {
    msg::Control advertise;
    msg::Advertise::Topic& topic = *advertise.mutable_advertise()->add_topics();
    topic.set_channel(1);
    topic.set_name(std::string(topic_.name));
    topic.set_schema(std::string(topic_.schema));
    const std::string bytes = data_frame(1, heavy_payload());
    boost::system::error_code failed;
    boost::asio::write(socket_, boost::asio::buffer(control_frame(hello()) + control_frame(advertise)), failed);
    while (!stop_ && !failed) sent_bytes_ += boost::asio::write(socket_, boost::asio::buffer(bytes), failed);
  }

  boost::asio::io_context io_;
  tcp::socket socket_;
  wire::Topic topic_;
  std::atomic<bool> stop_ = false;
  std::atomic<std::size_t> sent_bytes_ = 0;
  std::thread thread_;
};

TEST(Flood, SixPublishersAndOneThatNeverReadsCostTheServerNoMemoryAndTheDoctorNoImage) {
  const support::TemporaryFolder folder;
  support::ChildProcess server(TELEPALP_BINARY_DIR "/bin/telepalp-server",
                               {"--source", "synthetic", "--port", "0", "--ready-file", folder.path() / "ready"},
                               folder.path() / "log");
  const auto ready = support::await_ready(folder.path() / "ready", "port");
  ASSERT_TRUE(ready);
  const auto port = static_cast<std::uint16_t>(std::stoi(*ready));
  boost::asio::io_context io;
  std::size_t images = 0;
  wire::ClientLink doctor(io, {.port = port, .name = "doctor", .role = "doctor", .subscribes = {"/camera/depth"}},
                          {.on_message = [&](const wire::Message&) { ++images; }});
  doctor.start();
  io.run_for(2s);
  const double before_MiB = resident_MiB(server.pid());
  const auto missed_before = doctor.received()[wire::kCameraDepth.name].missed;
  images = 0;

  tcp::socket deaf = connected(io, port);
  msg::Control everything;
  everything.mutable_subscribe()->add_topics("*");
  boost::asio::write(deaf, boost::asio::buffer(control_frame(hello()) + control_frame(everything)));
  double most_MiB = 0.0;
  double sent_MiB = 0.0;
  {
    std::vector<std::unique_ptr<Flood>> floods;
    for (const wire::Topic& topic : {wire::kStationState, wire::kStationTicks, wire::kStationSurface,
                                     wire::kStationCompensation, wire::kStationEvents, wire::kStationStats})
      floods.push_back(std::make_unique<Flood>(port, topic));
    for (int tenth = 0; tenth < 40; ++tenth) {
      io.run_for(100ms);
      most_MiB = std::max(most_MiB, resident_MiB(server.pid()));
    }
    for (const auto& flood : floods) sent_MiB += flood->sent_MiB();
  }
  const auto missed = doctor.received()[wire::kCameraDepth.name].missed - missed_before;
  const std::size_t received = images;
  deaf.close();
  io.run_for(3s);
  const double after_MiB = resident_MiB(server.pid());
  std::printf("sent %.0f MiB; resident %.1f MiB before, %.1f most, %.1f after; images %zu, missed %llu\n", sent_MiB,
              before_MiB, most_MiB, after_MiB, received, static_cast<unsigned long long>(missed));
  EXPECT_GT(sent_MiB, 20.0) << "the flood came";
  EXPECT_LT(most_MiB, before_MiB + 100.0);
  EXPECT_LT(after_MiB, before_MiB + 24.0);
  EXPECT_GT(received, 20u);
  EXPECT_LE(missed, received / 20);
}

}  // namespace
}  // namespace telepalp::server
