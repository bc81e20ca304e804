#include "clients/record/live/session_files.h"

#include <algorithm>
#include <cstdio>
#include <system_error>
#include <utility>

#include "proto/words/counted.h"
#include "support/speech/session_speech.h"

namespace telepalp::record {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kTryAgainAfter = 1s;
constexpr std::uintmax_t kRoomToBegin = std::uintmax_t{256} << 20;
/// A new part waits at most this long for a key frame to begin with.
constexpr Nanoseconds kLongestWaitForKeyFrame = 2s;
constexpr wire::mcap::ChunkLimits kChunks{.bytes = std::size_t{1} << 20, .span_ns = 500'000'000};

/// `latched`, which is still valid, as a message of `now` if it is older than 5 s. With its own time, a file that
/// begins with it would seem to begin when it was published. Camera models come each second and keep their time, so
/// that a merge of parts finds them equal.
wire::Message as_of(SessionTime now, wire::Message latched) {
  if (now - latched.published > Nanoseconds(5s)) latched.published = now;
  return latched;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

std::string not_recorded(std::uint64_t messages) {
  return counted(messages, "message was", "messages were") + " not recorded";
}

}  // namespace

Result<std::unique_ptr<SessionFiles>> SessionFiles::open(Plan plan, Alarm alarm) {
  std::unique_ptr<SessionFiles> files(new SessionFiles(std::move(plan), std::move(alarm)));
  if (const Result<void> begun = files->begin_part(); !begun) return begun.error();
  return files;
}

std::filesystem::path part_file(const std::filesystem::path& name, int number) {
  char text[16];
  std::snprintf(text, sizeof text, ".%04d", number);
  std::filesystem::path file = name;
  return file.replace_extension(text + name.extension().string());
}

/// One file has the asked name. Parts are numbered.
std::filesystem::path SessionFiles::next_name() {
  ++part_number_;
  return part_number_ == 1 && !plan_.splitting.in_parts() ? plan_.name : part_file(plan_.name, part_number_);
}

Result<void> SessionFiles::begin_part() {
  Result<wire::McapWriter> writer = wire::McapWriter::open(next_name(), plan_.session, kChunks);
  if (!writer) return writer.error();
  Result<void> written;
  for (const wire::mcap::Attachment& attachment : plan_.attachments)
    if (written) written = writer->add(attachment);
  for (const auto& [topic, message] : latched_)
    if (written) written = writer->write(as_of(newest_, message));
  if (!written) {
    writer->discard();
    return written;
  }
  writer_.emplace(std::move(*writer));
  speech_ = {};
  offered_to_part_ = latched_.size();
  part_began_.reset();
  return {};
}

Result<void> SessionFiles::end_part(const wire::mcap::Metadata* notes) {
  Result<void> done;
  if (const auto speech = speech::speech_record(speech_.speech())) done = writer_->add(*speech);
  if (notes != nullptr && done) done = writer_->add(*notes);
  const Result<void> closed = writer_->close();
  dropped_ += offered_to_part_ - std::min(offered_to_part_, writer_->messages());
  parts_.push_back({writer_->name(), writer_->messages(), writer_->bytes(), newest_});
  writer_.reset();
  return done ? closed : done;
}

/// True if the publication time of `message` is near the present time. This is not certain for the first message of a
/// latched topic: the server sends it to each new subscriber, even if it is an hour old.
bool SessionFiles::tells_now(const wire::Message& message) const {
  return !message.topic.latched() ||
         std::ranges::any_of(*held_back_, [&](const auto& one) { return one.topic.name == message.topic.name; });
}

void SessionFiles::write(const wire::Message& published) {
  if (held_back_ && !tells_now(published)) return held_back_->push_back(published);
  if (held_back_) {
    newest_ = published.published;
    put_held_back();
  }
  put(published);
}

void SessionFiles::put_held_back() {
  if (!held_back_) return;
  const std::vector<wire::Message> messages = std::move(*held_back_);
  held_back_.reset();
  for (const wire::Message& message : messages) put(message);
}

void SessionFiles::put(const wire::Message& published) {
  const wire::Message message = published.topic.latched() ? as_of(newest_, published) : published;
  newest_ = std::max(newest_, message.published);
  has_groups_ = has_groups_ || message.topic.predicted;
  if (!message.key_frame && predicted_topic_.empty()) predicted_topic_ = message.topic.name;
  if (!writer_ || is_full(message)) go_on_in_new_part(message);
  if (writer_) {
    if (!part_began_) part_began_ = message.published;
    ++offered_to_part_;
    speech_.add(message);
    if (const Result<void> written = writer_->write(message); !written) fail(written.error());
  } else {
    ++dropped_;
  }
  if (message.topic.latched()) latched_.insert_or_assign(message.topic.name, message);
}

bool SessionFiles::is_full(const wire::Message& message) const {
  if (!part_began_) return false;
  const Splitting& splitting = plan_.splitting;
  const Nanoseconds length = message.published - *part_began_;
  // Ten parts hold what shall be kept, so that at most a tenth more is stored.
  if (splitting.keep_last && length >= std::max<Nanoseconds>(*splitting.keep_last / 10, 1s)) return true;
  if (splitting.time && length >= *splitting.time) return true;
  return splitting.bytes && writer_->bytes() >= *splitting.bytes;
}

void SessionFiles::go_on_in_new_part(const wire::Message& message) {
  if (!writer_ && !may_try_again()) return;
  if (!waiting_since_) waiting_since_ = message.published;
  const bool may_begin = predicted_topic_.empty() || message.topic.name == predicted_topic_;
  const bool begins = !has_groups_ || (message.topic.predicted && message.key_frame && may_begin);
  const bool waits = !begins && message.published - *waiting_since_ < kLongestWaitForKeyFrame;
  needs_key_frame_ = waits && !writer_;  // a part that is still written needs the images until the key frame
  if (waits) return;
  waiting_since_.reset();
  if (writer_)
    if (const Result<void> ended = end_part(nullptr); !ended) return fail(ended.error());
  remove_old_parts(message.published);
  if (const Result<void> begun = begin_part(); !begun) return fail(begun.error());
  if (std::exchange(is_failing_, false))
    alarm_("the recording goes on in " + writer_->name().string() + "; " + not_recorded(dropped_));
}

void SessionFiles::remove_old_parts(SessionTime now) {
  std::error_code ignored;
  while (plan_.splitting.keep_last && !parts_.empty() && now - parts_.front().end > *plan_.splitting.keep_last) {
    std::filesystem::remove(parts_.front().file, ignored);
    parts_.pop_front();
  }
}

void SessionFiles::flush() {
  if (!writer_) return;
  if (const Result<void> flushed = writer_->flush(); !flushed) fail(flushed.error());
}

/// Completes the part with the messages that it has. The recorder keeps reading, so that the server's queue to it does
/// not fill, and tries again later.
void SessionFiles::fail(const Error& error) {
  failed_at_ = Clock::now();
  if (!failed_) failed_ = error;
  if (!std::exchange(is_failing_, true)) alarm_("ALARM: " + to_string(error));
  if (!writer_) return;
  const std::filesystem::path name = writer_->name();
  (void)end_part(nullptr);  // its error is the one above, or there was no room for the index
  std::error_code ignored;
  if (!std::filesystem::exists(name, ignored))
    alarm_("ALARM: " + name.string() + ".partial is not complete. fix: telepalp-record repair " + name.string() +
           ".partial");
}

bool SessionFiles::may_try_again() const {
  if (Clock::now() - failed_at_ < kTryAgainAfter) return false;
  std::error_code unknown;
  const auto room = std::filesystem::space(folder_of(plan_.name), unknown);
  return unknown || room.available >= kRoomToBegin;
}

Result<void> SessionFiles::close(const wire::mcap::Metadata& notes) {
  put_held_back();
  if (writer_)
    if (const Result<void> ended = end_part(&notes); !ended && !failed_) failed_ = ended.error();
  remove_old_parts(newest_);
  if (!failed_) return {};
  Error error = *failed_;
  if (dropped_ > 0) error.what += "; " + not_recorded(dropped_);
  return error;
}

void SessionFiles::discard() {
  if (writer_) writer_->discard();
  writer_.reset();
}

SessionFiles::Counts SessionFiles::counts() const {
  Counts counts{.messages = writer_ ? writer_->messages() : 0, .bytes = 0, .files = {}};
  for (const Part& part : parts_) {
    counts.messages += part.messages;
    counts.bytes += part.bytes;
    counts.files.push_back(part.file);
  }
  return counts;
}

}  // namespace telepalp::record
