#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>

#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/reading/stream_reader.h"
#include "tests/bench/users/sections.h"
#include "tests/bench/users/session_damage.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr unsigned kDamages = 500;
constexpr unsigned kUnfinished = 100;

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const fs::path& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

/// Runs telepalp-record as a user does.
class Recorder {
 public:
  explicit Recorder(const UsersPlace& place)
      : program_(place.programs / "telepalp-record"), said_(place.scratch / "said") {}

  struct Answer {
    int exit_code = -1;
    std::string said;  // stdout and stderr
    [[nodiscard]] bool says(std::string_view words) const { return said.find(words) != std::string::npos; }
  };
  [[nodiscard]] Answer run(const std::string& words) const {
    const int status = std::system((quoted(program_) + " " + words + " > " + quoted(said_) + " 2>&1").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(said_)};
  }

 private:
  fs::path program_;
  fs::path said_;
};

Error not_recorded(const std::string& what) {
  return {.what = "no session was recorded: " + what,
          .where = "telepalp-bench users --part records",
          .fix = "build all programs: ninja telepalp_programs"};
}

/// A session of server, station and recorder, with two attachments.
Result<std::string> recorded_session(const UsersPlace& place, const Recorder& recorder) {
  const fs::path scene = place.sources / "haptic_station/scenes/ribs-ultrasound.scene.textproto";
  const fs::path ready = place.scratch / "ready", probe = place.scratch / "probe.mcap",
                 file = place.scratch / "session.mcap";
  support::ChildProcess server(place.programs / "telepalp-server",
                               {"--source", "synthetic", "--port", "0", "--ready-file", ready},
                               place.scratch / "server.log");
  const std::optional<std::string> port = support::await_ready(ready, "port");
  if (!port) return not_recorded("the server did not start");
  const std::string address = "127.0.0.1:" + *port;
  support::ChildProcess station(place.programs / "telepalp-station", {"--connect", address, "--scene", scene},
                                place.scratch / "station.log");
  for (int second = 0; second < 60; ++second) {
    (void)recorder.run("--connect " + address + " --topics /station/state --seconds 1 --out " + quoted(probe));
    const Result<wire::McapReader> heard = wire::McapReader::open(probe);
    if (heard && heard->summary().statistics.message_count > 0) break;
    fs::remove(probe);
  }
  if (!fs::exists(probe)) return not_recorded("the station published nothing within 60 s");
  const Recorder::Answer answer =
      recorder.run("--connect " + address + " --seconds 2 --consent bench --scene " + quoted(scene) + " --attach " +
                   quoted(place.sources / "README.md") + " --out " + quoted(file));
  if (answer.exit_code != 0) return not_recorded(answer.said);
  return bytes_of(file);
}

/// What a session holds that a user may not lose: a number for each message, in the order of writing, and for each
/// attachment and each note.
struct Content {
  std::vector<std::size_t> messages;
  std::vector<std::size_t> other;  // sorted
};

std::size_t number_of(std::initializer_list<std::string_view> texts) {
  std::size_t number = 0;
  for (const std::string_view text : texts) number = number * 31 + std::hash<std::string_view>{}(text);
  return number;
}

std::size_t number_of(const wire::mcap::StoredMessage& message) {
  const wire::mcap::MessageRecord& record = message.record;
  const std::string_view type =
      message.channel->schema == nullptr ? "" : std::string_view(message.channel->schema->data);
  const std::string times = std::to_string(record.log_time) + "/" + std::to_string(record.sequence);
  return number_of({message.channel->channel.topic, type, times, record.data});
}

Result<Content> content_of(const fs::path& file) {
  Result<wire::McapStreamReader> stream = wire::McapStreamReader::open(file);
  if (!stream) return stream.error();
  Content content;
  for (;;) {
    const auto next = stream->next();
    if (!next) return next.error();
    if (!*next) break;
    content.messages.push_back(number_of(**next));
  }
  for (const wire::mcap::RecordHead& head : stream->attachments())
    if (const auto attachment = stream->read(head))
      content.other.push_back(number_of({attachment->name, attachment->media_type, attachment->data}));
  for (const wire::mcap::Metadata& note : stream->metadata())
    for (const auto& [key, value] : note.values)
      if (note.name != "telepalp.repair") content.other.push_back(number_of({note.name, key, value}));
  std::ranges::sort(content.other);
  return content;
}

/// Numbers of `from` that are not in `in`, both as multisets.
std::size_t missing(std::vector<std::size_t> from, std::vector<std::size_t> in) {
  std::ranges::sort(from);
  std::ranges::sort(in);
  std::vector<std::size_t> left;
  std::ranges::set_difference(from, in, std::back_inserter(left));
  return left.size();
}

struct Judged {
  int called_whole = 0;       // by verify
  int silent_repairs = 0;     // lose something and do not say so
  int damaged_copies = 0;     // repaired copies that verify calls damaged
  std::size_t changed = 0;    // messages in repaired copies that were never recorded, without a word of it
  std::size_t recovered = 0;  // messages
};

void show(const char* verdict, const Damage& damage, const Recorder::Answer& answer) {
  std::fprintf(stderr, "telepalp-bench users: records: %s: %s: %s", verdict, damage.what.c_str(), answer.said.c_str());
}

bool says_what_changed(const Recorder::Answer& repaired) { return repaired.says("the definition of the topic"); }

/// Damages the finished `session` in one way, and judges what verify and repair say.
Result<void> judge_finished(const Recorder& recorder, const UsersPlace& place, const Damage& damage,
                            const Content& whole, Judged& judged) {
  const fs::path file = place.scratch / "damaged.mcap", copy = place.scratch / "copy.mcap";
  write(file, damage.bytes);
  fs::remove(copy);
  const Recorder::Answer verified = recorder.run("verify " + quoted(file));
  if (verified.exit_code != 1) show("called whole", damage, verified);
  if (verified.exit_code != 1) ++judged.called_whole;
  const Recorder::Answer repaired = recorder.run("repair " + quoted(file) + " --out " + quoted(copy));
  if (repaired.exit_code == 1) return {};  // nothing can be recovered, and it says so
  if (!fs::exists(copy)) {
    show("a repair calls it whole", damage, repaired);
    ++judged.silent_repairs;
    return {};
  }
  const Result<Content> kept = content_of(copy);
  if (!kept) return kept.error();
  const bool loses_messages = missing(whole.messages, kept->messages) > 0;
  const bool says_so = repaired.says("lost") || repaired.says("the end of the file is missing");
  const bool loses_other = missing(whole.other, kept->other) > 0;
  const bool silent = (loses_messages && !says_so) || (loses_other && !repaired.says("damage:") && !says_so);
  if (silent) show("a repair is silent", damage, repaired);
  judged.silent_repairs += silent ? 1 : 0;
  judged.changed += says_what_changed(repaired) ? 0 : missing(kept->messages, whole.messages);
  judged.recovered += kept->messages.size();
  if (recorder.run("verify " + quoted(copy)).exit_code != 0) ++judged.damaged_copies;
  return {};
}

/// The same for a recording that was cut off, with damage in it: `repair` completes it. Where messages before its last
/// ones are missing, it must say that places were damaged and keep the recorder's own file.
Result<void> judge_unfinished(const Recorder& recorder, const UsersPlace& place, const Damage& damage,
                              const Content& whole, Judged& judged) {
  const fs::path file = place.scratch / "cut_off.mcap", partial = file.string() + ".partial";
  fs::remove(file);
  write(partial, damage.bytes);
  const Recorder::Answer repaired = recorder.run("repair " + quoted(file));
  if (repaired.exit_code == 1) return {};
  const Result<Content> kept = content_of(file);
  if (!kept) return kept.error();
  const bool only_end = kept->messages.size() <= whole.messages.size() &&
                        std::equal(kept->messages.begin(), kept->messages.end(), whole.messages.begin());
  const bool says_so = repaired.says("damage:") && fs::exists(partial);
  const bool silent = !repaired.says("was not completed by its recorder") || (!only_end && !says_so);
  if (silent) show("a repair of an unfinished recording is silent", damage, repaired);
  judged.silent_repairs += silent ? 1 : 0;
  judged.changed += says_what_changed(repaired) ? 0 : missing(kept->messages, whole.messages);
  if (recorder.run("verify " + quoted(file)).exit_code != 0) ++judged.damaged_copies;
  return {};
}

/// The recorder's file of `session` before it was completed.
Result<std::string> unfinished_of(const fs::path& session, const std::string& bytes) {
  const Result<wire::McapReader> reader = wire::McapReader::open(session);
  if (!reader) return reader.error();
  constexpr std::size_t kDataEndBytes = wire::mcap::kRecordHeadBytes + 4;
  return bytes.substr(0, reader->summary().start - kDataEndBytes);
}

}  // namespace

Result<std::vector<Row>> run_records_section(const UsersPlace& place) {
  const Recorder recorder(place);
  const Result<std::string> session = recorded_session(place, recorder);
  if (!session) return session.error();
  const fs::path file = place.scratch / "session.mcap";
  const Result<Content> whole = content_of(file);
  if (!whole) return whole.error();
  if (recorder.run("verify " + quoted(file)).exit_code != 0) return not_recorded("verify calls it damaged");
  Judged judged;
  for (unsigned number = 0; number < kDamages; ++number)
    if (const Result<void> done = judge_finished(recorder, place, damaged(*session, number), *whole, judged); !done)
      return done.error();
  const Result<std::string> unfinished = unfinished_of(file, *session);
  if (!unfinished) return unfinished.error();
  for (unsigned number = 0; number < kUnfinished; ++number)
    if (const Result<void> done = judge_unfinished(recorder, place, damaged(*unfinished, number), *whole, judged);
        !done)
      return done.error();
  const double all = static_cast<double>(whole->messages.size()) * kDamages;
  return std::vector{at_most("damaged sessions called whole, of 500", judged.called_whole, "", 0.0),
                     at_most("repairs that do not say what they lost, of 600", judged.silent_repairs, "", 0.0),
                     at_most("repaired copies that verify calls damaged, of 600", judged.damaged_copies, "", 0.0),
                     at_most("messages that a repair changes, without naming the changed definition",
                             static_cast<double>(judged.changed), "", 0.0),
                     measured("messages that repair recovers, of 500 damaged sessions",
                              100.0 * static_cast<double>(judged.recovered) / all, "%")};
}

}  // namespace telepalp::bench
