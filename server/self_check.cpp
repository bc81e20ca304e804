#include "server/self_check.h"

#include <sys/timex.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "proto/keys/seal/site_key.h"
#include "proto/keys/secret/passphrase.h"
#include "proto/words/counted.h"
#include "server/capture/capture_source.h"
#include "server/key_checks.h"
#include "server/port_checks.h"

namespace telepalp::server {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLeastRoom_MB = 1000;  ///< about five minutes of a recording with colour
constexpr std::string_view kCamera = "openni2";

Finding check_camera() {
  const std::vector<capture::FoundCamera> cameras = capture::find_cameras();
  if (cameras.empty())
    return problem("source", {.what = "no camera is connected, or its driver does not see it",
                              .where = std::string(kCamera),
                              .fix = "plug the camera in, and check that this user may use it"});
  std::string text = counted(cameras.size(), "camera", "cameras") + ":";
  for (const capture::FoundCamera& camera : cameras) text += " " + camera.name;
  return good("source", text);
}

/// A recording is opened. A camera is only looked for, because a running server may have it open.
Findings check_source(const Asked& asked) {
  if (asked.relay.shows) return {};  // check_others() checks the site of another server
  if (asked.source.starts_with(kCamera)) return {check_camera()};
  const auto opened = capture::open_source(asked.source, {.loop = asked.loop, .paced = true});
  return {opened ? good("source", asked.source + " can be opened") : problem("source", opened.error())};
}

Finding check_room(const std::string& what, const fs::path& folder) {
  std::error_code failed;
  const auto room = fs::space(folder, failed);
  if (failed)
    return problem(what,
                   {.what = "cannot be read: " + failed.message(), .where = folder.string(), .fix = "make the folder"});
  const std::uintmax_t room_MB = room.available / 1'000'000;
  const std::string text = folder.string() + " has room for " + std::to_string(room_MB) + " MB";
  return room_MB < kLeastRoom_MB ? note(what, text + ": free space") : good(what, text);
}

/// Whether recordings are encrypted, and whether this server can play them again.
Findings check_site_keys() {
  const Result<std::vector<keys::SiteKey>> site_keys = keys::site_keys_of_environment();
  if (!site_keys) return {problem("recordings' key", site_keys.error())};
  if (site_keys->empty()) return {};
  const keys::SiteKey& first = site_keys->front();
  const std::string text = first.file().string() + " encrypts new recordings";
  if (first.has_private_part()) return {good("recordings' key", text)};
  return {note("recordings' key", text + ", which this server cannot play: it has the public part alone")};
}

Findings check_recorder(const Asked& asked, keys::WallTime now) {
  if (!asked.recorder) return {};
  const fs::path& folder = asked.recorder->folder;
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return {problem("recordings", {.what = std::string("cannot be written: ") + std::strerror(errno),
                                   .where = folder.string(),
                                   .fix = "make the folder, and let the server's user write to it"})};
  Findings found{check_room("recordings", folder)};
  for (Finding& finding : check_site_keys()) found.push_back(std::move(finding));
  const auto key = keys::load_client_key(asked.recorder->key, now, keys::passphrase_of_environment);
  if (!key) found.push_back(problem("recorder's key", key.error()));
  if (key && *key != nullptr)
    found.push_back(
        validity("recorder's key", "of " + keys::describe((**key).identity), (**key).identity.expires, now));
  if (::access(asked.recorder->program.c_str(), X_OK) != 0)
    found.push_back(problem("recorder", {.what = std::string("cannot be run: ") + std::strerror(errno),
                                         .where = asked.recorder->program.string(),
                                         .fix = "install telepalp-clients"}));
  return found;
}

Findings check_files(const Asked& asked) {
  Findings found;
  if (asked.gateway) {
    const fs::path page = asked.gateway->viewer_files / "index.html";
    std::error_code unknown;
    found.push_back(fs::is_regular_file(page, unknown)
                        ? good("web page", page.string())
                        : problem("web page", {.what = "is not there",
                                               .where = page.string(),
                                               .fix = "name by --viewer the folder with the web viewer's index.html"}));
  }
  if (asked.keys) {
    const fs::path log = asked.keys->audit.empty() ? asked.keys->key : asked.keys->audit;
    found.push_back(check_room("disk of the audit log", log.has_parent_path() ? log.parent_path() : fs::path(".")));
  }
  if (!asked.compare_folder.empty()) found.push_back(check_room("sessions to compare", asked.compare_folder));
  return found;
}

/// The dates of certificates and of the audit log's lines depend on this computer's clock.
Finding check_clock() {
  timex state{};
  if (::adjtimex(&state) != TIME_ERROR) return good("clock", "is kept right by a time server");
  return note("clock", "no time server keeps it right: timedatectl set-ntp true, or install chrony");
}

void add(Findings& all, Findings more) {
  for (Finding& finding : more) all.push_back(std::move(finding));
}

}  // namespace

Findings self_check(const Asked& asked, keys::WallTime now) {
  boost::asio::io_context io;
  Findings found = check_keys(asked, now);
  add(found, check_ports(io, asked));
  add(found, check_source(asked));
  add(found, check_others(io, asked));
  add(found, check_recorder(asked, now));
  add(found, check_files(asked));
  found.push_back(check_clock());
  return found;
}

}  // namespace telepalp::server
