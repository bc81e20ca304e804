#include "haptic_station/station/faults/control_socket.h"

#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <boost/asio/read_until.hpp>
#include <boost/asio/streambuf.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <cstdlib>
#include <istream>
#include <vector>

namespace telepalp::station {
namespace {

namespace fs = std::filesystem;
using Protocol = boost::asio::local::stream_protocol;
using boost::system::error_code;

constexpr std::size_t kLongestLine = 256;
constexpr std::chrono::seconds kPatience{3};
constexpr const char* kPrefix = "telepalp-station.";
constexpr const char* kSuffix = ".control";

/// Who asks, until it is answered.
struct Peer {
  explicit Peer(Protocol::socket connected) : socket(std::move(connected)) {}
  Protocol::socket socket;
  boost::asio::streambuf asked{kLongestLine};
};

void answer(const std::shared_ptr<Peer>& peer, const std::string& line) {
  const auto text = std::make_shared<std::string>(line + "\n");
  boost::asio::async_write(peer->socket, boost::asio::buffer(*text), [peer, text](const error_code&, std::size_t) {});
}

void listen_to(const std::shared_ptr<Peer>& peer, const std::weak_ptr<ControlSocket::Handler>& handler) {
  boost::asio::async_read_until(peer->socket, peer->asked, '\n', [peer, handler](const error_code& error, std::size_t) {
    const auto alive = handler.lock();
    if (error || !alive) return;
    std::string command;
    std::istream stream(&peer->asked);
    std::getline(stream, command);
    (*alive)(command, [peer](const std::string& line) { answer(peer, line); });
  });
}

/// Only ours, and nobody else's to write: a folder that another user made first is not trusted.
bool is_private(const fs::path& folder) {
  struct stat status {};
  return ::lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == ::geteuid() &&
         (status.st_mode & (S_IRWXG | S_IRWXO)) == 0;
}

bool fits(const fs::path& path) { return path.string().size() < sizeof(sockaddr_un::sun_path); }

bool answers(const fs::path& path) {
  boost::asio::io_context io;
  Protocol::socket socket(io);
  error_code error;
  socket.connect(Protocol::endpoint(path.string()), error);
  return !error;
}

}  // namespace

Result<void> ControlSocket::listen(const fs::path& path) {
  const auto why = [&path](const std::string& what) {
    return Error{.what = what, .where = path.string(), .fix = "name another place by --control, or --control none"};
  };
  if (!fits(path)) return why("the path is too long for a socket");
  std::error_code ignored;
  fs::create_directory(path.parent_path(), ignored);
  fs::permissions(path.parent_path(), fs::perms::owner_all,
                  ignored);  // fails where it is not ours, which is looked at:
  if (!is_private(path.parent_path())) return why("the folder is not this user's alone");
  fs::remove(path, ignored);  // of a process that had our number and crashed
  error_code error;
  acceptor_.open(Protocol(), error);
  if (!error) acceptor_.bind(Protocol::endpoint(path.string()), error);
  if (!error) acceptor_.listen(boost::asio::socket_base::max_listen_connections, error);
  if (error) return why(error.message());
  path_ = path;
  accept();
  return {};
}

void ControlSocket::accept() {
  acceptor_.async_accept([this, handler = std::weak_ptr(handler_)](const error_code& error, Protocol::socket socket) {
    if (error || handler.expired()) return;
    listen_to(std::make_shared<Peer>(std::move(socket)), handler);
    accept();
  });
}

void ControlSocket::stop() {
  error_code ignored;
  acceptor_.close(ignored);
  if (path_.empty()) return;
  std::error_code gone;
  fs::remove(path_, gone);
  path_.clear();
}

Result<std::string> ask_station(const fs::path& path, const std::string& command) {
  const auto why = [&path](const error_code& error) {
    return Error{.what = "the station does not answer: " + error.message(),
                 .where = path.string(),
                 .fix = "look whether telepalp-station runs, and name its socket by --control"};
  };
  if (!fits(path)) return why(boost::asio::error::name_too_long);
  boost::asio::io_context io;
  Protocol::socket socket(io);
  error_code error;
  socket.connect(Protocol::endpoint(path.string()), error);
  if (!error) boost::asio::write(socket, boost::asio::buffer(command + "\n"), error);
  if (error) return why(error);
  boost::asio::streambuf answered(4 * kLongestLine);
  error = boost::asio::error::timed_out;
  boost::asio::async_read_until(socket, answered, '\n',
                                [&error](const error_code& read, std::size_t) { error = read; });
  io.run_for(kPatience);
  if (error) return why(error);
  std::string line;
  std::istream stream(&answered);
  std::getline(stream, line);
  return line;
}

fs::path control_folder() {
  if (const char* runtime = std::getenv("XDG_RUNTIME_DIR"); runtime != nullptr && *runtime == '/')
    return fs::path(runtime) / "telepalp";
  return fs::path("/tmp") / ("telepalp-" + std::to_string(::geteuid()));
}

fs::path own_control_path() { return control_folder() / (kPrefix + std::to_string(::getpid()) + kSuffix); }

Result<fs::path> find_control_socket() {
  std::vector<fs::path> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(control_folder(), error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(kPrefix) && name.ends_with(kSuffix) && answers(entry.path())) found.push_back(entry.path());
  }
  if (found.size() == 1) return found.front();
  if (found.empty())
    return Error{.what = "no station runs here",
                 .where = control_folder().string(),
                 .fix = "start telepalp-station, or name its socket by --control"};
  std::string all;
  for (const fs::path& path : found) all += (all.empty() ? "" : ", ") + path.string();
  return Error{
      .what = "several stations run here: " + all, .where = "telepalp-station rearm", .fix = "name one by --control"};
}

}  // namespace telepalp::station
