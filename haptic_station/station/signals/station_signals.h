#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <functional>
#include <future>
#include <optional>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/rigs/scene_parts.h"

namespace telepalp::station {

/// A scene that was read and checked, with the files that it names.
struct LoadedScene {
  scenes::Scene scene;
  SceneParts parts;
};

/// Requests of an operator by signals: SIGINT and SIGTERM end the station; SIGHUP makes the station read its scene
/// again, or ends it if the process's terminal was closed. This object outlives each Station of the process, so that a
/// signal between two stations reaches the second one. Owner: network thread; the scene is read on another thread.
class StationSignals {
 public:
  enum class Asked { Nothing, End, NewScene };
  using ReadScene = std::function<Result<LoadedScene>()>;

  /// From now on, SIGHUP is kept for asked(). A process that ignores SIGHUP (nohup) goes on ignoring it. `read`: called
  /// on another thread.
  explicit StationSignals(ReadScene read);

  /// From now on, SIGINT and SIGTERM are kept for asked(); before, they end the process at once.
  void keep_end();

  /// What the operator asks for; never waits. NewScene: a valid scene was read again. A refused scene is only logged.
  [[nodiscard]] Asked asked();

  /// The scene that asked() announced by NewScene; nullopt if it has been taken.
  [[nodiscard]] std::optional<LoadedScene> take_scene();

 private:
  void wait();
  void on_signal(int number);
  void read_again();

  const ReadScene read_;
  const bool had_terminal_;
  boost::asio::io_context io_{1};  // polled by asked()
  boost::asio::signal_set signals_{io_};
  bool end_asked_ = false;
  bool reading_asked_ = false;
  std::future<Result<LoadedScene>>
      reading_;  // valid(): a thread reads the scene; the destructor of this future waits for the end of that thread
  std::optional<LoadedScene> accepted_;
};

}  // namespace telepalp::station
