#include "clients/record/edit/merge.h"

#include <functional>
#include <set>
#include <string>
#include <tuple>

#include "clients/record/edit/session_copy.h"
#include "messages/station.pb.h"

namespace telepalp::record {
namespace {

constexpr std::uint32_t kSendersApart = 1000;

/// One of the merged files, at its next message.
class Strand {
 public:
  [[nodiscard]] static Result<Strand> open(const std::filesystem::path& file) {
    Result<wire::McapReader> reader = wire::McapReader::open(file);
    if (!reader) return reader.error();
    Result<wire::SessionInfo> session = reader->session();
    if (!session) return session.error();
    return Strand(file, std::move(*reader), std::move(*session));
  }

  void advance(std::vector<std::string>& damages) {
    for (;;) {
      auto next = reader_.next_stored();
      if (next) return void(next_ = *next);
      if (damages.size() < kMostDamagesTold) damages.push_back(file_.string() + ": " + next.error().what);
    }
  }
  [[nodiscard]] bool holds(std::string_view topic) const {
    for (const auto& [id, stored] : reader_.summary().channels.all())
      if (stored.channel.topic == topic) return true;
    return false;
  }

  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }
  [[nodiscard]] const wire::SessionInfo& session() const noexcept { return session_; }
  [[nodiscard]] wire::McapReader& reader() noexcept { return reader_; }
  [[nodiscard]] const std::optional<wire::mcap::StoredMessage>& next() const noexcept { return next_; }
  void set_senders_apart(std::uint32_t by) noexcept { senders_apart_ = by; }
  [[nodiscard]] std::uint32_t senders_apart() const noexcept { return senders_apart_; }

 private:
  Strand(std::filesystem::path file, wire::McapReader reader, wire::SessionInfo session)
      : file_(std::move(file)), reader_(std::move(reader)), session_(std::move(session)) {}

  std::filesystem::path file_;
  wire::McapReader reader_;
  wire::SessionInfo session_;
  std::optional<wire::mcap::StoredMessage> next_;
  std::uint32_t senders_apart_ = 0;
};

/// The message's payload with `by` added to each number of a sender in it; nullopt: the payload names no sender.
std::optional<std::string> with_senders_apart(const wire::mcap::StoredMessage& message, std::uint32_t by) {
  if (by == 0 || !message.channel->topic) return std::nullopt;
  std::string payload(message.record.data);
  if (message.channel->topic->publisher == wire::Publisher::Station) {
    msg::Sender sender;
    if (!sender.ParseFromString(payload)) return std::nullopt;
    msg::Sender moved;  // in Protobuf the last value of a repeated scalar field on the wire counts
    moved.set_sender(sender.sender() + by);
    return payload + moved.SerializeAsString();
  }
  msg::ServerStats stats;
  if (message.channel->channel.topic != wire::kServerStats.name || !stats.ParseFromString(payload)) return std::nullopt;
  for (msg::ServerStats::PerSubscriber& subscriber : *stats.mutable_subscribers())
    if (subscriber.sender() != 0) subscriber.set_sender(subscriber.sender() + by);
  return stats.SerializeAsString();
}

/// Recognises a message that is in several files, among those of one instant.
class Duplicates {
 public:
  [[nodiscard]] bool is_new(const wire::mcap::StoredMessage& message, std::string_view payload) {
    if (message.record.log_time != instant_) seen_.clear();
    instant_ = message.record.log_time;
    return seen_
        .emplace(message.channel->channel.topic, message.record.sequence, payload.size(),
                 std::hash<std::string_view>{}(payload))
        .second;
  }

 private:
  std::uint64_t instant_ = 0;
  std::set<std::tuple<std::string, std::uint32_t, std::size_t, std::size_t>> seen_;
};

Result<std::vector<Strand>> open_all(const std::vector<std::filesystem::path>& files) {
  std::vector<Strand> strands;
  for (const std::filesystem::path& file : files) {
    Result<Strand> strand = Strand::open(file);
    if (!strand) return strand.error();
    strands.push_back(std::move(*strand));
    Strand& added = strands.back();
    if (added.session().source == strands.front().session().source) continue;
    added.set_senders_apart(kSendersApart * static_cast<std::uint32_t>(strands.size() - 1));
  }
  return strands;
}

/// Camera images of several servers in one session could not be told apart.
Result<void> with_images_of_one_server(const std::vector<Strand>& strands) {
  const Strand* first = nullptr;
  for (const Strand& strand : strands) {
    if (!strand.holds(wire::kCameraDepth.name)) continue;
    if (first == nullptr) first = &strand;
    if (strand.session().source == first->session().source) continue;
    return Error{.what = "this session and " + first->file().string() +
                         " both hold camera images, but not recorded from the same server or file: " +
                         strand.session().source + " and " + first->session().source,
                 .where = strand.file().string(),
                 .fix = "merge a copy of this session without camera images: telepalp-record cut " +
                        strand.file().string() + " --topics '!/camera/*' --out OTHER.mcap"};
  }
  return {};
}

Result<void> copy_all_notes(std::vector<Strand>& strands, wire::McapWriter& writer) {
  wire::mcap::Metadata note{"telepalp.merge", {}};
  NotesCopy notes(writer);
  for (std::size_t number = 0; number < strands.size(); ++number) {
    Strand& strand = strands[number];
    if (const Result<void> copied = notes.add(strand.reader()); !copied) return copied;
    std::string& text = note.values["file_" + std::to_string(number)];
    text = strand.file().filename().string() + " from " + strand.session().source;
    if (strand.senders_apart() > 0)
      text += ", its sender numbers raised by " + std::to_string(strand.senders_apart()) +
              ", so that they differ from those of the other files";
  }
  return writer.add(note);
}

Strand* earliest(std::vector<Strand>& strands) {
  Strand* first = nullptr;
  for (Strand& strand : strands)
    if (strand.next() && (first == nullptr || strand.next()->record.log_time < first->next()->record.log_time))
      first = &strand;
  return first;
}

Result<void> copy_messages(std::vector<Strand>& strands, wire::McapWriter& writer, EditReport& report) {
  Duplicates duplicates;
  for (Strand& strand : strands) strand.advance(report.damages);
  while (Strand* const strand = earliest(strands)) {
    const wire::mcap::StoredMessage& message = *strand->next();
    const std::optional<std::string> moved = with_senders_apart(message, strand->senders_apart());
    wire::mcap::StoredMessage copy = message;
    if (moved) copy.record.data = *moved;
    if (duplicates.is_new(message, copy.record.data)) {
      if (const Result<void> copied = writer.copy(copy); !copied) return copied;
    } else {
      ++report.left_out;
    }
    strand->advance(report.damages);
  }
  return {};
}

}  // namespace

Result<EditReport> merge(const std::vector<std::filesystem::path>& files, const std::filesystem::path& out) {
  Result<std::vector<Strand>> strands = open_all(files);
  if (!strands) return strands.error();
  if (const Result<void> images = with_images_of_one_server(*strands); !images) return images.error();
  Result<wire::McapWriter> writer = wire::McapWriter::open(out, strands->front().session());
  if (!writer) return writer.error();
  EditReport report;
  Result<void> copied = copy_all_notes(*strands, *writer);
  if (copied) copied = copy_messages(*strands, *writer, report);
  copied = writer->finish(copied);
  if (!copied) return copied.error();
  report.messages = writer->messages();
  return report;
}

}  // namespace telepalp::record
