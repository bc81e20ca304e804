#include "tools/study/designer_command.h"

#include <boost/asio/ip/address.hpp>
#include <boost/asio/signal_set.hpp>
#include <csignal>

#include "support/program/ending.h"
#include "support/program/log.h"
#include "support/program/options.h"
#include "tools/study/commands.h"
#include "tools/study/designer/designer_page.h"
#include "tools/study/device/device_thread.h"

namespace telepalp::study {
namespace {

namespace asio = boost::asio;

const program::Usage kDesignerUsage{
    .program = "telepalp-study designer",
    .purpose =
        "serves a page in which a four-bar linkage with a needle is turned, changed and compared: forces at needle and "
        "hand, reach, dead points, the overshoot that simulated operators make, and a search for the best linkage",
    .positional = {},
    .options =
        {{"port", "PORT", "port of the page; 0: any free one", "0"},
         {"listen", "ADDRESS", "address of this machine; another than loopback lets the network see the page",
          "127.0.0.1"},
         {"operators", "N", "simulated operators who judge each linkage", "12"},
         {"seed", "N", "the same seed gives the same operators, as for telepalp-study", "1"},
         {"threads", "N", "of a search; 0: one for each processor", "0"},
         {"device", "DEVICE",
          "a haptic device at which links, handle and needle are felt and grasped: haply[:URL] or udp:HOST:PORT"}},
    .example = "telepalp-study designer --port 8766",
};

struct DesignerAsked {
  Door door;
  std::string device;
  JudgeSettings judges;
};

Result<DesignerAsked> read_designer_options(const program::Arguments& arguments) {
  const Result<std::int64_t> port = arguments.whole("port", 0, 65'535);
  if (!port) return port.error();
  const Result<std::int64_t> operators = arguments.whole("operators", 2, 200);
  if (!operators) return operators.error();
  const Result<std::uint64_t> seed = read_seed(arguments);
  if (!seed) return seed.error();
  const Result<int> threads = read_threads(arguments);
  if (!threads) return threads.error();
  Result<Door> door = new_door(arguments.text("listen"), *port);
  if (!door) return door.error();
  return DesignerAsked{.door = std::move(*door),
                       .device = arguments.text("device"),
                       .judges = {.operators = static_cast<int>(*operators), .seed = *seed, .threads = *threads}};
}

int run(const DesignerAsked& asked) {
  std::unique_ptr<DeviceThread> device;  // ends after the pages, whose linkages it works on
  if (!asked.device.empty()) {
    Result<std::unique_ptr<DeviceThread>> connected = connect_device_thread(asked.device);
    if (!connected) return program::fail(connected.error());
    device = std::move(*connected);
  }
  asio::io_context io(1);
  Workers workers(asked.judges);  // ends before `io`, to which its threads post
  std::unique_ptr<PageServer> server;
  asio::signal_set signals(io, SIGINT, SIGTERM);  // now, because the page's tissue takes a while to make
  signals.async_wait([&](const boost::system::error_code& cancelled, int) {
    if (cancelled) return;
    program::end_within(program::kTimeToEnd, "telepalp-study: a search did not end within 5 s; the program ends");
    server.reset();
    workers.searches.stop();
    workers.predictions.stop();
    io.stop();
  });
  Result<Page> page = designer_page(workers, device.get());
  if (!page) return program::fail(page.error());
  Result<std::unique_ptr<PageServer>> opened = PageServer::open(io, asked.door, std::move(*page));
  if (!opened) return program::fail(opened.error());
  server = std::move(*opened);
  if (!asio::ip::make_address(asked.door.listen).is_loopback())
    program::log(kProgram, "the page is not encrypted: whoever can read this network can use it");
  if (const int printed = program::print(page_address(server->door()) + "\n"); printed != program::kDone)
    return printed;
  program::log(kProgram, "open this address in a browser; Ctrl-C ends the program");
  io.run();
  workers.searches.join();
  workers.predictions.join();
  program::work_is_done();
  return program::kDone;
}

}  // namespace

int run_designer(int argc, const char* const* argv) {
  return program::run_program(kDesignerUsage, argc, argv, [](const program::Arguments& arguments) {
    const Result<DesignerAsked> asked = read_designer_options(arguments);
    return asked ? run(*asked) : program::fail(asked.error(), program::kAskedWrongly);
  });
}

}  // namespace telepalp::study
