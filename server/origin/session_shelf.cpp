#include "server/origin/session_shelf.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "proto/wire/mcap/notes_file.h"
#include "proto/words/demand.h"
#include "server/origin/session_inbox.h"
#include "server/origin/session_origin.h"

namespace telepalp::origin {
namespace {

namespace fs = std::filesystem;

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
    if (entry->path().extension() != ".mcap" || !is_plain_name(name) || !entry->is_regular_file(unknown)) continue;
    found.push_back({name, entry->last_write_time(unknown), entry->file_size(unknown)});
  }
  std::ranges::sort(found, [](const Listed& a, const Listed& b) {
    return a.written != b.written ? a.written > b.written : a.name > b.name;
  });
  return found;
}

std::uint64_t utc_s(fs::file_time_type at) {
  const auto since = std::chrono::file_clock::to_sys(at).time_since_epoch();
  return static_cast<std::uint64_t>(std::max<std::int64_t>(0, std::chrono::floor<std::chrono::seconds>(since).count()));
}

}  // namespace

/// What is read of a session file before it can be played.
struct SessionShelf::Opened {
  std::unique_ptr<playback::SessionPlayer> player;
  std::unique_ptr<playback::SessionComparison> comparison{};  ///< null: no folder of other sessions is named
  std::vector<wire::ToldNote> told{};                         // while the session took place

  static Result<Opened> read(const playback::PlaybackSpec& spec, bool loop, const wire::SessionClock& clock,
                             const Options& options, const Progress& progress) {
    auto player = playback::SessionPlayer::open(spec, loop, clock, progress);
    if (!player) return player.error();
    Opened opened{std::move(player).value()};
    auto told = wire::told_notes(spec.file);
    if (!told) return told.error();
    opened.told = std::move(told).value();
    if (options.compared.empty()) return opened;
    auto comparison = playback::SessionComparison::open(spec.file, options.compared, options.say);
    if (!comparison) return comparison.error();
    opened.comparison = std::move(comparison).value();
    return opened;
  }
};

SessionShelf::SessionShelf(boost::asio::io_context& network, const wire::SessionClock& clock, OpeningPool& pool,
                           Options options)
    : network_(network),
      clock_(clock),
      pool_(pool),
      options_(std::move(options)),
      inbox_(std::make_unique<SessionInbox>(
          network, clock, pool,
          SessionInbox::Options{
              .folder = options_.recordings, .say = options_.say, .on_brought = options_.on_brought})) {}

SessionShelf::~SessionShelf() = default;

Result<std::unique_ptr<Origin>> SessionShelf::origin_of(Opened opened, const playback::PlaybackSpec& spec,
                                                        bool is_endless) {
  const fs::path file = fs::absolute(spec.file).lexically_normal();
  std::shared_ptr<SessionSurvey> survey = surveys_[file].lock();
  if (!survey) {
    Result<playback::SessionNotes> notes = playback::SessionNotes::open(spec.file, opened.player->state().duration_s(),
                                                                        wire::as_session_notes(opened.told));
    if (!notes) return notes.error();
    survey.reset(new SessionSurvey{{spec.file, opened.player->begin(), options_.say}, std::move(*notes)});
    surveys_[file] = survey;
  }
  return std::unique_ptr<Origin>(
      std::make_unique<SessionOrigin>(network_, clock_,
                                      SessionOrigin::Parts{.player = std::move(opened.player),
                                                           .survey = std::move(survey),
                                                           .said = PlayedNotes(std::move(opened.told)),
                                                           .comparison = std::move(opened.comparison),
                                                           .is_endless = is_endless}));
}

Result<std::unique_ptr<Origin>> SessionShelf::play(const std::string& spec, bool loop) {
  Result<playback::PlaybackSpec> read = playback::read_spec(spec);
  if (!read) return read.error();
  Result<Opened> opened = Opened::read(*read, loop, clock_, options_, {});
  if (!opened) return opened.error();
  auto made = origin_of(std::move(opened).value(), *read, false);
  if (made) first_ = played_ = std::move(*read);
  loops_ = loop;
  return made;
}

Result<fs::path> SessionShelf::recording_named(const std::string& name) const {
  const fs::path& folder = options_.recordings;
  const std::vector<Listed> known = folder.empty() ? std::vector<Listed>{} : sessions_of(folder);
  const bool is_known = std::ranges::any_of(known, [&](const Listed& one) { return one.name == name; });
  if (is_known) return folder / name;
  return Error{.what = "this server has no recorded session of this name",
               .where = name.substr(0, 100),
               .fix = "choose one of the list Sessions of the QA view; the server lists its folder --record-dir"};
}

Result<playback::PlaybackSpec> SessionShelf::spec_of(const ReadingSpec& asked) const {
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
  if (!spec.file.empty()) return spec;
  return Error{.what = "this server plays no session now",
               .where = "at_s",
               .fix = "ask the sender to start telepalp-server again with --source session:FILE.mcap"};
}

void SessionShelf::play_later(const std::string& name, Progress progress, const OpenedOrigin& done) {
  const Result<fs::path> file = recording_named(name);
  if (!file) return done(file.error());
  playback::PlaybackSpec spec;
  spec.file = file->string();
  play_for_all(spec, std::move(progress), done);
}

void SessionShelf::play_again(Progress progress, const OpenedOrigin& done) {
  demand(first_.has_value(), "a session was played from the start");
  play_for_all(*first_, std::move(progress), done);
}

void SessionShelf::play_for_all(const playback::PlaybackSpec& spec, Progress progress, const OpenedOrigin& done) {
  open_later(spec, loops_, false, std::move(progress), [this, spec, done](Result<std::unique_ptr<Origin>> opened) {
    if (opened) played_ = spec;
    done(std::move(opened));
  });
}

void SessionShelf::read_alone(const ReadingSpec& asked, Progress progress, const OpenedOrigin& done) {
  const Result<playback::PlaybackSpec> spec = spec_of(asked);
  if (!spec) return done(spec.error());
  open_later(*spec, true, true, std::move(progress), done);
}

void SessionShelf::open_later(const playback::PlaybackSpec& spec, bool loop, bool is_endless, Progress progress,
                              const OpenedOrigin& done) {
  pool_.run<Opened>([spec, loop, clock = clock_, options = options_](
                        const Progress& read) { return Opened::read(spec, loop, clock, options, read); },
                    std::move(progress),
                    [this, spec, is_endless, done](Result<Opened> opened) {
                      if (!opened) return done(opened.error());
                      done(origin_of(std::move(opened).value(), spec, is_endless));
                    });
}

void SessionShelf::take(const std::string& json, const std::string& who, Resource::Done done) {
  inbox_->take(json, who, std::move(done));
}

msg::SessionList SessionShelf::list() const {
  msg::SessionList list;
  const fs::path& folder = options_.recordings;
  const std::vector<Listed> found = folder.empty() ? std::vector<Listed>{} : sessions_of(folder);
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
