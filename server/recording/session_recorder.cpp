#include "server/recording/session_recorder.h"

#include <unistd.h>

#include <fstream>
#include <thread>
#include <vector>

#include "proto/words/numbers/utc_text.h"

namespace telepalp::recording {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

Error refused(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "recording", .fix = std::move(fix)};
}

std::string name_at(std::chrono::system_clock::time_point now) { return utc_text(now, "session_%Y%m%d_%H%M%S.mcap"); }

/// Bytes of a session file, complete or not; 0 before its first byte.
std::uint64_t bytes_of(const fs::path& file) {
  std::error_code none;
  for (const fs::path& name : {file, fs::path(file.string() + ".partial")})
    if (const std::uintmax_t bytes = fs::file_size(name, none); !none) return bytes;
  return 0;
}

/// The last line of a program's log, at most 500 bytes: programs end with their error.
std::string last_line(const fs::path& log) {
  std::ifstream stream(log);
  std::string last;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) last = line;
  return last.substr(0, 500);
}

}  // namespace

Result<std::unique_ptr<SessionRecorder>> SessionRecorder::open(Options options) {
  std::error_code none;
  if (!fs::is_directory(options.folder, none) || ::access(options.folder.c_str(), W_OK) != 0)
    return Error{
        .what = options.folder.string() + " is not a folder in which this program may write",
        .where = "--record-dir",
        .fix = "make it (mkdir -p " + options.folder.string() + "), or allow this program's user to write there"};
  return std::unique_ptr<SessionRecorder>(new SessionRecorder(std::move(options)));
}

SessionRecorder::~SessionRecorder() {
  if (!process_) return;
  process_->ask_to_end();
  for (const auto until = std::chrono::steady_clock::now() + 3s;
       !process_->exit_code() && std::chrono::steady_clock::now() < until;)
    std::this_thread::sleep_for(10ms);
  look_at_process();
}

Result<void> SessionRecorder::apply(const msg::RecordingCommand& command, std::chrono::system_clock::time_point now) {
  look_at_process();
  if (command.record()) return begin(command, now);
  if (!process_) return refused("no recording is running", "begin a recording first");
  process_->ask_to_end();
  state_.set_phase(msg::RecordingState::PHASE_COMPLETING);
  return {};
}

Result<void> SessionRecorder::begin(const msg::RecordingCommand& command, std::chrono::system_clock::time_point now) {
  if (process_) return refused("a recording is running: " + state_.file(), "end this recording first");
  msg::RecordingState state;
  state.set_file(name_at(now));
  state.set_phase(msg::RecordingState::PHASE_RECORDING);
  const fs::path file = options_.folder / state.file();
  std::vector<std::string> words{"--connect", options_.server, "--out", file.string(), "--consent", command.consent()};
  if (!command.voice_consent().empty()) words.insert(words.end(), {"--voice-consent", command.voice_consent()});
  if (!options_.key.empty()) words.insert(words.end(), {"--key", options_.key.string()});
  state_ = std::move(state);
  began_ = std::chrono::steady_clock::now();
  Result<RecorderProcess> started = RecorderProcess::start(options_.program, words, log_file());
  if (!started) {
    state_.set_phase(msg::RecordingState::PHASE_IDLE);
    state_.set_problem(to_string(started.error()));
    return started.error();
  }
  process_ = std::move(started).value();
  return {};
}

msg::RecordingState SessionRecorder::state() {
  look_at_process();
  if (process_) {
    state_.set_seconds(std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count());
    state_.set_bytes(bytes_of(options_.folder / state_.file()));
  }
  return state_;
}

void SessionRecorder::look_at_process() {
  if (!process_) return;
  const std::optional<int> code = process_->exit_code();
  if (!code) return;
  process_.reset();
  state_.set_phase(msg::RecordingState::PHASE_IDLE);
  state_.set_bytes(bytes_of(options_.folder / state_.file()));
  std::error_code ignored;
  if (*code == 0) return void(fs::remove(log_file(), ignored));
  const std::string reason = last_line(log_file());
  state_.set_problem("telepalp-record ended with exit code " + std::to_string(*code) +
                     (reason.empty() ? " and gave no reason. fix: begin the recording again, and check that "
                                       "telepalp-record runs on the server's computer: telepalp-record --version"
                                     : ": " + reason));
}

fs::path SessionRecorder::log_file() const { return options_.folder / (state_.file() + ".log"); }

}  // namespace telepalp::recording
