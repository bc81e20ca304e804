// The gateway over real sockets on loopback, with browsers and with hostile clients.

#include "server/gateway/gateway.h"

#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio/connect.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <future>
#include <thread>

#include "messages/recording.pb.h"
#include "server/gateway/monitoring/health_port.h"
#include "server/views/view_topics.h"

namespace telepalp::server {
namespace {

using namespace std::chrono_literals;
namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;

/// A hub and its gateway on their own thread, as in the server.
class Running {
 public:
  /// Runs `what` on the gateway's thread and waits for its result.
  template <class What>
  auto on_its_thread(What what) {
    const auto task = std::make_shared<std::packaged_task<decltype(what())()>>(std::move(what));
    auto done = task->get_future();
    asio::post(io_, [task] { (*task)(); });
    return done.get();
  }

  explicit Running(gateway::GatewayOptions options = {}) {
    options.port = 0;
    auto opened = gateway::Gateway::open(
        io_, hub_, [] { return session_time(42); }, options);
    demand(opened.ok(), "the gateway opens");
    gateway_ = std::move(opened).value();
    thread_ = std::thread([this] { io_.run(); });
  }
  ~Running() {
    on_its_thread([this] { gateway_.reset(); });
    work_.reset();
    thread_.join();
  }

  void publish(const wire::Topic& topic, std::string payload, std::int64_t at_ns = 7) {
    const wire::Message message{topic, session_time(at_ns), std::make_shared<const std::string>(std::move(payload)), 0,
                                true};
    on_its_thread([&] { hub_.publish(message); });
  }
  std::size_t connections() {
    return on_its_thread([this] { return gateway_->connections(); });
  }
  /// True once `count` connections are open; false when that has not happened within 5 s.
  bool comes_to(std::size_t count) {
    for (int tries = 0; tries < 500 && connections() != count; ++tries) std::this_thread::sleep_for(10ms);
    return connections() == count;
  }
  std::uint64_t dropped(std::string_view topic) {
    return on_its_thread([&] { return hub_.topic_counts().at(topic).dropped; });
  }
  std::uint16_t port() const { return gateway_->port(); }

 private:
  asio::io_context io_;
  asio::executor_work_guard<asio::io_context::executor_type> work_ = asio::make_work_guard(io_);
  hub::Hub hub_;
  std::unique_ptr<gateway::Gateway> gateway_;
  std::thread thread_;
};

tcp::socket connected(asio::io_context& io, std::uint16_t port) {
  tcp::socket socket(io);
  socket.connect({asio::ip::make_address("127.0.0.1"), port});
  return socket;
}

struct Headers {
  std::string subprotocol = "foxglove.websocket.v1";
  std::string origin{};
  std::string host{};
};

/// The HTTP status of an upgrade with these headers; 0 when the server closes without a reply.
int upgrade_status(std::uint16_t port, const Headers& headers = {}) {
  asio::io_context io;
  tcp::socket socket = connected(io, port);
  std::string request =
      "GET / HTTP/1.1\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
  request += "Host: " + (headers.host.empty() ? "127.0.0.1:" + std::to_string(port) : headers.host) + "\r\n";
  if (!headers.subprotocol.empty()) request += "Sec-WebSocket-Protocol: " + headers.subprotocol + "\r\n";
  if (!headers.origin.empty()) request += "Origin: " + headers.origin + "\r\n";
  beast::error_code ignored;
  asio::write(socket, asio::buffer(request + "\r\n"), ignored);
  std::string answer;
  asio::read_until(socket, asio::dynamic_buffer(answer), "\r\n", ignored);
  return answer.size() < 12 ? 0 : std::stoi(answer.substr(9, 3));
}

/// A WebSocket client of Beast's own making.
class Viewer {
 public:
  explicit Viewer(std::uint16_t port, Headers headers = {}) : stream_(connected(io_, port)) {
    stream_.read_message_max(64 << 20);
    stream_.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
      if (!headers.subprotocol.empty()) request.set(http::field::sec_websocket_protocol, headers.subprotocol);
      if (!headers.origin.empty()) request.set(http::field::origin, headers.origin);
    }));
    const std::string host = headers.host.empty() ? "127.0.0.1:" + std::to_string(port) : headers.host;
    websocket::response_type response;
    beast::error_code failed;
    stream_.handshake(response, host, "/any/path", failed);
    if (!failed) subprotocol = std::string(response[http::field::sec_websocket_protocol]);
  }

  std::string read() {
    beast::flat_buffer buffer;
    stream_.read(buffer, failed_);
    return failed_ ? std::string() : beast::buffers_to_string(buffer.data());
  }
  void send(const std::string& text, bool binary = false) {
    stream_.binary(binary);
    stream_.write(asio::buffer(text), failed_);
  }
  /// Subscribes to `channel` as subscription `id`, and waits until the server has handled it.
  void subscribe(int id, int channel) {
    send(R"({"op":"subscribe","subscriptions":[{"id":)" + std::to_string(id) + R"(,"channelId":)" +
         std::to_string(channel) + "}]}");
    send("?");  // the server answers with a warning, after all earlier messages
    while (!failed_ && read().find("is not JSON") == std::string::npos) {
    }
  }
  bool failed() const { return bool(failed_); }
  std::string failure() const { return failed_.message(); }
  auto close_code() const { return stream_.reason().code; }
  tcp::socket& socket() { return stream_.next_layer(); }

  std::string subprotocol;

 private:
  asio::io_context io_;
  websocket::stream<tcp::socket> stream_;
  beast::error_code failed_;
};

/// Sends `request` unchanged and returns all bytes until the server closes.
std::string answer_to(std::uint16_t port, const std::string& request) {
  asio::io_context io;
  tcp::socket socket = connected(io, port);
  beast::error_code ignored;
  asio::write(socket, asio::buffer(request), ignored);
  std::string answer;
  asio::read(socket, asio::dynamic_buffer(answer), ignored);
  return answer;
}

constexpr int kColorChannel = 1;
constexpr int kDepthChannel = 2;
constexpr int kClockChannel = 5;
constexpr int kRecordingChannel = static_cast<int>(wire::kTopics.size() + views::kViewTopics.size()) + 6;

TEST(Gateway, AViewerIsGreetedAndGetsWhatItAsksForWithTimeAndSubscription) {
  Running server;
  Viewer viewer(server.port());
  EXPECT_EQ(viewer.subprotocol, "foxglove.websocket.v1");
  EXPECT_NE(viewer.read().find(R"("op":"serverInfo")"), std::string::npos);
  const std::string advertise = viewer.read();
  EXPECT_NE(advertise.find(R"("topic":"/camera/depth")"), std::string::npos);
  EXPECT_NE(advertise.find(R"("schemaEncoding":"protobuf")"), std::string::npos);
  viewer.subscribe(9, kClockChannel);
  server.publish(wire::kCameraDepth, "not asked for");
  server.publish(wire::kClock, "tick", 0x0102);
  EXPECT_EQ(viewer.read(), std::string("\x01\x09\0\0\0\x02\x01\0\0\0\0\0\0tick", 17));
}

/// Options with the recording's state, whose file is named by `number`.
gateway::GatewayOptions with_recording(std::shared_ptr<std::atomic<int>> number) {
  gateway::GatewayOptions options;
  options.resources[origin::kRecording.topic.name] = {
      .state =
          [number] {
            msg::RecordingState state;
            state.set_file(std::to_string(*number));
            return origin::state_message(state);
          },
      .change = origin::at_once([number](const std::string&, const std::string&) -> Result<void> {
        ++*number;
        return {};
      })};
  return options;
}

TEST(Gateway, StatesAreTopicsThatANewcomerGetsAtOnceAndAnotherSeesChangeWithin300ms) {
  const auto number = std::make_shared<std::atomic<int>>(1);
  Running server(with_recording(number));
  Viewer first(server.port());
  (void)first.read();
  const std::string advertised = first.read();
  EXPECT_NE(advertised.find(R"("topic":"/recording")"), std::string::npos);
  EXPECT_EQ(advertised.find(R"("topic":"/playback")"), std::string::npos) << "this server plays no session";
  const std::string wanted =
      R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":)" + std::to_string(kRecordingChannel) + "}]}";
  first.send(wanted);
  EXPECT_NE(first.read().find("\x12\x01"
                              "1"),
            std::string::npos);
  const auto posted = std::chrono::steady_clock::now();
  const std::string answer = answer_to(server.port(),
                                       "POST /recording HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n"
                                       "Content-Length: 2\r\n\r\n{}");
  EXPECT_NE(answer.find("State-Published: 42"), std::string::npos) << answer;
  EXPECT_NE(first.read().find("\x12\x01"
                              "2"),
            std::string::npos);
  EXPECT_LT(std::chrono::steady_clock::now() - posted, 300ms);
  *number = 3;  // without a command
  const auto changed = std::chrono::steady_clock::now();
  Viewer second(server.port());
  (void)second.read();
  (void)second.read();
  second.send(wanted);
  EXPECT_NE(second.read().find("\x12\x01"
                               "3"),
            std::string::npos);
  EXPECT_NE(first.read().find("\x12\x01"
                              "3"),
            std::string::npos);
  EXPECT_LT(std::chrono::steady_clock::now() - changed, 300ms);
}

TEST(Gateway, TheNewerSubprotocolIsSpokenToo) {
  Running server;
  EXPECT_EQ(Viewer(server.port(), {.subprotocol = "foxglove.sdk.v1"}).subprotocol, "foxglove.sdk.v1");
}

TEST(Gateway, AnUpgradeWithoutOurSubprotocolIsABadRequest) {
  Running server;
  EXPECT_EQ(upgrade_status(server.port(), {.subprotocol = ""}), 400);
  EXPECT_EQ(upgrade_status(server.port(), {.subprotocol = "mqtt"}), 400);
}

TEST(Gateway, ForeignPagesAreRefused) {
  Running server;
  EXPECT_EQ(upgrade_status(server.port(), {.origin = "http://evil.example"}), 403);
  EXPECT_EQ(upgrade_status(server.port(), {.origin = "http://evil.example", .host = "evil.example"}), 421);
  const std::string own = "http://127.0.0.1:" + std::to_string(server.port());
  EXPECT_EQ(upgrade_status(server.port(), {.origin = own}), 101);
}

TEST(Gateway, AnUnsubscribedTopicStopsAndAnUnknownChannelIsAWarning) {
  Running server;
  Viewer viewer(server.port());
  viewer.subscribe(1, kClockChannel);
  viewer.send(R"({"op":"unsubscribe","subscriptionIds":[1]})");
  viewer.send(R"({"op":"subscribe","subscriptions":[{"id":2,"channelId":99}]})");
  EXPECT_NE(viewer.read().find("there is no channel 99"), std::string::npos);
  server.publish(wire::kClock, "unheard");
  viewer.subscribe(3, kClockChannel);
  server.publish(wire::kClock, "heard");
  EXPECT_EQ(viewer.read().substr(13), "heard");
}

TEST(Gateway, EndsInTheMomentInWhichItsTimerIsDue) {
  for (int run = 0; run < 20; ++run) {
    asio::io_context io(1);
    hub::Hub hub;
    auto gateway = *gateway::Gateway::open(io, hub, [] { return session_time(42); }, {.port = 0});
    std::this_thread::sleep_for(origin::StatePublisher::kLook + 5ms);
    asio::post(io, [] {});  // while this runs, the timer's handler is queued behind the next one
    asio::post(io, [&] { gateway.reset(); });
    (void)io.poll();
  }
}

TEST(Gateway, AMessageThatIsTooLongClosesWith1009) {
  Running server;
  Viewer viewer(server.port());
  viewer.send(std::string(200'000, 'x'));
  while (!viewer.failed()) viewer.read();
  EXPECT_EQ(viewer.close_code(), websocket::close_code::too_big) << viewer.failure();
  EXPECT_TRUE(server.comes_to(0));
}

TEST(Gateway, AMessageOfEmptyFragmentsWithoutEndIsRefused) {
  Running server;
  asio::io_context io;
  tcp::socket socket = connected(io, server.port());
  asio::write(socket, asio::buffer("GET / HTTP/1.1\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                                   "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
                                   "Sec-WebSocket-Protocol: foxglove.websocket.v1\r\nHost: 127.0.0.1:" +
                                   std::to_string(server.port()) + "\r\n\r\n"));
  std::string answer;
  asio::read_until(socket, asio::dynamic_buffer(answer), "\r\n\r\n");
  const std::string first("\x01\x80\0\0\0\0", 6), next("\0\x80\0\0\0\0", 6);  // masked, without a payload
  std::string flood = first;
  for (int fragment = 0; fragment < 200'000; ++fragment) flood += next;
  beast::error_code cut_off;
  asio::write(socket, asio::buffer(flood), cut_off);
  EXPECT_TRUE(server.comes_to(0)) << "the viewer is still connected after 200 000 fragments";
}

TEST(Gateway, InvalidMessagesAreAnsweredAndBoundedWhileOthersAreServed) {
  Running server;
  Viewer hostile(server.port());
  Viewer honest(server.port());
  honest.subscribe(1, kClockChannel);
  for (int number = 0; number < 20'000; ++number) hostile.send(R"({"op":"subscribe","subscriptions":[{"id":1)");
  hostile.send("binary", true);
  server.publish(wire::kClock, "still here");
  EXPECT_EQ(honest.read().substr(13), "still here");
}

TEST(Gateway, AStalledViewerLosesItsOwnFramesAndNobodyElses) {
  Running server;
  Viewer stalled(server.port());
  Viewer quick(server.port());
  stalled.subscribe(1, kDepthChannel);
  quick.subscribe(1, kDepthChannel);
  const int frames = 60;
  for (int number = 0; number < frames; ++number) {
    server.publish(wire::kCameraDepth, std::string(300'000, 'd') + std::to_string(number));
    EXPECT_EQ(quick.read().substr(13 + 300'000), std::to_string(number));
  }
  EXPECT_GT(server.dropped(wire::kCameraDepth.name), 20u);
  int received = 0;
  std::string newest;
  while (newest != std::to_string(frames - 1)) {  // the queue ends with the newest message
    newest = stalled.read().substr(13 + 300'000);
    ++received;
  }
  EXPECT_LT(received, frames - 20);
}

TEST(Gateway, AViewerThatAnswersNoPingIsDropped) {
  Running server({.idle_timeout = 300ms});
  Viewer silent(server.port());  // Beast answers pings only while it reads
  ASSERT_TRUE(server.comes_to(1));
  EXPECT_TRUE(server.comes_to(0));
}

TEST(Gateway, ASlowRequestIsGivenUp) {
  Running server({.request_timeout = 200ms});
  asio::io_context io;
  tcp::socket slow = connected(io, server.port());
  asio::write(slow, asio::buffer(std::string("GET / HT")));
  ASSERT_TRUE(server.comes_to(1));
  EXPECT_TRUE(server.comes_to(0));
}

TEST(Gateway, BeyondItsLimitNewConnectionsGetAReasonAndSubscribersAreKept) {
  Running server({.max_connections = 2});
  Viewer one(server.port());
  Viewer two(server.port());
  one.subscribe(1, kClockChannel);
  two.subscribe(1, kClockChannel);
  EXPECT_EQ(upgrade_status(server.port()), 503);
  EXPECT_NE(answer_to(server.port(), "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
                .find("the server is full: all 2 places for browsers"),
            std::string::npos);
  server.publish(wire::kClock, "kept");
  EXPECT_EQ(one.read().substr(13), "kept");
}

/// A connection from the local address `from`, which sends nothing.
tcp::socket silent_from(const std::string& from, asio::io_context& io, std::uint16_t port) {
  tcp::socket socket(io);
  socket.open(tcp::v4());
  socket.bind({asio::ip::make_address(from), 0});
  socket.connect({asio::ip::make_address("127.0.0.1"), port});
  return socket;
}

TEST(Gateway, SilentConnectionsOfOneAddressKeepNobodyElseOut) {
  Running server({.max_connections = 8});
  asio::io_context io;
  std::vector<tcp::socket> silent;
  for (int number = 0; number < 64; ++number) silent.push_back(silent_from("127.0.3.1", io, server.port()));
  ASSERT_TRUE(server.comes_to(8));
  for (int time = 0; time < 32; ++time)
    ASSERT_EQ(
        answer_to(server.port(), "GET /health HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n").substr(0, 15),
        "HTTP/1.1 200 OK");
}

/// The replies to `target` at a port for monitoring while 64 silent connections hold it.
std::string reply_of_crowded_health_port(const std::string& target, const std::string& problem = "") {
  asio::io_context io;
  auto opened = gateway::HealthPort::open(
      io, {.problem = [problem] { return problem; }, .metrics = [] { return std::string("count 7"); }});
  demand(opened.ok(), "the port for monitoring opens");
  asio::io_context outside;
  std::vector<tcp::socket> silent;
  for (int number = 0; number < 64; ++number) silent.push_back(connected(outside, (*opened)->port()));
  std::thread running([&] { io.run_for(10s); });
  const std::string reply = answer_to((*opened)->port(), "GET " + target + " HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n");
  io.stop();
  running.join();
  return reply;
}

TEST(HealthPort, AnswersWhileSilentConnectionsHoldIt) {
  EXPECT_TRUE(reply_of_crowded_health_port("/health").starts_with("HTTP/1.1 200 OK"));
  EXPECT_NE(reply_of_crowded_health_port("/metrics").find("count 7"), std::string::npos);
  EXPECT_TRUE(reply_of_crowded_health_port("/").starts_with("HTTP/1.1 404"));
}

TEST(HealthPort, AFloodFromOneOrManyNetworksDoesNotCloseAConnectionThatAsksLate) {
  for (const int networks : {1, 64}) {
    asio::io_context io;
    auto opened = gateway::HealthPort::open(io, {.problem = [] { return std::string(); }});
    ASSERT_TRUE(opened.ok());
    std::thread running([&] { io.run_for(10s); });
    asio::io_context outside;
    tcp::socket late = connected(outside, (*opened)->port());
    std::vector<tcp::socket> silent;
    for (int number = 0; number < 300; ++number)
      silent.push_back(
          silent_from("127.0." + std::to_string(3 + number % networks) + ".1", outside, (*opened)->port()));
    asio::write(late, asio::buffer(std::string("GET /health HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")));
    std::string reply;
    boost::system::error_code over;
    asio::read(late, asio::dynamic_buffer(reply), over);
    EXPECT_TRUE(reply.starts_with("HTTP/1.1 200 OK")) << networks << ' ' << over.message();
    io.stop();
    running.join();
  }
}

TEST(HealthPort, SaysWhatIsWrong) {
  const std::string reply = reply_of_crowded_health_port("/health", "the camera is silent");
  EXPECT_TRUE(reply.starts_with("HTTP/1.1 503"));
  EXPECT_NE(reply.find("the camera is silent"), std::string::npos);
}

TEST(Gateway, AViewerThatSubscribedToNothingGivesItsPlaceToANewcomer) {
  Running server({.max_connections = 2});
  Viewer idle(server.port());
  idle.read();  // greeted
  Viewer busy(server.port());
  busy.subscribe(1, kClockChannel);
  Viewer newcomer(server.port());
  newcomer.subscribe(1, kClockChannel);
  while (!idle.failed()) idle.read();
  server.publish(wire::kClock, "heard");
  EXPECT_EQ(busy.read().substr(13), "heard");
  EXPECT_EQ(newcomer.read().substr(13), "heard");
}

TEST(Gateway, InvalidHttpIsRefusedWithinBounds) {
  Running server({.request_timeout = 1000ms});
  const std::string host = "Host: 127.0.0.1\r\n";
  EXPECT_NE(answer_to(server.port(), "\x16\x03\x01 hello\r\n\r\n").find("400"), std::string::npos);
  EXPECT_NE(answer_to(server.port(), "GET / HTTP/1.1\r\nX: " + std::string(20'000, 'x') + "\r\n\r\n").find(" 413 "),
            std::string::npos);
  EXPECT_NE(
      answer_to(server.port(), "POST / HTTP/1.1\r\n" + host + "Content-Length: 1099511627776\r\n\r\n").find(" 413 "),
      std::string::npos);
  EXPECT_NE(
      answer_to(server.port(), "GET /../../etc/passwd HTTP/1.1\r\n" + host + "Connection: close\r\n\r\n").find(" 404 "),
      std::string::npos);
  EXPECT_NE(answer_to(server.port(), "GET /session_clock HTTP/1.1\r\n" + host + "Connection: close\r\n\r\n")
                .find("\r\n\r\n42"),
            std::string::npos);
}

TEST(Gateway, APortInUseIsAnErrorThatNamesIt) {
  Running server;
  asio::io_context io;
  hub::Hub hub;
  const auto second = gateway::Gateway::open(io, hub, [] { return SessionTime{}; }, {.port = server.port()});
  ASSERT_FALSE(second);
  EXPECT_NE(to_string(second.error()).find(std::to_string(server.port())), std::string::npos);
}

TEST(Gateway, ClosingItClosesItsViewers) {
  auto server = std::make_unique<Running>();
  Viewer viewer(server->port());
  viewer.subscribe(1, kClockChannel);
  server.reset();
  viewer.read();
  EXPECT_TRUE(viewer.failed());
}

}  // namespace
}  // namespace telepalp::server
