#include "server/origin/session_inbox.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "proto/keys/audit_text.h"
#include "server/playback/session_player.h"
#include "support/program/message_json.h"

namespace telepalp::origin {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kSpare_B = std::uintmax_t{1} << 30;  // left free on the disk, for recordings
constexpr std::size_t kLongestName = 100;
constexpr std::string_view kPart = ".part";
constexpr std::string_view kPartial = ".partial";  // of wire::mcap::OutputFile, until it is published
constexpr const char* kPartExample =
    "send JSON such as {\"name\": \"a.mcap\", \"from\": 0, \"data\": BASE64, \"complete\": true}";

Error refused(std::string what, const std::string& name, std::string fix) {
  return {.what = std::move(what), .where = name.substr(0, kLongestName), .fix = std::move(fix)};
}

/// Whether `part` may be written behind the `present` bytes of the same file.
Result<void> check_part(const msg::SessionPart& part, const fs::path& whole, std::uint64_t present) {
  const std::string& name = part.name();
  if (!name.ends_with(".mcap") || !is_plain_name(name) || name.starts_with('.') || name.size() > kLongestName)
    return refused("this is no name of a session", name,
                   "rename the file: letters, digits, . _ and - alone, 100 at most, with .mcap at the end");
  std::error_code unknown;
  if (fs::exists(whole, unknown))
    return refused("the server has a session of this name already", name, "open it in the list, or rename your file");
  if (part.from() != 0 && part.from() != present)
    return refused("this part does not follow the part that came last", name, "send the file again from its beginning");
  if (fs::space(whole.parent_path(), unknown).available < kSpare_B + part.data().size())
    return refused("the disk of the server's recordings has less than 1 GiB left", name, "free space on the disk");
  return {};
}

/// The names of the files in `folder` that were not brought to their end.
std::vector<std::string> unfinished(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code problem;
  for (auto entry = fs::directory_iterator(folder, problem); !problem && entry != fs::directory_iterator();
       entry.increment(problem)) {
    std::string name = entry->path().filename().string();
    if (name.ends_with(kPartial)) name.resize(name.size() - kPartial.size());
    if (!name.ends_with(".mcap" + std::string(kPart))) continue;
    name.resize(name.size() - kPart.size());
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace

bool is_plain_name(std::string_view name) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
  return name.find_first_not_of(kPlain) == std::string_view::npos;
}

SessionInbox::SessionInbox(boost::asio::io_context& network, const wire::SessionClock& clock, OpeningPool& pool,
                           Options options)
    : clock_(clock), pool_(pool), options_(std::move(options)), look_(network) {
  if (options_.folder.empty()) return;
  for (const std::string& name : unfinished(options_.folder))
    remove(name, "an earlier server ended before it was whole");
}

fs::path SessionInbox::part_of(const std::string& name) const { return options_.folder / (name + std::string(kPart)); }

void SessionInbox::take(const std::string& json, const std::string& who, Resource::Done done) {
  msg::SessionPart part;
  if (const Result<void> read = program::read_json(json, part, "sessions", kPartExample); !read) return done(read);
  const auto present = growing_.find(part.name());
  if (present != growing_.end() && present->second.is_checked)
    return done(refused("this file is whole, and is being checked", part.name(), "wait until the list has it"));
  const std::uint64_t bytes = present == growing_.end() ? 0 : present->second.bytes;
  if (const Result<void> checked = check_part(part, options_.folder / part.name(), bytes); !checked)
    return done(checked);
  if (const Result<void> written = append(part); !written) {
    growing_.erase(part.name());
    remove(part.name(), "a part could not be written");
    return done(written);
  }
  if (part.complete()) return check(part, who, done);
  look_for_abandoned();
  done({});
}

/// A file that is encrypted already stays as it is.
Result<void> SessionInbox::append(const msg::SessionPart& part) {
  Growing& growing = growing_[part.name()];
  if (part.from() == 0) {
    if (growing.file) growing.file->discard();
    growing = {};
    const bool is_encrypted = part.data().starts_with(wire::mcap::kSealedMagic);
    auto file = wire::mcap::OutputFile::create(
        part_of(part.name()), is_encrypted ? wire::mcap::Protection::None : wire::mcap::Protection::OfSite);
    if (!file) return file.error();
    growing.file.emplace(*std::move(file));
  }
  if (Result<void> written = growing.file->append(part.data()); !written) return written;
  growing.bytes += part.data().size();
  growing.last_part = std::chrono::steady_clock::now();
  return {};
}

/// Completes the file and reads its index on a thread of the pool, because the network thread does not wait for the
/// disk.
void SessionInbox::check(const msg::SessionPart& last, const std::string& who, const Resource::Done& done) {
  Growing& growing = growing_[last.name()];
  growing.is_checked = true;
  // Shared, because the pool's functions can be copied.
  const auto file = std::make_shared<wire::mcap::OutputFile>(*std::exchange(growing.file, std::nullopt));
  playback::PlaybackSpec spec;
  spec.file = part_of(last.name()).string();
  pool_.run<bool>(
      [spec, file, clock = clock_](const Progress& progress) -> Result<bool> {
        if (const Result<void> completed = file->publish(); !completed) return completed.error();
        const auto opened = playback::SessionPlayer::open(spec, true, clock, progress);
        if (opened) return true;
        return Error{.what = "this is no session file that this server can read: " + opened.error().what,
                     .where = spec.file,
                     .fix = opened.error().fix};
      },
      [](double) {},
      [this, name = last.name(), who, done](const Result<bool>& readable) {
        const Result<void> accepted = accept(name, readable);
        note(name, who, accepted);
        done(accepted);
      });
}

Result<void> SessionInbox::accept(const std::string& name, const Result<bool>& readable) {
  growing_.erase(name);
  std::error_code failed;
  if (readable) fs::rename(part_of(name), options_.folder / name, failed);
  if (readable && !failed) return {};
  (void)remove_part(name);
  if (!readable) return refused(readable.error().what, name, readable.error().fix);
  return refused("the file cannot be renamed: " + failed.message(), name,
                 "check the folder of --record-dir on the server");
}

void SessionInbox::note(const std::string& name, const std::string& who, const Result<void>& outcome) const {
  if (!options_.on_brought) return;
  std::error_code unknown;
  const std::uintmax_t bytes = outcome ? fs::file_size(options_.folder / name, unknown) : 0;
  options_.on_brought(
      "who=" + who + " session=" + keys::audit_text(name) +
      (outcome ? " bytes=" + std::to_string(bytes) : " refused=" + keys::audit_text(outcome.error().what)));
}

void SessionInbox::look_for_abandoned() {
  const auto now = std::chrono::steady_clock::now();
  std::vector<std::string> gone;
  for (const auto& [name, growing] : growing_)
    if (!growing.is_checked && now - growing.last_part >= options_.abandoned) gone.push_back(name);
  for (const std::string& name : gone) {
    growing_.erase(name);
    remove(name, "its other parts have not come");
  }
  if (growing_.empty()) return;
  look_.expires_after(options_.abandoned);
  look_.async_wait([this](const boost::system::error_code& cancelled) {
    if (!cancelled) look_for_abandoned();
  });
}

bool SessionInbox::remove_part(const std::string& name) const {
  std::error_code failed;
  const bool was_whole = fs::remove(part_of(name), failed);
  const bool was_growing = fs::remove(part_of(name).string() + std::string(kPartial), failed);
  return was_whole || was_growing;
}

void SessionInbox::remove(const std::string& name, const char* why) {
  if (!remove_part(name) || !options_.say) return;
  options_.say("the unfinished session file " + name + std::string(kPart) + " is removed: " + why +
               ". fix: bring the file again");
}

}  // namespace telepalp::origin
