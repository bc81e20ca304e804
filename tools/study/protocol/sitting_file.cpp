#include "tools/study/protocol/sitting_file.h"

#include <cstdio>
#include <limits>
#include <utility>

#include "haptic_station/loop/tick.h"
#include "messages/playback.pb.h"
#include "proto/wire/topics.h"
#include "proto/words/numbers/utc_text.h"
#include "support/program/files/whole_file.h"
#include "support/program/version.h"

namespace telepalp::study {
namespace {

constexpr std::int64_t kTick_ns = std::chrono::nanoseconds(loop::kTickPeriod).count();
constexpr int kMostSittings = 9999;

std::filesystem::path next_free(const std::filesystem::path& folder, const std::string& participant) {
  for (int number = 1; number < kMostSittings; ++number) {
    std::array<char, 16> digits{};
    std::snprintf(digits.data(), digits.size(), "-%04d.mcap", number);
    std::filesystem::path file = folder / (participant + digits.data());
    std::error_code unknown;
    if (!std::filesystem::exists(file, unknown) && !std::filesystem::exists(file.string() + ".partial", unknown))
      return file;
  }
  return folder / (participant + "-9999.mcap");
}

}  // namespace

Result<SittingFile> SittingFile::open(const std::filesystem::path& out, const std::string& participant,
                                      const std::string& protocol) {
  const std::filesystem::path folder = out / "sessions";
  if (const auto made = program::make_folder(folder, program::Readers::Group); !made) return made.error();
  Result<wire::McapWriter> writer =
      wire::McapWriter::open(next_free(folder, participant), {.program = "telepalp-study protocol",
                                                              .version = program::version(),
                                                              .commit = program::commit(),
                                                              .source = protocol,
                                                              .scene = "",
                                                              .recorded_by = "participant " + participant});
  if (!writer) return writer.error();
  return SittingFile(std::move(*writer));
}

void SittingFile::write(const wire::Message& message) {
  if (failed_) return;
  if (const Result<void> written = writer_.write(message); !written) failed_ = written.error();
}

SessionTime SittingFile::newest() const noexcept { return session_time(next_ns_); }

void SittingFile::begin(const std::string& what, SessionTime now) {
  begun_ = true;
  next_ns_ = std::max(next_ns_, to_nanoseconds(now));
  write(outbox_.event(msg::EVENT_KIND_SCENE, what, newest()));
}

void SittingFile::add(PersonTrial::Ticks& ticks) {
  for (loop::TickSample& tick : ticks) {
    tick.tick = number_++;
    tick.stamp_ns = next_ns_;
    tick.phase = static_cast<std::uint8_t>(tick.in_body ? msg::PHASE_IN_BODY : msg::PHASE_OUT_BODY);
    tick.yields_in_s = std::numeric_limits<float>::infinity();
    next_ns_ += kTick_ns;
  }
  for (std::size_t from = 0; from < ticks.size(); from += core::Outbox::kMostInBatch)
    for (const wire::Message& message : outbox_.ticks(
             std::span(ticks).subspan(from, std::min(core::Outbox::kMostInBatch, ticks.size() - from)), newest()))
      write(message);
}

void SittingFile::end(const std::string& what, const std::string& who) {
  msg::LiveNote note;
  note.set_at_ns(static_cast<std::uint64_t>(next_ns_));
  note.set_text(what);
  note.set_who(who);
  note.set_written(utc_stamp(std::chrono::system_clock::time_point(std::chrono::nanoseconds(next_ns_))));
  write(wire::make_message(wire::kSessionNotes, newest(), note));
  if (const Result<void> flushed = writer_.flush(); !flushed && !failed_) failed_ = flushed.error();
}

Result<void> SittingFile::close() {
  if (!begun_) {
    writer_.discard();
    return {};
  }
  const Result<void> closed = writer_.close();
  if (failed_) return *failed_;
  return closed;
}

}  // namespace telepalp::study
