#include "haptic_station/station/signals/station_signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <string>
#include <utility>

#include "haptic_station/station/telemetry/say.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;

bool ignores(int signal) {
  struct sigaction now {};
  return ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

bool has_terminal() {
  const int terminal = ::open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal >= 0) ::close(terminal);
  return terminal >= 0;
}

/// A library's exception, such as one for a lack of memory, must not end a station that has a scene.
Result<LoadedScene> without_exceptions(const StationSignals::ReadScene& read) {
  try {
    return read();
  } catch (const std::exception& error) {
    return Error{.what = std::string("the scene file cannot be read again: ") + error.what(),
                 .where = "the scene",
                 .fix =
                     "check the file by telepalp-station scene check SCENE, then send SIGHUP again; the station keeps "
                     "the scene that it has"};
  }
}

}  // namespace

StationSignals::StationSignals(ReadScene read) : read_(std::move(read)), had_terminal_(has_terminal()) {
  if (!ignores(SIGHUP)) signals_.add(SIGHUP);
  wait();
}

void StationSignals::keep_end() {
  signals_.add(SIGINT);
  signals_.add(SIGTERM);
}

void StationSignals::wait() {
  signals_.async_wait([this](const boost::system::error_code& error, int number) {
    if (error) return;
    on_signal(number);
    wait();
  });
}

/// The kernel sends SIGHUP when the terminal is closed, too. A station must not give force on after its operator has
/// left, so it ends then.
void StationSignals::on_signal(int number) {
  if (number == SIGHUP && (!had_terminal_ || has_terminal()))
    reading_asked_ = true;
  else
    end_asked_ = true;
}

void StationSignals::read_again() {
  reading_asked_ = false;
  say("SIGHUP received: the station reads the scene again");
  reading_ = std::async(std::launch::async, [this] { return without_exceptions(read_); });
}

StationSignals::Asked StationSignals::asked() {
  io_.poll();
  if (end_asked_) return Asked::End;
  if (reading_.valid() && reading_.wait_for(0s) == std::future_status::ready) {
    Result<LoadedScene> read = reading_.get();
    if (!read) say("the station keeps its scene; the new one is refused: " + to_string(read.error()));
    if (read && !reading_asked_) {  // else the file may have changed while it was read
      accepted_ = std::move(read).value();
      return Asked::NewScene;
    }
  }
  if (reading_asked_ && !reading_.valid()) read_again();
  return Asked::Nothing;
}

std::optional<LoadedScene> StationSignals::take_scene() { return std::exchange(accepted_, std::nullopt); }

}  // namespace telepalp::station
