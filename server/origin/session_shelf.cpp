#include "server/origin/session_shelf.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <utility>
#include <vector>

#include "server/origin/session_origin.h"
#include "support/program/message_json.h"

namespace telepalp::origin {
namespace {

namespace fs = std::filesystem;

/// A name that an address can carry as it is.
bool is_plain(std::string_view name) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
  return name.find_first_not_of(kPlain) == std::string_view::npos;
}

struct Listed {
  std::string name;
  fs::file_time_type written;
  std::uintmax_t bytes;
};

/// The sessions of `folder`, newest first.
std::vector<Listed> sessions_of(const fs::path& folder) {
  std::vector<Listed> found;
  std::error_code problem;
  for (auto entry = fs::directory_iterator(folder, problem); !problem && entry != fs::directory_iterator();
       entry.increment(problem)) {
    std::error_code unknown;
    const std::string name = entry->path().filename().string();
    if (entry->path().extension() != ".mcap" || !is_plain(name) || !entry->is_regular_file(unknown)) continue;
    found.push_back({name, entry->last_write_time(unknown), entry->file_size(unknown)});
  }
  std::ranges::sort(found, [](const Listed& a, const Listed& b) {
    return a.written != b.written ? a.written > b.written : a.name > b.name;
  });
  return found;
}

constexpr std::uintmax_t kSpare_B = std::uintmax_t{1} << 30;  // left free on the disk, for recordings
constexpr std::size_t kLongestName = 100;
constexpr const char* kPartExample =
    "send JSON such as {\"name\": \"a.mcap\", \"from\": 0, \"data\": BASE64, \"complete\": true}";

Error refused(std::string what, const std::string& name, std::string fix) {
  return {.what = std::move(what), .where = name.substr(0, kLongestName), .fix = std::move(fix)};
}

/// Whether `part` may be written behind what `growing` has.
Result<void> check(const msg::SessionPart& part, const fs::path& whole, const fs::path& growing) {
  const std::string& name = part.name();
  if (!name.ends_with(".mcap") || !is_plain(name) || name.starts_with('.') || name.size() > kLongestName)
    return refused("this is no name of a session", name,
                   "rename the file: letters, digits, . _ and - alone, 100 at most, with .mcap at the end");
  std::error_code unknown;
  if (fs::exists(whole, unknown))
    return refused("the server has a session of this name already", name, "open it in the list, or rename your file");
  const std::uintmax_t present = part.from() == 0 ? 0 : fs::file_size(growing, unknown);
  if (unknown || present != part.from())
    return refused("this part does not follow the part that came last", name, "send the file again from its beginning");
  if (fs::space(whole.parent_path(), unknown).available < kSpare_B + part.data().size())
    return refused("the disk of the server's recordings has less than 1 GiB left", name, "free space on the disk");
  return {};
}

Result<void> append(const msg::SessionPart& part, const fs::path& growing) {
  std::ofstream stream(growing, std::ios::binary | (part.from() == 0 ? std::ios::trunc : std::ios::app));
  stream.write(part.data().data(), static_cast<std::streamsize>(part.data().size()));
  stream.flush();
  if (stream) return {};
  return refused("the part cannot be written", growing.string(), "check the folder of --record-dir on the server");
}

std::uint64_t utc_s(fs::file_time_type at) {
  const auto since = std::chrono::file_clock::to_sys(at).time_since_epoch();
  return static_cast<std::uint64_t>(std::max<std::int64_t>(0, std::chrono::floor<std::chrono::seconds>(since).count()));
}

}  // namespace

SessionShelf::SessionShelf(boost::asio::io_context& network, const wire::SessionClock& clock, fs::path recordings,
                           fs::path compared, Say say)
    : network_(network),
      clock_(clock),
      recordings_(std::move(recordings)),
      compared_(std::move(compared)),
      say_(std::move(say)) {}

SessionShelf::~SessionShelf() = default;

Result<std::unique_ptr<Origin>> SessionShelf::open(const playback::PlaybackSpec& spec, bool loop, bool is_endless) {
  auto player = playback::SessionPlayer::open(spec, loop, clock_);
  if (!player) return player.error();
  const fs::path file = fs::absolute(spec.file).lexically_normal();
  std::shared_ptr<SessionSurvey> survey = surveys_[file].lock();
  if (!survey) {
    Result<playback::SessionNotes> notes = playback::SessionNotes::open(spec.file, (*player)->state().duration_s());
    if (!notes) return notes.error();
    survey.reset(new SessionSurvey{{spec.file, (*player)->begin(), say_}, std::move(*notes)});
    surveys_[file] = survey;
  }
  std::unique_ptr<playback::SessionComparison> comparison;
  if (!compared_.empty()) {
    auto opened = playback::SessionComparison::open(spec.file, compared_, say_);
    if (!opened) return opened.error();
    comparison = std::move(opened).value();
  }
  return std::unique_ptr<Origin>(
      std::make_unique<SessionOrigin>(network_, clock_,
                                      SessionOrigin::Parts{.player = std::move(player).value(),
                                                           .survey = std::move(survey),
                                                           .comparison = std::move(comparison),
                                                           .is_endless = is_endless}));
}

Result<std::unique_ptr<Origin>> SessionShelf::play(const std::string& spec, bool loop) {
  Result<playback::PlaybackSpec> read = playback::read_spec(spec);
  if (!read) return read.error();
  auto opened = open(*read, loop, false);
  if (opened) played_ = std::move(*read);
  return opened;
}

Result<fs::path> SessionShelf::recording_named(const std::string& name) const {
  const std::vector<Listed> known = recordings_.empty() ? std::vector<Listed>{} : sessions_of(recordings_);
  const bool is_known = std::ranges::any_of(known, [&](const Listed& one) { return one.name == name; });
  if (is_known) return recordings_ / name;
  return Error{.what = "this server has no recorded session of this name",
               .where = name.substr(0, 100),
               .fix = "choose one of the list Sessions of the QA view; the server lists its folder --record-dir"};
}

Result<std::unique_ptr<Origin>> SessionShelf::read_alone(const ReadingSpec& asked) {
  playback::PlaybackSpec spec = played_;
  spec.from_s = asked.at_s.value_or(0.0);
  spec.speed = 1.0;
  spec.paused = asked.at_s.has_value();
  if (!asked.session.empty()) {
    const Result<fs::path> file = recording_named(asked.session);
    if (!file) return file.error();
    spec.file = file->string();
    spec.topics = playback::PlaybackSpec{}.topics;
  }
  if (spec.file.empty())
    return Error{.what = "this server plays no session now",
                 .where = "at_s",
                 .fix = "ask the sender to start telepalp-server again with --source session:FILE.mcap"};
  return open(spec, true, true);
}

Result<void> SessionShelf::take(const std::string& json) {
  msg::SessionPart part;
  if (const Result<void> read = program::read_json(json, part, "sessions", kPartExample); !read) return read.error();
  const fs::path whole = recordings_ / part.name();
  const fs::path growing = recordings_ / (part.name() + ".part");
  if (const Result<void> checked = check(part, whole, growing); !checked) return checked.error();
  if (const Result<void> written = append(part, growing); !written) return written.error();
  if (!part.complete()) return {};
  playback::PlaybackSpec spec;
  spec.file = growing.string();
  const auto readable = playback::SessionPlayer::open(spec, true, clock_);
  std::error_code failed;
  if (readable) fs::rename(growing, whole, failed);
  if (readable && !failed) return {};
  fs::remove(growing, failed);
  return refused(readable ? "the file cannot be renamed" : "this is no session file: " + readable.error().what,
                 part.name(), readable ? "try again" : readable.error().fix);
}

msg::SessionList SessionShelf::list() const {
  msg::SessionList list;
  const std::vector<Listed> found = recordings_.empty() ? std::vector<Listed>{} : sessions_of(recordings_);
  for (const Listed& one : found) {
    if (list.sessions_size() == static_cast<int>(kMostListed)) break;
    msg::SessionList::Session& session = *list.add_sessions();
    session.set_name(one.name);
    session.set_bytes(one.bytes);
    session.set_written_s(utc_s(one.written));
  }
  return list;
}

}  // namespace telepalp::origin
