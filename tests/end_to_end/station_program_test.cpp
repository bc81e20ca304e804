// telepalp-station as an operator runs it: the real program with the real server, and usual problems.

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>
#include <thread>

#include "messages/station.pb.h"
#include "proto/wire/client/client_link.h"
#include "proto/wire/connection/connection.h"
#include "support/images/image_file.h"
#include "tests/support/child_process.h"
#include "tests/support/terminal.h"
#include "where.h"

namespace telepalp {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;
using support::ChildProcess;

const fs::path kPrograms = TELEPALP_BINARY_DIR "/bin";

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::size_t times(const std::string& text, const std::string& phrase) {
  std::size_t count = 0;
  for (std::size_t at = text.find(phrase); at != std::string::npos; at = text.find(phrase, at + 1)) ++count;
  return count;
}

/// Waits until `phrase` is in `log`, `least` times.
bool hears(const fs::path& log, const std::string& phrase, std::size_t least = 1) {
  for (int tenth = 0; tenth < 600; ++tenth) {
    if (times(text_of(log), phrase) >= least) return true;
    std::this_thread::sleep_for(100ms);
  }
  return false;
}

/// What a station publishes, as a subscriber of its server sees it.
class Subscriber {
 public:
  explicit Subscriber(const std::string& port)
      : link_(io_,
              {.port = static_cast<std::uint16_t>(std::stoi(port)),
               .name = "test",
               .subscribes = {std::string(wire::kStationTicks.name), std::string(wire::kStationStats.name)},
               .datagrams = false},
              {.on_message = [this](const wire::Message& message) { on_message(message); }}) {
    link_.start();
  }
  bool awaits(const std::function<bool()>& done) {
    for (int tenth = 0; tenth < 600 && !done(); ++tenth) io_.run_for(100ms);
    return done();
  }

  std::uint64_t tick = 0;         // number of the last tick since the station's start
  int starts = 0;                 // starts of the station: its ticks are numbered from 0 again
  std::set<std::string> effects;  // of the newest bill

 private:
  void on_message(const wire::Message& message) {
    if (msg::StationTicks ticks; message.topic.name == wire::kStationTicks.name) {
      ASSERT_TRUE(ticks.ParseFromString(*message.payload));
      if (ticks.first_tick() <= tick) ++starts;
      tick = ticks.first_tick();
    }
    if (msg::StationStats stats; message.topic.name == wire::kStationStats.name) {
      ASSERT_TRUE(stats.ParseFromString(*message.payload));
      effects.clear();
      for (const msg::EffectCost& cost : stats.bill()) effects.insert(cost.name());
    }
  }

  boost::asio::io_context io_;
  wire::ClientLink link_;
};

class StationProgram : public ::testing::Test {
 protected:
  StationProgram() { ::setenv("XDG_CACHE_HOME", (folder_.path() / "cache").c_str(), 1); }
  ~StationProgram() override { ::unsetenv("XDG_CACHE_HOME"); }

  std::string start_server(const std::string& port, std::vector<std::string> options = {}) {
    const fs::path ready = folder_.path() / "ready";
    fs::remove(ready);
    options.insert(options.end(), {"--port", port, "--ready-file", ready.string()});
    server_.emplace(kPrograms / "telepalp-server", options, folder_.path() / "server.log");
    return support::await_ready(ready, "port").value_or("");
  }
  int run(std::vector<std::string> arguments) {
    ChildProcess station(kPrograms / "telepalp-station", arguments, log());
    return station.wait(30s).value_or(-1);
  }
  [[nodiscard]] fs::path log() const { return folder_.path() / "station.log"; }

  support::TemporaryFolder folder_;
  std::optional<ChildProcess> server_;
};

TEST_F(StationProgram, GoesOnTouchingWhenTheServerComesBack) {
  const std::string port = start_server("0");
  ASSERT_FALSE(port.empty());
  ChildProcess station(kPrograms / "telepalp-station", {"--connect", "127.0.0.1:" + port}, log());
  ASSERT_TRUE(hears(log(), "control loop runs at 2 kHz")) << text_of(log());
  server_->signal(SIGKILL);
  ASSERT_TRUE(hears(log(), "link lost")) << text_of(log());
  ASSERT_EQ(start_server(port), port);
  ASSERT_TRUE(hears(log(), "link connected", 2)) << text_of(log());
  station.signal(SIGINT);
  EXPECT_EQ(station.wait(10s), 0) << text_of(log());
}

TEST_F(StationProgram, KeepsItsSceneWhileANewOneIsRefused) {
  const fs::path scene = folder_.path() / "mass.scene.textproto";
  fs::copy_file(TELEPALP_SOURCE_DIR "/haptic_station/scenes/mass-search.scene.textproto", scene);
  const std::string port = start_server("0");
  ASSERT_FALSE(port.empty());
  ChildProcess station(kPrograms / "telepalp-station", {"--connect", "127.0.0.1:" + port, "--scene", scene.string()},
                       log());
  ASSERT_TRUE(hears(log(), "control loop runs at 2 kHz")) << text_of(log());
  std::ofstream(scene) << "haptic_from_camera { } effects { solid { name: \"a\" polish: \"sphere -1\" } }";
  ChildProcess refused(kPrograms / "telepalp-station", {"scene", "check", scene.string()},
                       folder_.path() / "check.log");
  EXPECT_EQ(refused.wait(10s), 1);
  EXPECT_NE(text_of(folder_.path() / "check.log").find("radius_m of sphere is -1"), std::string::npos);
  server_->signal(SIGKILL);  // the station keeps its scene over a new connection, though the file is bad
  ASSERT_TRUE(hears(log(), "link lost")) << text_of(log());
  ASSERT_EQ(start_server(port), port);
  ASSERT_TRUE(hears(log(), "link connected", 2)) << text_of(log());
  station.signal(SIGINT);
  EXPECT_EQ(station.wait(10s), 0) << text_of(log());
  EXPECT_EQ(times(text_of(log()), "error:"), 0u) << text_of(log());
}

TEST_F(StationProgram, ReadsItsSceneAgainAtSighupAndKeepsItsSceneIfTheNewOneIsRefused) {
  ::signal(SIGHUP, SIG_DFL);  // a station that is started with nohup, as this test may be, ignores SIGHUP
  const fs::path shipped = TELEPALP_SOURCE_DIR "/haptic_station/scenes";
  const fs::path scene = folder_.path() / "mine.scene.textproto";
  fs::copy_file(shipped / "skin.scene.textproto", scene);
  const std::string port = start_server("0");
  ASSERT_FALSE(port.empty());
  Subscriber subscriber(port);
  ChildProcess station(kPrograms / "telepalp-station", {"--connect", "127.0.0.1:" + port, "--scene", scene.string()},
                       log());
  ASSERT_TRUE(subscriber.awaits([&] { return subscriber.effects == std::set<std::string>{"skin"}; })) << text_of(log());
  const int starts = subscriber.starts;

  std::ofstream(scene) << "haptic_from_camera { }\neffects { solid { name: \"a\" polish: \"sphere -1\" } }\n";
  station.signal(SIGHUP);
  ASSERT_TRUE(hears(log(), "the station keeps its scene; the new one is refused: ")) << text_of(log());
  EXPECT_EQ(times(text_of(log()), "mine.scene.textproto:2:"), 1u) << "names the line: " << text_of(log());
  EXPECT_EQ(times(text_of(log()), "radius_m of sphere is -1"), 1u) << text_of(log());
  const std::uint64_t tick = subscriber.tick;
  EXPECT_TRUE(subscriber.awaits([&] { return subscriber.tick > tick + 4000; })) << "2 s of ticks: " << text_of(log());
  EXPECT_EQ(subscriber.starts, starts) << "the ticks go on";
  EXPECT_EQ(subscriber.effects, std::set<std::string>{"skin"});
  EXPECT_EQ(times(text_of(log()), "link connected"), 1u) << text_of(log());
  EXPECT_EQ(times(text_of(log()), "link lost"), 0u) << text_of(log());
  EXPECT_EQ(times(text_of(log()), "ending"), 0u) << text_of(log());

  fs::copy_file(shipped / "mass-search.scene.textproto", scene, fs::copy_options::overwrite_existing);
  station.signal(SIGHUP);
  ASSERT_TRUE(hears(log(), "starts again with the new scene mass-search")) << text_of(log());
  EXPECT_TRUE(subscriber.awaits([&] { return subscriber.effects.contains("mass"); })) << text_of(log());
  EXPECT_EQ(subscriber.starts, starts + 1);
  EXPECT_EQ(times(text_of(log()), "link connected"), 2u) << text_of(log());
  station.signal(SIGTERM);
  EXPECT_EQ(station.wait(60s), 0) << text_of(log());
}

TEST_F(StationProgram, EndsWhenItsTerminalIsClosed) {
  ::signal(SIGHUP, SIG_DFL);
  support::Terminal terminal(
      {"sh", "-c", "exec " + (kPrograms / "telepalp-station").string() + " --connect 127.0.0.1:9 2>" + log().string()});
  ASSERT_TRUE(hears(log(), "waiting for the server")) << text_of(log());
  ::kill(terminal.pid(), SIGHUP);
  ASSERT_TRUE(hears(log(), "starts again with the new scene palpation")) << text_of(log());
  terminal.close();
  EXPECT_EQ(terminal.wait(60s), 0) << text_of(log());
  EXPECT_EQ(times(text_of(log()), "reads the scene again"), 1u) << text_of(log());
}

TEST_F(StationProgram, WaitsForAServerThatComesLaterAndSaysSoOnce) {
  const std::string port = start_server("0");
  server_.reset();
  ChildProcess station(kPrograms / "telepalp-station", {"--connect", "127.0.0.1:" + port}, log());
  ASSERT_TRUE(hears(log(), "waiting for the server")) << text_of(log());
  std::this_thread::sleep_for(2s);
  EXPECT_EQ(times(text_of(log()), "Connection refused"), 1u) << text_of(log());
  ASSERT_EQ(start_server(port), port);
  EXPECT_TRUE(hears(log(), "control loop runs at 2 kHz")) << text_of(log());
}

TEST_F(StationProgram, EndsWellAtCtrlCBeforeAnythingIsConnected) {
  ChildProcess station(kPrograms / "telepalp-station", {"--connect", "127.0.0.1:9"}, log());
  ASSERT_TRUE(hears(log(), "waiting for the server")) << text_of(log());
  station.signal(SIGINT);
  EXPECT_EQ(station.wait(10s), 0);
}

/// Eight layers of 24 rings each: their surfaces for viewers take some seconds, more on a loaded machine.
TEST_F(StationProgram, EndsAtOnceAtCtrlCWhileTheLayersSurfacesAreMade) {
  std::string ribs = "torusz 0.1 0.008 ";
  for (int i = 1; i < 24; ++i) ribs = "+ tr 0 0 " + std::to_string(0.02 * i) + " torusz 0.1 0.008 " + ribs;
  std::string scene =
      "name: \"heavy\" purpose: \"end while it is made\" patient_surface { streamed {} }\n"
      "haptic_from_camera { translation_m { y: 0.8 } rotation_vector_rad { x: 1.5707963 } }\n"
      "center_on_surface: true\n"
      "haptic_from_tracker { translation_m { y: 0.25 } rotation_vector_rad { x: 3.1415926 } }\n";
  for (int i = 0; i < 8; ++i)
    scene += "effects { solid { name: \"ribs " + std::to_string(i) +
             "\" stiffness_N_per_m: 20 polish: \"tr 0 -0.15 0 " + ribs + "\" } }\n";
  const fs::path file = folder_.path() / "heavy.scene.textproto";
  std::ofstream(file) << scene;
  const std::string port = start_server("0");
  ChildProcess station(kPrograms / "telepalp-station",
                       {"--connect", "127.0.0.1:" + port, "--scene", file.string(), "--control", "none"}, log());
  ASSERT_TRUE(hears(log(), "control loop runs at 2 kHz")) << text_of(log());
  const auto asked = std::chrono::steady_clock::now();
  station.signal(SIGINT);
  EXPECT_EQ(station.wait(10s), 0) << text_of(log());
  EXPECT_LT(std::chrono::steady_clock::now() - asked, 2s) << text_of(log());
  EXPECT_EQ(text_of(log()).find("inner surfaces for viewers are made"), std::string::npos)
      << "they were made before the signal, so that this test says nothing";
}

TEST_F(StationProgram, EndsWhenNoServerAnswersForAsLongAsItIsAskedToWait) {
  EXPECT_EQ(run({"--connect", "127.0.0.1:9", "--seconds", "1", "--patience", "0.5"}), 1) << text_of(log());
  EXPECT_NE(text_of(log()).find("error: 127.0.0.1:9: does not answer (Connection refused). fix: start telepalp-server"),
            std::string::npos)
      << text_of(log());
}

TEST_F(StationProgram, ACameraThatSeesNoPatientIsNamedInAFewLinesAndInTheFinalError) {
  const fs::path shown = folder_.path() / "images";
  fs::create_directories(shown);
  const images::GrayImage16 nothing{160, 120, std::vector<std::uint16_t>(160 * 120, 0)};
  for (const char* name : {"1.png", "2.png", "3.png"})
    std::ofstream(shown / name, std::ios::binary) << images::encode_png(nothing);
  const std::string port = start_server("0", {"--source", "images:" + shown.string()});
  ASSERT_FALSE(port.empty());
  EXPECT_EQ(run({"--connect", "127.0.0.1:" + port, "--patience", "7"}), 1);
  const std::string said = text_of(log());
  EXPECT_NE(said.find("error: 127.0.0.1:" + port + ": none of the server's "), std::string::npos) << said;
  EXPECT_NE(said.find("could be used; the last one: fewer than half of the pixels around the image's centre"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("aim the camera at the patient, from a distance at which it measures, or wait longer"),
            std::string::npos)
      << said;
  EXPECT_LE(times(said, "depth image dropped"), 3u) << said;
}

TEST_F(StationProgram, RunsWithoutItsControlSocketWhereAnotherPutALinkButNotIfTheSocketWasAskedFor) {
  const fs::path victim = folder_.path() / "victim";
  fs::create_directory(victim);
  fs::create_directory_symlink(victim, folder_.path() / "telepalp");
  ::setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1);
  EXPECT_EQ(run({"--connect", "127.0.0.1:9", "--patience", "0.3"}), 1);
  EXPECT_NE(text_of(log()).find("this station has no control socket, so telepalp-station rearm cannot end a fault"),
            std::string::npos);
  EXPECT_NE(text_of(log()).find("does not answer"), std::string::npos) << "it went on";
  const std::string asked = (folder_.path() / "telepalp" / "control").string();
  EXPECT_EQ(run({"--connect", "127.0.0.1:9", "--patience", "0.3", "--control", asked}), 1);
  EXPECT_EQ(text_of(log()).find("does not answer"), std::string::npos) << text_of(log());
  EXPECT_NE(text_of(log()).find("is a symbolic link"), std::string::npos) << text_of(log());
  EXPECT_TRUE(fs::is_empty(victim));
  ::unsetenv("XDG_RUNTIME_DIR");
}

/// A server that speaks the next version of the protocol.
std::uint16_t answer_once_as_version_3(boost::asio::io_context& io, std::jthread& thread) {
  using boost::asio::ip::tcp;
  auto acceptor = std::make_shared<tcp::acceptor>(io, tcp::endpoint(boost::asio::ip::make_address("127.0.0.1"), 0));
  thread = std::jthread([acceptor, &io] {
    tcp::socket peer(io);
    acceptor->accept(peer);
    msg::Control hello;
    hello.mutable_hello()->set_protocol(3);
    const std::string payload = hello.SerializeAsString();
    const wire::HeaderBytes header = wire::encode_header({.payload_bytes = static_cast<std::uint32_t>(payload.size())});
    boost::system::error_code ignored;
    boost::asio::write(peer, boost::asio::buffer(header), ignored);
    boost::asio::write(peer, boost::asio::buffer(payload), ignored);
    std::array<char, 4096> heard{};
    while (!ignored) (void)peer.read_some(boost::asio::buffer(heard), ignored);
  });
  return acceptor->local_endpoint().port();
}

TEST_F(StationProgram, EndsAtOnceAtAServerOfAnotherProtocolVersionAndSoDoesTheRecorder) {
  const std::string out = (folder_.path() / "session.mcap").string();
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"telepalp-station"}, std::vector<std::string>{"telepalp-record", "--out", out}}) {
    boost::asio::io_context io;
    std::jthread server;
    std::vector<std::string> arguments(words.begin() + 1, words.end());
    arguments.insert(arguments.end(),
                     {"--connect", "127.0.0.1:" + std::to_string(answer_once_as_version_3(io, server))});
    ChildProcess program(kPrograms / words.front(), arguments, log());
    EXPECT_EQ(program.wait(10s), 1) << words.front() << text_of(log());
    EXPECT_NE(text_of(log()).find("speaks version 3 of the wire protocol instead of version 1 or 2"), std::string::npos)
        << text_of(log());
    EXPECT_FALSE(fs::exists(out));
  }
}

TEST_F(StationProgram, AnUnknownFieldInASceneIsNamedWithLineAndColumn) {
  const fs::path scene = folder_.path() / "wrong.scene.textproto";
  std::ofstream(scene) << "name: \"wrong\"\npatient_surface { streamed {} }\neffects { skin { stiffness_kN: 2 } }\n";
  EXPECT_EQ(run({"--scene", scene.string(), "--check"}), 1);
  EXPECT_NE(text_of(log()).find("wrong.scene.textproto:3:"), std::string::npos) << text_of(log());
  EXPECT_NE(text_of(log()).find("stiffness_kN"), std::string::npos) << text_of(log());
}

TEST_F(StationProgram, AValueInTheWrongUnitIsRefusedWithItsRange) {
  const fs::path scene = folder_.path() / "wrong.scene.textproto";
  std::string text = text_of(TELEPALP_SOURCE_DIR "/haptic_station/scenes/palpation.scene.textproto");
  const std::string metres = "radius_m: 0.03";
  ASSERT_NE(text.find(metres), std::string::npos);
  std::ofstream(scene) << text.replace(text.find(metres), metres.size(), "radius_m: 30");
  EXPECT_EQ(run({"--scene", scene.string(), "--check"}), 1);
  EXPECT_NE(text_of(log()).find("textproto:32:5: cylinder.radius_m"), std::string::npos) << text_of(log());
}

TEST_F(StationProgram, AWrongCommandLineEndsWithTwo) {
  EXPECT_EQ(run({"--connect", "nowhere:none"}), 2);
  EXPECT_EQ(run({"--realtime", "perhaps"}), 2);
  EXPECT_EQ(run({"--seconds", "-3"}), 2);
}

TEST_F(StationProgram, AWrongOptionOfCalibrateEndsWithTwoAndAMissingFileWithOne) {
  const std::string none = (folder_.path() / "none.csv").string();
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"points"},
                                                {"points", "--pairs", none, "--from", "nose"},
                                                {"offset", "--seconds", "nan"},
                                                {"offset", "--patience", "-1"},
                                                {"offset", "--device", "simulated"},
                                                {"probe"},
                                                {"probe", "--poses", none, "--hand-at", "1,2"}}) {
    std::vector<std::string> words{"calibrate"};
    words.insert(words.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(run(words), 2) << text_of(log());
  }
  EXPECT_EQ(run({"calibrate", "points", "--pairs", none}), 1) << text_of(log());
  EXPECT_EQ(run({"calibrate", "offset", "--pairs", none, "--device", "simulated"}), 1) << text_of(log());
  EXPECT_EQ(run({"calibrate", "probe", "--poses", none}), 1) << text_of(log());
}

TEST_F(StationProgram, AKeyThatCannotBeUsedIsAFailureAndNotAWrongCommandLine) {
  EXPECT_EQ(run({"--key", (folder_.path() / "none.key").string()}), 1);
  EXPECT_NE(text_of(log()).find("none.key: the key cannot be read"), std::string::npos) << text_of(log());
}

TEST_F(StationProgram, CalibratesFromTheShippedPairsAndReadsWhatItKept) {
  const std::string pairs = TELEPALP_SOURCE_DIR "/deploy/demo_data/calibration/pairs.csv";
  const std::string kept = (folder_.path() / "site.calibration.textproto").string();
  EXPECT_EQ(run({"calibrate", "points", "--pairs", pairs, "--from", "camera", "--out", kept}), 0) << text_of(log());
  EXPECT_NE(text_of(kept).find("haptic_from_camera"), std::string::npos);
  EXPECT_NE(text_of(kept).find("residual_mean_m: 0.001"), std::string::npos) << text_of(kept);
  EXPECT_EQ(run({"--calibration", kept, "--check"}), 0) << text_of(log());
  EXPECT_EQ(run({"--calibration", "", "--check"}), 2) << text_of(log());
  std::ofstream(folder_.path() / "empty") << "";
  EXPECT_EQ(run({"--calibration", (folder_.path() / "empty").string(), "--check"}), 1);
  EXPECT_NE(text_of(log()).find("holds no calibration"), std::string::npos) << text_of(log());

  const fs::path flat = folder_.path() / "flat.csv";
  std::ofstream(flat) << "place,to_x_m,to_y_m,to_z_m,from_x_m,from_y_m,from_z_m\n"
                         "0,0,0,0,1,0,0\n1,0.1,0,0,1.1,0,0\n2,0.2,0,0,1.2,0,0\n";
  EXPECT_EQ(run({"calibrate", "points", "--pairs", flat.string(), "--from", "camera", "--out", kept}), 1);
  EXPECT_NE(text_of(log()).find("rank"), std::string::npos) << text_of(log());
}

TEST_F(StationProgram, EveryShippedSceneCanBeChecked) {
  for (const auto& entry : fs::directory_iterator(TELEPALP_SOURCE_DIR "/haptic_station/scenes")) {
    if (!entry.path().string().ends_with(".scene.textproto")) continue;
    EXPECT_EQ(run({"--scene", entry.path().string(), "--check"}), 0) << entry.path() << text_of(log());
  }
}

TEST_F(StationProgram, TouchesAModelWithoutAServer) {
  const std::string scene = TELEPALP_SOURCE_DIR "/haptic_station/scenes/model.scene.textproto";
  EXPECT_EQ(run({"--connect", "127.0.0.1:9", "--scene", scene, "--seconds", "5"}), 0) << text_of(log());
  EXPECT_NE(text_of(log()).find("the hand touches a model of 16000 points"), std::string::npos) << text_of(log());
  EXPECT_NE(text_of(log()).find("effect in a tick with contact: skin"), std::string::npos) << text_of(log());
}

TEST_F(StationProgram, TheSecondStartWithAModelReadsItsSamplingFromTheCache) {
  const std::string scene = TELEPALP_SOURCE_DIR "/haptic_station/scenes/model.scene.textproto";
  EXPECT_EQ(run({"--scene", scene, "--check"}), 0) << text_of(log());
  EXPECT_NE(text_of(log()).find("model: spreading 16000 points over the mesh"), std::string::npos) << text_of(log());
  EXPECT_EQ(run({"--scene", scene, "--check"}), 0) << text_of(log());
  EXPECT_NE(text_of(log()).find("is read from the cache"), std::string::npos) << text_of(log());
  EXPECT_EQ(text_of(log()).find("spreading"), std::string::npos) << text_of(log());
}

TEST_F(StationProgram, AModelInAnotherUnitIsNamedUntilItsUnitIsSaid) {
  const fs::path model = folder_.path() / "mm.obj";
  std::ofstream(model) << "v 0 0 0\nv 300 0 0\nv 0 0 300\nv 300 0 300\nf 1 3 2\nf 2 3 4\n";
  EXPECT_EQ(run({"--surface", "model:" + model.string(), "--check"}), 1);
  EXPECT_NE(text_of(log()).find("unit_m=0.001"), std::string::npos) << text_of(log());
  EXPECT_EQ(run({"--surface", "model:" + model.string() + ",unit_m=0.001,samples=2000", "--check"}), 0);
  EXPECT_EQ(run({"--surface", "model:" + model.string() + ",unit=mm", "--check"}), 2);
}

}  // namespace
}  // namespace telepalp
