#include "haptic_station/station/fault_desk.h"

#include <chrono>
#include <utility>

#include "haptic_station/control/phase.h"
#include "haptic_station/station/black_box.h"
#include "proto/program/log.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;

constexpr auto kRearmTakes = 20ms;  // some ticks, and their telling

void say(const std::string& text) { program::log("telepalp-station", text); }

}  // namespace

FaultDesk::FaultDesk(boost::asio::io_context& io, TelemetryPublisher& telemetry, std::filesystem::path control,
                     std::filesystem::path state_folder, std::string scene, Handlers handlers)
    : telemetry_(telemetry),
      control_(std::move(control)),
      state_folder_(std::move(state_folder)),
      scene_(std::move(scene)),
      handlers_(std::move(handlers)),
      socket_(io,
              [this](const std::string& command, const ControlSocket::Reply& reply) { on_command(command, reply); }),
      rearm_timer_(io) {}

Result<void> FaultDesk::listen() {
  if (control_.empty()) return {};
  return socket_.listen(control_);
}

void FaultDesk::look(bool ending) {
  FaultWatch& faults = telemetry_.faults();
  if (const std::optional<TickSample> fault = faults.begun()) {
    const std::string cause = control::name(static_cast<control::FaultCause>(fault->fault));
    say("fault: " + cause + ": let go, until an operator re-arms. fix: remove the cause, then " + how_to_rearm());
    telemetry_.tell_event(handlers_.now(), msg::EVENT_KIND_FAULT, cause);
  }
  if (auto ticks = faults.due(ending)) {
    black_box_ = std::async(std::launch::async, [folder = state_folder_, ticks = std::move(*ticks), scene = scene_] {
      const auto cause = static_cast<control::FaultCause>(ticks.back().fault);
      return write_black_box(folder, ticks, control::name(cause), scene);
    });
  }
  if (black_box_.valid() && (ending || black_box_.wait_for(0s) == std::future_status::ready)) {
    const Result<std::filesystem::path> written = black_box_.get();
    say(written ? "black box: " + written->string() + ". read it by telepalp-report"
                : "no black box: " + to_string(written.error()));
  }
}

void FaultDesk::stop() {
  stopped_ = true;
  rearm_timer_.cancel();
  socket_.stop();
}

bool FaultDesk::is_faulted() const { return telemetry_.has_ticked() && telemetry_.last().phase == msg::PHASE_FAULTED; }

std::string FaultDesk::how_to_rearm() const {
  return control_.empty() ? "start this station again" : "telepalp-station rearm --control " + control_.string();
}

void FaultDesk::on_command(const std::string& command, const ControlSocket::Reply& reply) {
  if (command == "rearm") return rearm(reply);
  reply("'" + command + "' is not understood. fix: rearm");
}

void FaultDesk::rearm(const ControlSocket::Reply& reply) {
  if (!is_faulted()) return reply("there is no fault to re-arm from");
  handlers_.rearm();
  rearm_timer_.expires_after(kRearmTakes);
  rearm_timer_.async_wait([this, reply](const boost::system::error_code& error) {
    if (error || stopped_) return;
    telemetry_.drain(handlers_.now());
    if (!is_faulted()) {
      say("re-armed by the operator");
      return reply("re-armed: the station touches again");
    }
    const auto stands = static_cast<control::FaultCause>(telemetry_.last().fault_stands);
    reply(std::string("not re-armed: ") + control::name(stands) + ". fix: remove the cause, then try again");
  });
}

}  // namespace telepalp::station
