#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "haptic_station/station/faults/own_folder.h"
#include "proto/words/result.h"

namespace telepalp::station {

/// A Unix socket for the commands of an operator on the station's machine. Only the station's user can open it. A
/// client sends one line and gets one line in reply. Owner: network thread.
class ControlSocket {
 public:
  using Reply = std::function<void(const std::string& line)>;
  /// Handles `command` and calls `reply` exactly once, immediately or later.
  using Handler = std::function<void(const std::string& command, Reply reply)>;

  ControlSocket(boost::asio::io_context& io, Handler handler)
      : acceptor_(io), handler_(std::make_shared<Handler>(std::move(handler))) {}
  ~ControlSocket() { stop(); }
  ControlSocket(const ControlSocket&) = delete;
  ControlSocket& operator=(const ControlSocket&) = delete;

  /// Creates the socket at `path`, which only this user can open, in a folder to which only this user can write. A
  /// missing folder is created. A socket of this user that a crashed station left is replaced; nothing else that exists
  /// is changed.
  [[nodiscard]] Result<void> listen(const std::filesystem::path& path);
  void stop();
  /// Path of the socket; empty while it does not listen.
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  void accept();
  /// Binds the socket to `name` in `folder`. Returns the problem, or nullopt on success.
  std::optional<std::string> bind_in(const OwnFolder& folder, const std::string& name);

  boost::asio::local::stream_protocol::acceptor acceptor_;
  std::shared_ptr<Handler> handler_;  // pending reads hold a weak_ptr; commands after the socket's end are dropped
  std::filesystem::path path_;
  std::optional<OwnFolder> folder_;        // the folder of path_ while the socket listens
  std::optional<OwnFolder::Entry> bound_;  // file status of the socket: stop() removes no other file
};

/// Sends a command to the station that listens at `path` and returns its reply. `patience`: longest wait for it.
[[nodiscard]] Result<std::string> ask_station(const std::filesystem::path& path, const std::string& command,
                                              std::chrono::duration<double> patience = std::chrono::seconds(3));

/// The folder of this user's control sockets, and the path in it of this process's own socket.
[[nodiscard]] std::filesystem::path control_folder();
[[nodiscard]] std::filesystem::path own_control_path();

/// Finds the socket of the only running station. Error: no station runs, or several do.
[[nodiscard]] Result<std::filesystem::path> find_control_socket();

}  // namespace telepalp::station
