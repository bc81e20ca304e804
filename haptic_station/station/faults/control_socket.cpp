#include "haptic_station/station/faults/control_socket.h"

#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <boost/asio/read_until.hpp>
#include <boost/asio/streambuf.hpp>
#include <boost/asio/write.hpp>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <istream>
#include <utility>
#include <vector>

namespace telepalp::station {
namespace {

namespace fs = std::filesystem;
using Protocol = boost::asio::local::stream_protocol;
using boost::system::error_code;

constexpr std::size_t kLongestLine = 256;
constexpr const char* kPrefix = "telepalp-station.";
constexpr const char* kSuffix = ".control";

/// A client, until it has its reply.
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

bool fits(const fs::path& path) { return path.string().size() < sizeof(sockaddr_un::sun_path); }

/// Tries to connect to `path`. No error: a station listens there.
error_code connecting_to(const std::string& path) {
  boost::asio::io_context io;
  Protocol::socket socket(io);
  error_code error;
  socket.connect(Protocol::endpoint(path), error);
  return error;
}

/// The reason why `entry` may not be replaced; nullopt if it may. Only a socket of this user on which nobody listens
/// may be replaced: a crashed station left it.
std::optional<std::string> in_the_way(const OwnFolder::Entry& entry, const std::string& path) {
  if (S_ISLNK(entry.mode)) return "the path is a symbolic link, which telepalp does not follow";
  if (!S_ISSOCK(entry.mode)) return "the path is a file or a folder, not a socket; it is left as it is";
  if (entry.owner != ::geteuid()) return "the path is a socket of another user";
  const error_code error = connecting_to(path);
  if (!error) return "another station listens on this socket";
  if (error == boost::asio::error::connection_refused) return std::nullopt;
  return "the path is a socket of another program: " + error.message();
}

}  // namespace

Result<void> ControlSocket::listen(const fs::path& asked) {
  const fs::path path = asked.lexically_normal();
  const auto why = [&path](const std::string& what) {
    return Error{.what = what,
                 .where = path.string(),
                 .fix = "name another path by --control PATH, or give --control none to run without this socket"};
  };
  const std::string name = path.filename().string();
  if (name.empty() || name == "." || name == "..") return why("is a folder, not a socket");
  if (!fits(path)) return why("the path is too long for a socket");
  Result<OwnFolder> folder = OwnFolder::open(path.has_parent_path() ? path.parent_path() : fs::path("."), true);
  if (!folder) return folder.error();
  folder
      ->lock();  // otherwise two stations that start together could each mistake the other's new socket for an old one
  const std::optional<std::string> problem = bind_in(*folder, name);
  folder->unlock();
  if (problem) return why(*problem);
  path_ = path;
  folder_ = std::move(folder).value();
  bound_ = folder_->entry(name);
  accept();
  return {};
}

std::optional<std::string> ControlSocket::bind_in(const OwnFolder& folder, const std::string& name) {
  const std::string path = folder.through_descriptor(name);
  if (const std::optional<OwnFolder::Entry> old = folder.entry(name)) {
    if (const std::optional<std::string> problem = in_the_way(*old, path)) return problem;
    folder.remove(name);
  }
  error_code error;
  acceptor_.open(Protocol(), error);
  // The mode is set before bind(). On Linux the socket's file then has this mode from the start, so no other user can
  // ever connect.
  if (!error && ::fchmod(acceptor_.native_handle(), S_IRUSR | S_IWUSR) != 0)
    error.assign(errno, boost::system::system_category());
  if (!error) acceptor_.bind(Protocol::endpoint(path), error);
  if (!error) acceptor_.listen(boost::asio::socket_base::max_listen_connections, error);
  if (!error) return std::nullopt;
  error_code ignored;
  acceptor_.close(ignored);
  return error.message();
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
  const std::string name = path_.filename().string();
  const std::optional<OwnFolder::Entry> entry = folder_->entry(name);
  if (entry && bound_ && entry->is(*bound_))
    folder_->remove(name);  // a different file at this path belongs to another station
  path_.clear();
  folder_.reset();
}

Result<std::string> ask_station(const fs::path& path, const std::string& command,
                                std::chrono::duration<double> patience) {
  const auto why = [&path](const error_code& error) {
    return Error{.what = "the station does not answer: " + error.message(),
                 .where = path.string(),
                 .fix = "check that telepalp-station runs, and name the path of its control socket by --control PATH"};
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
  io.run_for(std::chrono::duration_cast<std::chrono::steady_clock::duration>(patience));
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
  if (fs::exists(fs::symlink_status(control_folder(), error)))
    if (const Result<OwnFolder> folder = OwnFolder::open(control_folder(), false); !folder) return folder.error();
  for (const fs::directory_entry& entry : fs::directory_iterator(control_folder(), error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(kPrefix) && name.ends_with(kSuffix) && fits(entry.path()) &&
        !connecting_to(entry.path().string()))
      found.push_back(entry.path());
  }
  if (found.size() == 1) return found.front();
  if (found.empty())
    return Error{.what = "no running station has a control socket in this folder",
                 .where = control_folder().string(),
                 .fix = "start telepalp-station, or name the path of its control socket by --control PATH"};
  std::string all;
  for (const fs::path& path : found) all += (all.empty() ? "" : ", ") + path.string();
  return Error{.what = "several running stations have control sockets in this folder: " + all,
               .where = control_folder().string(),
               .fix = "name one of these sockets by --control PATH"};
}

}  // namespace telepalp::station
