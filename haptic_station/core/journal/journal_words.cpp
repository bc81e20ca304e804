#include "haptic_station/core/journal/journal_words.h"

#include "proto/wire/vector_message.h"

namespace telepalp::core {
namespace {

Eigen::Vector3d vector_at(const google::protobuf::RepeatedField<double>& values, int at) {
  return {values[at], values[at + 1], values[at + 2]};
}

}  // namespace

msg::JournalTick message_of(const JournalTick& tick) {
  msg::JournalTick message;
  message.set_tick(tick.tick);
  message.set_now_ns(tick.now_ns);
  message.set_dt_s(tick.dt_s);
  message.mutable_device()->Add(tick.device_m.begin(), tick.device_m.end());
  message.mutable_device()->Add(tick.device_m_per_s.begin(), tick.device_m_per_s.end());
  message.add_device(tick.device_age_s);
  if (tick.has_tool_attitude) {
    message.mutable_tool()->Add(tick.tool_attitude.begin(), tick.tool_attitude.end());
    message.mutable_tool()->Add(tick.tool_rad_per_s.begin(), tick.tool_rad_per_s.end());
  }
  message.add_power(tick.most_N);
  message.add_power(tick.most_N_m);
  if (tick.has_hand) {
    message.set_hand_at_ns(tick.hand_at_ns);
    message.mutable_hand()->Add(tick.hand_m.begin(), tick.hand_m.end());
    if (tick.has_attitude) message.mutable_attitude()->Add(tick.attitude.begin(), tick.attitude.end());
    if (tick.has_wait) message.set_wait_at_m(tick.wait_at_m);
  }
  if (tick.has_loop) message.set_loop_s(tick.loop_s);
  message.set_surface(tick.surface);
  message.set_rearm(tick.rearm);
  message.mutable_force()->Add(tick.force_N.begin(), tick.force_N.end());
  message.set_phase(tick.phase);
  message.mutable_proxy()->Add(tick.proxy_m.begin(), tick.proxy_m.end());
  message.mutable_torque()->Add(tick.torque_N_m.begin(), tick.torque_N_m.end());
  return message;
}

std::optional<loop::TickIn> tick_in(const msg::JournalTick& tick) {
  const bool has_hand = !tick.hand().empty();
  const bool has_attitude = !tick.attitude().empty();
  const bool has_tool_attitude = !tick.tool().empty();
  if (tick.device_size() != 7 || tick.force_size() != 3 || tick.proxy_size() != 3 || tick.torque_size() != 3 ||
      tick.power_size() != 2 || (has_hand && tick.hand_size() != 3) || (has_attitude && tick.attitude_size() != 4) ||
      (has_tool_attitude && tick.tool_size() != 7))
    return std::nullopt;
  loop::TickIn in{.now = session_time(tick.now_ns()),
                  .dt_s = tick.dt_s(),
                  .reading = {.at = {vector_at(tick.device(), 0)},
                              .velocity = {vector_at(tick.device(), 3)},
                              .age_s = tick.device(6),
                              .power = {.most_N = tick.power(0), .most_N_m = tick.power(1)}},
                  .rearm = tick.rearm()};
  if (has_tool_attitude) {
    in.reading.attitude.emplace(tick.tool().data());
    in.reading.turning = {vector_at(tick.tool(), 4)};
  }
  if (tick.has_loop_s()) in.reading.loop_s = tick.loop_s();
  if (!has_hand) return in;
  ports::HandSample hand{.at = session_time(tick.hand_at_ns()), .hand = {vector_at(tick.hand(), 0)}};
  if (has_attitude) hand.attitude.emplace(tick.attitude().data());
  if (tick.has_wait_at_m()) hand.wait_at_m = tick.wait_at_m();
  in.hand = hand;
  return in;
}

msg::JournalSurfaceRun message_of(const SurfaceStage::Job& job, const StepTimes& times,
                                  const SurfaceStage::Result& result) {
  msg::JournalSurfaceRun run;
  for (const ArrivedDepth& message : job.messages) {
    msg::JournalSurfaceRun::Read& read = *run.add_read();
    read.set_depth(*message.depth.payload);
    read.set_received_ns(to_nanoseconds(message.received));
    read.set_key_frame(message.depth.key_frame);
    msg::CameraFile::Pinhole& camera = *read.mutable_camera();
    camera.set_width(static_cast<std::uint32_t>(message.camera.width));
    camera.set_height(static_cast<std::uint32_t>(message.camera.height));
    camera.set_fx(message.camera.fx);
    camera.set_fy(message.camera.fy);
    camera.set_cx(message.camera.cx);
    camera.set_cy(message.camera.cy);
  }
  if (job.device) wire::set_vector(*run.mutable_device(), job.device->m);
  run.set_accept_object(job.accept_object);
  run.set_begun_ns(to_nanoseconds(job.begun));
  run.set_decoded_ns(to_nanoseconds(times.of(StageStep::Decoded)));
  run.set_placed_ns(to_nanoseconds(times.of(StageStep::Placed)));
  run.set_done_ns(to_nanoseconds(times.of(StageStep::Done)));
  if (!result.surface) return run;
  run.set_setting(result.report.setting());
  run.set_surface(result.surface->number);
  return run;
}

SurfaceStage::Job job_of(const msg::JournalSurfaceRun& run) {
  SurfaceStage::Job job{
      .messages = {}, .device = {}, .begun = session_time(run.begun_ns()), .accept_object = run.accept_object()};
  for (const msg::JournalSurfaceRun::Read& read : run.read()) {
    const msg::CameraFile::Pinhole& camera = read.camera();
    job.messages.push_back({.depth = {.topic = wire::kCameraDepth,
                                      .published = {},
                                      .payload = std::make_shared<const std::string>(read.depth()),
                                      .key_frame = read.key_frame()},
                            .camera = {.width = static_cast<int>(camera.width()),
                                       .height = static_cast<int>(camera.height()),
                                       .fx = camera.fx(),
                                       .fy = camera.fy(),
                                       .cx = camera.cx(),
                                       .cy = camera.cy()},
                            .received = session_time(read.received_ns())});
  }
  if (run.has_device()) job.device = Point<HapticBase>{wire::vector_of(run.device())};
  return job;
}

StepTimes times_of(const msg::JournalSurfaceRun& run) {
  StepTimes times;
  times.keep(StageStep::Decoded, session_time(run.decoded_ns()));
  times.keep(StageStep::Placed, session_time(run.placed_ns()));
  times.keep(StageStep::Done, session_time(run.done_ns()));
  return times;
}

msg::JournalCollisionRun message_of(const CollisionStage::Job& job, const CollisionStage::Result& result) {
  msg::JournalCollisionRun run;
  run.set_begun_ns(to_nanoseconds(job.begun));
  run.set_done_ns(to_nanoseconds(result.done));
  run.set_newer(job.newer ? job.newer->number : 0);
  wire::set_vector(*run.mutable_device(), job.device.m);
  run.set_plane(result.plane ? result.plane->number : 0);
  return run;
}

}  // namespace telepalp::core
