#include "tests/bench/session/session_bench.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <chrono>
#include <filesystem>
#include <random>

#include "codec/depth_stream.h"
#include "foxglove/CameraCalibration.pb.h"
#include "foxglove/CompressedImage.pb.h"
#include "messages/camera.pb.h"
#include "proto/wire/mcap/reader.h"
#include "server/playback/session_player.h"
#include "tests/bench/distribution.h"
#include "tests/bench/session/recording_cost.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr std::uint64_t kFileBytes = 2'000'000'000;
constexpr int kOpenings = 20;
constexpr std::int64_t kStart_ns = 1'700'000'000'000'000'000;
constexpr std::int64_t kFrame_ns = 33'333'333;

/// A noisy plane: its compressed size is that of a Kinect's image.
DepthImage noisy_depth(std::mt19937& random) {
  DepthImage image{.width = 640, .height = 480, .unit_m = 0.001, .samples = {}};
  image.samples.resize(640 * 480);
  for (std::uint16_t& sample : image.samples) sample = static_cast<std::uint16_t>(800 + random() % 5);
  return image;
}

wire::Message color_at(SessionTime at, std::mt19937& random) {
  ::foxglove::CompressedImage color;
  color.mutable_timestamp()->set_seconds(to_nanoseconds(at) / 1'000'000'000);
  color.set_format("jpeg");
  std::string noise(32'000, '\0');
  for (char& letter : noise) letter = static_cast<char>(random() & 0xff);
  color.set_data(std::move(noise));
  return wire::make_message(wire::kCameraColor, at, color);
}

Result<void> write_session(const fs::path& file) {
  std::mt19937 random(15);
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Fast});
  std::vector<std::string> packets;  // a few, repeated: the file's size matters, not its content
  for (int number = 0; number < 8; ++number) packets.push_back(encoder.encode(noisy_depth(random)).bytes);
  Result<wire::McapWriter> writer = wire::McapWriter::open(
      file, {.program = "telepalp-bench", .version = "", .commit = "", .source = "noise", .scene = ""});
  if (!writer) return writer.error();
  for (std::int64_t frame = 0; writer->bytes() < kFileBytes; ++frame) {
    const SessionTime at = session_time(kStart_ns + frame * kFrame_ns);
    msg::DepthImage depth;
    depth.set_captured_ns(static_cast<std::uint64_t>(to_nanoseconds(at)));
    depth.set_data(packets[static_cast<std::size_t>(frame) % packets.size()]);
    Result<void> written = writer->write(wire::make_message(wire::kCameraDepth, at, depth, true));
    if (written) written = writer->write(color_at(at, random));
    if (written && frame % 30 == 0)
      written = writer->write(wire::make_message(wire::kCameraInfo, at, ::foxglove::CameraCalibration()));
    if (!written) return written;
  }
  return writer->close();
}

/// Removes the file from the system's cache, so that the next reading comes from the disk.
void make_cold(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return;
  (void)::fdatasync(descriptor);
  (void)::posix_fadvise(descriptor, 0, 0, POSIX_FADV_DONTNEED);
  ::close(descriptor);
}

/// Milliseconds from opening the file to the first depth image at `from_s`; negative if none came within 10 s.
double first_image_ms(const fs::path& file, double from_s) {
  boost::asio::io_context io;
  const auto stays = boost::asio::make_work_guard(io);
  bool shown = false;
  const auto began = std::chrono::steady_clock::now();
  auto player = playback::SessionPlayer::open({.file = file.string(), .from_s = from_s}, false,
                                              wire::SessionClock::anchored_to_wall_clock());
  if (!player) return -1.0;
  (*player)->start(
      io, {.on_message =
               [&](const wire::Message& message) { shown = shown || message.topic.name == wire::kCameraDepth.name; },
           .on_end = [] {}});
  while (!shown && std::chrono::steady_clock::now() - began < 10s) io.run_one_for(10ms);
  const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count();
  (*player)->stop();
  io.poll();
  return shown ? ms : -1.0;
}

struct Opening {
  double ms;
  double peak_MB;
};

/// Opens the file in a process of its own, whose peak memory is that of the opening.
Opening open_in_child(const fs::path& file, double from_s) {
  int ends[2] = {-1, -1};
  Opening opening{-1.0, -1.0};
  if (::pipe(ends) != 0) return opening;
  const pid_t child = ::fork();
  if (child == 0) {
    opening.ms = first_image_ms(file, from_s);
    rusage used{};
    ::getrusage(RUSAGE_SELF, &used);
    opening.peak_MB = static_cast<double>(used.ru_maxrss) / 1024.0;
    const bool written = ::write(ends[1], &opening, sizeof opening) == static_cast<ssize_t>(sizeof opening);
    ::_exit(written ? 0 : 1);
  }
  ::close(ends[1]);
  if (::read(ends[0], &opening, sizeof opening) != static_cast<ssize_t>(sizeof opening)) opening = {-1.0, -1.0};
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return opening;
}

}  // namespace

Result<Report> run_session(const program::Arguments& arguments) {
  const Result<double> seconds = arguments.number("seconds", 1.0, 600.0);
  if (!seconds) return seconds.error();
  const support::TemporaryFolder folder;
  const fs::path file = folder.path() / "session.mcap";
  if (const Result<void> written = write_session(file); !written) return written.error();
  const auto whole = wire::McapReader::open(file);
  if (!whole) return whole.error();
  const wire::mcap::Statistics& statistics = whole->summary().statistics;
  const double middle_s = static_cast<double>(statistics.message_end_time - statistics.message_start_time) * 1e-9 / 2.0;
  Distribution warm_ms, cold_ms, peak_MB;
  for (int number = 0; number < kOpenings; ++number) {
    make_cold(file);
    const Opening cold = open_in_child(file, middle_s + number);
    const Opening warm = open_in_child(file, middle_s + number);
    if (cold.ms < 0.0 || warm.ms < 0.0)
      return Error{.what = "no image came from the session within 10 s",
                   .where = file.string(),
                   .fix = "free the disk and the processor, then run the benchmark again"};
    cold_ms.add(cold.ms);
    warm_ms.add(warm.ms);
    peak_MB.add(std::max(cold.peak_MB, warm.peak_MB));
  }
  const Result<RecordingCost> cost = recording_cost(folder.path(), *seconds);
  if (!cost) return cost.error();
  return Report{
      .bench = "session",
      .rows = {measured("size of the session file", static_cast<double>(fs::file_size(file)) / 1e9, "GB"),
               at_most("time to open, seek to the middle and get an image, cold, max", cold_ms.max(), "ms", 100.0),
               measured("time to open, seek to the middle and get an image, cold, p50", cold_ms.p50(), "ms"),
               at_most("time to open, seek to the middle and get an image, cached, max", warm_ms.max(), "ms", 100.0),
               at_most("memory of the reading process, max", peak_MB.max(), "MB", 100.0),
               at_most("recorder of 30 frames/s: share of one core", cost->recorder_share, "", 0.05),
               at_most("server, additional work for a recorder: share of one core", cost->server_share, "", 0.05),
               measured("computing time of a tick without a recorder, p99.9", cost->alone_us, "us"),
               at_most("computing time of a tick, p99.9: with a recorder, divided by without",
                       cost->recorded_us / cost->alone_us, "", 1.1)},
      .notes = {std::to_string(kOpenings) + " openings of the session, each in a process of its own",
                "cold: the file was removed from the system's cache before each opening",
                "ticks: medians of " + std::to_string(kRecordingTurns) +
                    " turns with a recorder and as many without, one after the other"}};
}

}  // namespace telepalp::bench
