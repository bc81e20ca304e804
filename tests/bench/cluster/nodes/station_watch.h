#pragma once

#include <boost/asio/io_context.hpp>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "proto/wire/client/client_link.h"
#include "proto/words/result.h"
#include "tests/bench/report.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {

/// A doctor's station, the real program with its simulated device, and what it says of itself over its server. Owner:
/// the thread that runs the io_context.
class StationWatch {
 public:
  /// Starts telepalp-station at the server of `host`:`port`, and runs `io` until its hand is in the body. `name`: of
  /// its log in `scratch`. Error: it does not touch within 40 s; the error names the log.
  [[nodiscard]] static Result<std::unique_ptr<StationWatch>> start(boost::asio::io_context& io, const std::string& host,
                                                                   std::uint16_t port,
                                                                   const std::filesystem::path& scratch,
                                                                   const std::string& name);

  /// What came between two moments.
  struct Facts {
    std::size_t images = 0;       ///< that became touchable
    std::uint64_t missed = 0;     ///< images between these that did not
    double longest_gap_ms = 0.0;  ///< between two instants at which an image became touchable, by the session's clock
    std::size_t releases = 0;     ///< and faults
  };
  /// How much has come at some moment.
  struct Moment {
    std::size_t surfaces = 0;
    std::size_t releases = 0;
  };
  [[nodiscard]] Moment moment() const noexcept { return {.surfaces = surfaces_.size(), .releases = releases_}; }
  [[nodiscard]] Facts since(const Moment& from) const { return between(from, moment()); }
  [[nodiscard]] Facts between(const Moment& from, const Moment& to) const;

 private:
  StationWatch(boost::asio::io_context& io, const std::string& host, std::uint16_t port);
  void hear(const wire::Message& message);

  struct Surface {
    std::uint64_t image = 0;  // its number
    std::uint64_t touchable_ns = 0;
  };
  std::vector<Surface> surfaces_;
  std::size_t releases_ = 0;
  bool touches_ = false;
  bool connected_ = false;
  std::unique_ptr<wire::ClientLink> link_;
  std::unique_ptr<support::ChildProcess> process_;
};

/// Rows of what the station could touch while a node was lost, and in an equally long time `before`. `what`: begins
/// each row's name.
void add_station_rows(const std::string& what, const StationWatch::Facts& before, const StationWatch::Facts& while_lost,
                      std::vector<Row>& rows);

}  // namespace telepalp::bench
