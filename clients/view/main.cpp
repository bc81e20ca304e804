#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <cstdio>
#include <set>
#include <utility>

#include "clients/view/live_figures.h"
#include "clients/view/newest_instant.h"
#include "proto/keys/key_file.h"
#include "proto/wire/camera/color_message.h"
#include "proto/wire/client/client_link.h"
#include "support/images/image_file.h"
#include "support/program/address.h"
#include "support/program/default_ports.h"
#include "support/program/ending.h"
#include "support/program/files/whole_file.h"
#include "support/program/log.h"
#include "support/program/options.h"
#include "support/program/patience.h"
#include "support/program/people/consent.h"

namespace {

using namespace telepalp;
using SteadyClock = std::chrono::steady_clock;

constexpr const char* kProgram = "telepalp-view";

program::Usage usage() {
  return {.program = kProgram,
          .purpose = "saves a picture of a running session, or prints rates, ages and losses by topic",
          .positional = {},
          .options = {{"connect", "SERVER", "HOST[:PORT], or SITE@HOST[:PORT]", program::kServerAddress},
                      {"key", "FILE", "your key or token file, for a server on another machine"},
                      program::consent_option(),
                      {"snapshot", "FILE.png", "save a picture of the patient and the doctor's hand"},
                      {"color", "jpeg|vp8", "take colour as pictures, or as video", "jpeg"},
                      {"stats", "", "print rates, bytes, ages and losses by topic"},
                      {"json", "", "with --stats: print JSON"},
                      {"seconds", "S", "with --stats: how long to listen", "5"},
                      program::patience_option("how long to wait for the server and its images", "10")},
          .example = "telepalp-view --connect 127.0.0.1 --snapshot view.png"};
}

struct Asked {
  program::Address server;
  std::shared_ptr<const keys::KeyFile> key;
  std::string consent;
  std::filesystem::path snapshot;
  wire::ColorCoding color = wire::ColorCoding::Pictures;
  bool stats = false;
  bool json = false;
  std::chrono::duration<double> seconds{5.0};
  program::Patience patience;
};

Result<Asked> asked_of(const program::Arguments& arguments) {
  const Result<program::Address> server = program::parse_server(arguments.text("connect"), "--connect");
  if (!server) return server.error();
  const Result<double> seconds = arguments.number("seconds", 0.1, 1e6);
  if (!seconds) return seconds.error();
  const Result<program::Patience> patience = program::patience_of(arguments);
  if (!patience) return patience.error();
  if (arguments.has("snapshot") == arguments.has("stats"))
    return Error{.what = "neither --snapshot nor --stats is given, or both are",
                 .where = kProgram,
                 .fix = "give --snapshot FILE.png for a picture, or --stats for figures"};
  if (const Result<void> stated = program::check_consent(arguments, "your watching"); !stated) return stated.error();
  const Result<wire::ColorCoding> color = wire::color_coding(arguments.text("color"), "--color");
  if (!color) return color.error();
  return Asked{.server = *server,
               .key = {},
               .consent = arguments.text("consent"),
               .snapshot = arguments.text("snapshot"),
               .color = *color,
               .stats = arguments.has("stats"),
               .json = arguments.has("json"),
               .seconds = std::chrono::duration<double>(*seconds),
               .patience = *patience};
}

/// Listens to the server until the picture or the figures are complete. Everything runs on this thread.
class View {
 public:
  explicit View(const Asked& asked)
      : asked_(asked),
        link_(io_,
              {.host = asked.server.host,
               .port = asked.server.port,
               .site = asked.server.site,
               .name = kProgram,
               .key = asked.key,
               .consent = asked.consent,
               .subscribes = wire::subscription_for(
                   asked.color, asked.stats ? std::vector<std::string>{"*"}
                                            : std::vector<std::string>{"/camera/*", "/station/state"})},
              {.on_message = [this](const wire::Message& message) { on_message(message); },
               .on_state = [this](wire::LinkState state, const std::string&) { on_state(state); }}) {}

  Result<void> run() {
    signals_.async_wait([this](const boost::system::error_code& cancelled, int) {
      if (!cancelled)
        stop(Error{
            .what = "stopped by Ctrl-C or by another program", .where = kProgram, .fix = "run telepalp-view again"});
    });
    wait(asked_.patience.value_or(program::kForEver), [this] { lose_patience(); });
    link_.start();
    io_.run();
    return outcome_;
  }

 private:
  template <class Then>
  void wait(std::chrono::duration<double> time, Then then) {
    timer_.expires_after(std::chrono::duration_cast<SteadyClock::duration>(time));
    timer_.async_wait([then = std::move(then)](const boost::system::error_code& cancelled) {
      if (!cancelled) then();
    });
  }
  void on_state(wire::LinkState state) {
    if (state == wire::LinkState::Refused) return stop(link_.refusal());
    if (state != wire::LinkState::Connected || std::exchange(connected_, true)) return;
    if (asked_.stats) wait(asked_.seconds, [this] { stop(print_figures()); });
  }
  void on_message(const wire::Message& message) {
    if (asked_.stats) return figures_.add(message, link_.clock().now());
    const view::NewestInstant::Taken taken = instant_.take(message);
    if (taken == view::NewestInstant::Taken::NeedsKeyFrame) link_.request_key_frame(message);
    if (taken == view::NewestInstant::Taken::Unreadable && unreadable_.insert(message.topic.name).second)
      program::log(kProgram, "a message on " + std::string(message.topic.name) +
                                 " is damaged or cut short, and left out; more of this topic are left out silently");
    if (instant_.is_complete(!without_hand_)) return stop(save());
    // A connected station publishes its state 100 times a second, so a longer wait would show no hand either.
    constexpr std::chrono::seconds kTimeForAState{2};
    if (instant_.is_complete(false) && !std::exchange(waits_for_state_, true))
      wait(kTimeForAState, [this] { go_without_hand(); });
  }
  /// No station's state came: saves the newest image if it is whole, else waits for the next whole one.
  void go_without_hand() {
    without_hand_ = true;
    wait(asked_.patience.value_or(program::kForEver), [this] { lose_patience(); });
    if (instant_.is_complete(false)) stop(save());
  }
  /// Called when the time is over: saves the patient without a hand if no station's state came, else ends with an
  /// error.
  void lose_patience() {
    if (!asked_.stats && instant_.is_complete(false)) return stop(save());
    stop(Error{
        .what = connected_
                    ? "the server answers, but sent no depth image with a colour image of the same instant, or no "
                      "calibration"
                    : link_.no_answer(),
        .where = program::to_text(asked_.server),
        .fix = connected_
                   ? "check the server's camera or recording (telepalp-server --source), or wait longer by --patience S"
                   : "start telepalp-server, name another one by --connect, or wait longer by --patience S"});
  }
  Result<void> save() const {
    if (!instant_.is_complete(true))
      program::log(kProgram,
                   "no station reported the device's place at the time of the image: the picture has no hand");
    constexpr int kWidth = 1280;
    constexpr int kHeight = 960;
    const Result<void> saved = program::write_whole_file(
        asked_.snapshot, images::encode_png(instant_.picture(kWidth, kHeight)), program::Readers::Group);
    if (saved) program::log(kProgram, "saved the picture: " + asked_.snapshot.string());
    return saved;
  }
  Result<void> print_figures() const {
    const double seconds = asked_.seconds.count();
    const double uncertainty_ms = to_milliseconds(link_.clock_uncertainty());
    const auto topics = figures_.topics(seconds, link_.received());
    const std::string text =
        asked_.json ? view::in_json(topics, seconds, uncertainty_ms) : view::in_table(topics, uncertainty_ms);
    std::fputs(text.c_str(), stdout);
    return {};
  }
  void stop(Result<void> outcome) {
    if (std::exchange(stopping_, true)) return;
    outcome_ = std::move(outcome);
    program::end_within(
        program::kTimeToEnd,
        "telepalp-view: the program did not end within 5 s and is aborted. fix: run telepalp-view again");
    signals_.cancel();
    timer_.cancel();
    link_.stop();
  }

  const Asked& asked_;
  boost::asio::io_context io_{1};
  boost::asio::signal_set signals_{io_, SIGINT, SIGTERM};
  boost::asio::steady_timer timer_{io_};
  view::NewestInstant instant_;
  std::set<std::string_view> unreadable_;  // topics with a damaged message, each logged once
  view::LiveFigures figures_;
  bool connected_ = false;
  bool waits_for_state_ = false;  ///< the patient can be drawn, the hand not yet
  bool without_hand_ = false;     ///< the picture no longer waits for the hand
  bool stopping_ = false;
  Result<void> outcome_;
  wire::ClientLink link_;
};

int run(const program::Arguments& arguments) {
  Result<Asked> asked = asked_of(arguments);
  if (!asked) return program::fail(asked.error(), program::kAskedWrongly);
  Result<std::shared_ptr<const keys::KeyFile>> key =
      keys::load_client_key(arguments.text("key"), std::chrono::system_clock::now());
  if (!key) return program::fail(key.error());
  asked->key = std::move(key).value();
  const Result<void> done = View(*asked).run();
  return done ? program::kDone : program::fail(done.error());
}

}  // namespace

int main(int argc, char** argv) { return program::run_program(usage(), argc, argv, run); }
