#include "haptic_station/station/faults/fault_monitor.h"

#include <chrono>
#include <utility>

#include "haptic_station/control/phases/phase.h"
#include "haptic_station/station/faults/flight_recorder.h"
#include "haptic_station/station/telemetry/say.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;

constexpr auto kRearmTakes = 20ms;  // time for some ticks and for their telemetry

}  // namespace

FaultMonitor::FaultMonitor(boost::asio::io_context& io, TelemetryPublisher& telemetry, std::filesystem::path control,
                           std::filesystem::path state_folder, std::string scene, Handlers handlers)
    : telemetry_(telemetry),
      control_(std::move(control)),
      state_folder_(std::move(state_folder)),
      scene_(std::move(scene)),
      handlers_(std::move(handlers)),
      socket_(io,
              [this](const std::string& command, const ControlSocket::Reply& reply) { on_command(command, reply); }),
      rearm_timer_(io) {}

Result<void> FaultMonitor::listen() {
  if (control_.empty()) return {};
  Result<void> listening = socket_.listen(control_);
  if (!listening) control_.clear();
  return listening;
}

void FaultMonitor::add(const loop::TickSample& sample) noexcept {
  watch_.add(sample);
  last_ = sample;
  has_ticked_ = true;
}

void FaultMonitor::look(bool ending) {
  if (const std::optional<loop::TickSample> fault = watch_.begun()) {
    const std::string cause = control::name(static_cast<control::FaultCause>(fault->fault));
    say("fault: " + cause + "; the station gives no force until an operator re-arms it. fix: remove the cause, then " +
        how_to_rearm());
    telemetry_.publish(core::Outbox::fault(*fault, handlers_.now()));
  }
  say_when_written(ending);
  if (flight_recorder_.valid()) return;  // the disk is slow: the next call of look() starts the next file
  if (auto ticks = watch_.due(ending))
    flight_recorder_ =
        std::async(std::launch::async, [folder = state_folder_, ticks = std::move(*ticks), scene = scene_] {
          return write_flight_record(folder, ticks, scene);
        });
  if (ending) say_when_written(true);
}

void FaultMonitor::say_when_written(bool wait) {
  if (!flight_recorder_.valid() || (!wait && flight_recorder_.wait_for(0s) != std::future_status::ready)) return;
  const Result<std::filesystem::path> written = flight_recorder_.get();
  say(written ? "flight recorder: " + written->string() +
                    " holds the last seconds before the fault; show them by telepalp-report"
              : "the last seconds before the fault could not be written: " + to_string(written.error()));
}

void FaultMonitor::stop() {
  stopped_ = true;
  rearm_timer_.cancel();
  socket_.stop();
}

bool FaultMonitor::is_faulted() const { return has_ticked_ && last_.phase == msg::PHASE_FAULTED; }

std::string FaultMonitor::how_to_rearm() const {
  return control_.empty() ? "end and start this station, because it has no control socket"
                          : "run telepalp-station rearm --control " + control_.string();
}

void FaultMonitor::on_command(const std::string& command, const ControlSocket::Reply& reply) {
  if (command == "rearm") return rearm(reply);
  if (handlers_.other_command && handlers_.other_command(command, reply)) return;
  reply("'" + command + "' is not a command. fix: send rearm, offer NAME, withdraw or accept");
}

void FaultMonitor::rearm_for(const std::string& who) {
  if (is_faulted()) rearm([who](const std::string& outcome) { say(who + " asks to re-arm: " + outcome); });
}

void FaultMonitor::rearm(const ControlSocket::Reply& reply) {
  if (!is_faulted()) return reply("there is no fault to re-arm from. fix: none is needed");
  handlers_.rearm();
  rearm_timer_.expires_after(kRearmTakes);
  rearm_timer_.async_wait([this, reply](const boost::system::error_code& error) {
    if (error || stopped_) return;
    telemetry_.drain(handlers_.now());
    if (!is_faulted()) {
      say("the station is re-armed by the operator, and gives force again");
      return reply("re-armed: the station gives force again");
    }
    const auto stands = static_cast<control::FaultCause>(last_.fault_stands);
    if (stands == control::FaultCause::None)
      return reply(
          "not re-armed: the fault is not over yet, although its cause is gone at this moment. fix: try again");
    reply(std::string("not re-armed: ") + control::name(stands) + ". fix: remove the cause, then try again");
  });
}

}  // namespace telepalp::station
