#include "clients/record/live/recording.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <cstdio>
#include <optional>
#include <set>
#include <utility>

#include "clients/record/live/disk_room.h"
#include "clients/record/live/disk_thread.h"
#include "clients/record/live/recording_plan.h"
#include "proto/wire/client/client_link.h"
#include "proto/wire/depth_loss.h"
#include "proto/wire/mcap/writer.h"
#include "proto/words/counted.h"
#include "proto/words/numbers/fixed_text.h"
#include "support/program/ending.h"
#include "support/program/files/ready_file.h"
#include "support/program/log.h"

namespace telepalp::record {
namespace {

using Clock = std::chrono::steady_clock;
using boost::system::error_code;

constexpr const char* kProgram = "telepalp-record";
constexpr const char* kNotFinished =
    "telepalp-record: the disk did not store the remaining messages within 5 s; the newest session file keeps its name "
    "FILE.mcap.partial. fix: telepalp-record repair FILE.mcap.partial";
constexpr auto kProgressEvery = std::chrono::milliseconds(500);

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The file or, for a recording in parts, its first part, in words.
std::string first_file(const RecordingOptions& options) {
  return options.splitting.in_parts() ? part_file(options.file, 1).string() + " and later parts"
                                      : options.file.string();
}

std::uint64_t total(const std::map<std::string_view, std::uint64_t>& by_topic) {
  std::uint64_t sum = 0;
  for (const auto& [topic, count] : by_topic) sum += count;
  return sum;
}

/// Metadata for the file: the gaps of the recording, the accuracy of its depth and of its clock.
wire::mcap::Metadata what_was_found(const RecordingReport& report,
                                    const std::map<std::string_view, std::uint64_t>& dropped,
                                    const std::set<std::string>& depth, Nanoseconds clock_uncertainty) {
  wire::mcap::Metadata metadata{std::string(wire::kRecordingMetadata),
                                {{"gaps", std::to_string(report.gaps)}, {"gap_s", fixed_text(report.gap_s, 3)}}};
  metadata.values["clock_uncertainty_us"] = fixed_text(static_cast<double>(clock_uncertainty.count()) / 1e3, 1);
  if (!depth.empty()) metadata.values["depth"] = boost::algorithm::join(depth, "; ");
  for (const auto& [topic, count] : dropped) metadata.values["dropped" + std::string(topic)] = std::to_string(count);
  return metadata;
}

/// What to subscribe to at the server. What is said is taken only with the patient's consent to that.
std::vector<std::string> subscription(const RecordingOptions& options) {
  std::vector<std::string> names = wire::subscription_for(options.color, options.topics.subscription());
  for (const wire::Topic& topic : wire::kTopics) {
    if (!topic.spoken) continue;
    std::erase(names, topic.name);
    if (!options.voice_consent.empty() && options.topics.matches(topic.name)) names.emplace_back(topic.name);
  }
  return names;
}

/// One recording in progress. Everything runs on the network thread, except for the functions that `disk_` calls.
class Recording {
 public:
  /// `files` calls on_alarm() of this object, on the disk thread.
  Recording(const RecordingOptions& options, std::unique_ptr<SessionFiles>& files)
      : options_(options),
        files_(files),
        room_(options.file),
        disk_({.write =
                   [this](const wire::Message& message) {
                     files_->write(message);
                     return Result<void>{};
                   },
               .flush =
                   [this] {
                     files_->flush();
                     return Result<void>{};
                   }}),
        link_(io_,
              {.host = options.server.host,
               .port = options.server.port,
               .site = options.server.site,
               .name = kProgram,
               .role = "recorder",
               .key = options.key,
               .consent = options.consent,
               .voice_consent = options.voice_consent,
               .subscribes = subscription(options),
               // Without a key the server is on this machine. There TCP is in time and loses no image.
               .datagrams = options.key != nullptr},
              {.on_message = [this](const wire::Message& message) { on_message(message); },
               .on_state = [this](wire::LinkState state, const std::string& detail) { on_state(state, detail); },
               .on_datagrams = [this](wire::DatagramPhase, const std::string& detail) { say(detail); },
               .on_notice = [this](const std::string& text) { say(text); }}) {}

  void on_alarm(const std::string& text) {
    boost::asio::post(io_, [this, text] { say(text); });
  }

  Result<RecordingReport> run() {
    signals_.async_wait([this](const error_code& cancelled, int) {
      if (cancelled) return;
      program::end_within(program::kTimeToEnd, kNotFinished);
      stop("Ctrl-C or another program stopped the recorder");
    });
    deadline_.expires_after(std::chrono::duration_cast<Clock::duration>(options_.patience.value_or(program::kForEver)));
    deadline_.async_wait([this](const error_code& cancelled) {
      if (!cancelled)
        fail({link_.no_answer(), program::to_text(options_.server),
              "start telepalp-server, name another one by --connect, or wait longer by --patience S"});
    });
    watch();
    link_.start();
    io_.run();
    return finish();
  }

 private:
  /// After a dropped message, those predicted from it are useless in the file, so a key frame is requested.
  void on_message(const wire::Message& message) {
    if (!is_asked(message.topic)) return;
    const bool taken = disk_.offer(message);
    if (message.topic.predicted && (!taken || files_->needs_key_frame())) link_.request_key_frame(message);
    if (taken && message.topic.name == wire::kCameraDepth.name) note_depth(message);
  }

  /// A pattern for /camera/color also asks for colour as video, which is another coding of the same images.
  [[nodiscard]] bool is_asked(const wire::Topic& topic) const {
    return options_.topics.matches(topic.name) ||
           (wire::carries_color(topic) && options_.topics.matches(wire::kCameraColor.name));
  }

  void note_depth(const wire::Message& message) {
    constexpr std::size_t kMostKinds = 8;
    msg::DepthImage image;
    if (depth_.size() >= kMostKinds || !image.ParseFromString(*message.payload)) return;
    depth_.insert(wire::in_words(wire::depth_fidelity(image)));
  }

  void on_state(wire::LinkState state, const std::string& detail) {
    if (state == wire::LinkState::Connected) return on_connected();
    if (state == wire::LinkState::Refused) return fail(link_.refusal());
    if (state == wire::LinkState::Lost && !stopping_) {
      away_since_ = Clock::now();
      say("the server does not answer (" + detail + "); the recording continues when it answers again");
    }
  }

  void on_connected() {
    if (away_since_) {
      const double away_s = seconds_since(*std::exchange(away_since_, std::nullopt));
      ++report_.gaps;
      report_.gap_s += away_s;
      say("the server answers again after " + fixed_text(away_s, 1) +
          " s; the recording has no messages from this time");
    }
    if (std::exchange(started_, started_.value_or(Clock::now()))) return;
    say("recording " + program::to_text(options_.server) + " to " + first_file(options_) +
        "; until a file is complete, its name ends in .partial");
    if (const Result<void> written =
            program::write_ready_file(options_.ready_file, "recording=" + options_.file.string() + "\n");
        !written)
      return fail(written.error());
    deadline_.cancel();
    if (options_.seconds.count() <= 0) return;
    deadline_.expires_after(std::chrono::duration_cast<Clock::duration>(options_.seconds));
    deadline_.async_wait([this](const error_code& cancelled) {
      if (!cancelled) stop("the time of --seconds is over");
    });
  }

  /// Checks the disk thread and shows the progress.
  void watch() {
    watch_.expires_after(kProgressEvery);
    watch_.async_wait([this](const error_code& cancelled) {
      if (cancelled || stopping_) return;
      const DiskThread::Counts counts = disk_.counts();
      if (counts.failed) return fail(*counts.failed);
      if (const auto alarm = room_.alarm(counts.stored_bytes)) say(*alarm);
      const std::uint64_t dropped = total(counts.dropped);
      if (dropped > dropped_reported_)
        say("the disk is too slow: " + counted(dropped, "message", "messages") +
            " dropped so far. fix: record fewer topics by --topics, or to a faster disk");
      dropped_reported_ = dropped;
      if (options_.progress && started_) show(counts);
      watch();
    });
  }

  void show(const DiskThread::Counts& counts) {
    std::fprintf(stderr, "\r\x1b[K%s s  %s MB  %s  %llu dropped%s", fixed_text(seconds_since(*started_), 1).c_str(),
                 fixed_text(static_cast<double>(counts.stored_bytes) / 1e6, 1).c_str(),
                 counted(counts.stored, "message", "messages").c_str(),
                 static_cast<unsigned long long>(total(counts.dropped) + files_->dropped()),
                 away_since_ ? "  (no connection)" : "");
    line_shown_ = true;
  }

  void say(const std::string& text) {
    if (std::exchange(line_shown_, false)) std::fputs("\r\x1b[K", stderr);
    program::log(kProgram, text);
  }

  void stop(const std::string& reason) {
    if (std::exchange(stopping_, true)) return;
    say((started_ ? "finishing the file: " : "ending without a file: ") + reason);
    error_code ignored;
    signals_.cancel(ignored);  // not clear(): the handlers stay installed, so a second signal has no further effect
    deadline_.cancel();
    watch_.cancel();
    link_.stop(reason);
  }

  void fail(const Error& error) {
    if (!failed_) failed_ = error;
    stop("the recorder failed: " + error.where + ": " + error.what);
  }

  Result<RecordingReport> finish() {
    program::end_within_when_signalled(program::kTimeToEnd, kNotFinished);
    if (std::exchange(line_shown_, false)) std::fputs("\n", stderr);
    const Result<void> stored = disk_.finish();
    if (!stored && !failed_) failed_ = stored.error();
    started_ ? complete_files() : files_->discard();
    io_.restart();
    io_.poll();  // alarms of the disk thread that are still to be shown
    program::work_is_done();
    if (!failed_) return report_;
    if (started_) say("recorded before the error: " + describe(report_));
    return *failed_;
  }

  void complete_files() {
    const DiskThread::Counts counts = disk_.counts();
    report_.seconds = seconds_since(*started_);
    const Result<void> closed =
        files_->close(what_was_found(report_, counts.dropped, depth_, link_.clock_uncertainty()));
    if (!closed && !failed_) failed_ = closed.error();
    const SessionFiles::Counts written = files_->counts();
    report_.dropped = total(counts.dropped) + files_->dropped();
    report_.messages = written.messages;
    report_.file_bytes = written.bytes;
    report_.files = written.files.size();
    report_.in_parts = options_.splitting.in_parts();
  }

  const RecordingOptions& options_;
  std::unique_ptr<SessionFiles>& files_;  // disk thread, until finish()
  DiskRoom room_;
  DiskThread disk_;
  boost::asio::io_context io_;
  boost::asio::signal_set signals_{io_, SIGINT, SIGTERM};
  boost::asio::steady_timer deadline_{io_};
  boost::asio::steady_timer watch_{io_};
  wire::ClientLink link_;
  RecordingReport report_;
  std::set<std::string>
      depth_;  // accuracy of the recorded depth as text; several texts only if the server changed during the recording
  std::optional<Clock::time_point> started_;
  std::optional<Clock::time_point> away_since_;
  std::optional<Error> failed_;
  std::uint64_t dropped_reported_ = 0;
  bool line_shown_ = false;
  bool stopping_ = false;
};

}  // namespace

std::string describe(const RecordingReport& report) {
  std::string text = fixed_text(report.seconds, 1) + " s from connecting to the server to the end of the recording, " +
                     counted(report.messages, "message", "messages") + ", " +
                     fixed_text(static_cast<double>(report.file_bytes) / 1e6, 1) + " MB";
  if (report.files > 1 || report.in_parts) text += " in " + counted(report.files, "numbered file", "numbered files");
  if (report.dropped > 0)
    text += ", " + counted(report.dropped, "message", "messages") + " dropped because the disk was slow or full";
  if (report.gaps > 0) text += ", no connection to the server for " + fixed_text(report.gap_s, 1) + " s";
  return text;
}

Result<RecordingReport> record(const RecordingOptions& options) {
  Result<SessionFiles::Plan> plan = plan_of(options);
  if (!plan) return plan.error();
  Recording* recorder = nullptr;  // set before the disk thread can raise an alarm
  Result<std::unique_ptr<SessionFiles>> files =
      SessionFiles::open(std::move(*plan), [&recorder](const std::string& text) { recorder->on_alarm(text); });
  if (!files) return files.error();
  Recording recording(options, *files);
  recorder = &recording;
  return recording.run();
}

}  // namespace telepalp::record
