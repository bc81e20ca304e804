#include "haptic_station/station/commands/hand_over.h"

#include <cstdio>
#include <string_view>
#include <utility>

#include "haptic_station/station/telemetry/say.h"
#include "support/program/options.h"
#include "support/program/patience.h"

namespace telepalp::station {
namespace {

constexpr std::string_view kOffer = "offer ";
constexpr std::string_view kDone = "done: ";
constexpr std::size_t kLongestName = 128;

program::Usage usage() {
  return {.program = "telepalp-station hand-over",
          .purpose =
              "offers the touch (the permission to palpate) to another doctor, or accepts it; once it is accepted, the "
              "first doctor's device gives no force",
          .positional = "",
          .options = {{"to", "NAME", "offer the touch for 60 s to the doctor whose key has this name"},
                      {"withdraw", "", "withdraw the offer"},
                      {"accept", "", "accept the touch that is offered to you or becomes free, now or later"},
                      {"control", "PATH",
                       "the station's control socket; default: that of the only station on this computer"},
                      program::patience_option("longest wait for the station's answer, in seconds; 0: for ever", "3")},
          .example = "telepalp-station hand-over --to bert"};
}

Result<std::string> command_of(const program::Arguments& arguments) {
  const int asked = int{arguments.has("to")} + int{arguments.has("withdraw")} + int{arguments.has("accept")};
  if (asked != 1)
    return Error{.what = "none, or more than one, of --to, --withdraw and --accept is given",
                 .where = "telepalp-station hand-over",
                 .fix = "give exactly one; see telepalp-station hand-over --help"};
  if (arguments.has("withdraw")) return std::string("withdraw");
  if (arguments.has("accept")) return std::string("accept");
  const std::string to = arguments.text("to");
  if (to.empty() || to.size() > kLongestName || to.find_first_of("\n\r") != std::string::npos)
    return Error{
        .what = "'" + to + "' cannot be the name of a key: it is empty, longer than 128 bytes or has a line break",
        .where = "--to",
        .fix = "give the name that the other doctor's key file has"};
  return std::string(kOffer) + to;
}

int run_asked(const program::Arguments& arguments) {
  const Result<std::string> command = command_of(arguments);
  if (!command) return program::fail(command.error(), program::kAskedWrongly);
  const Result<program::Patience> patience = program::patience_of(arguments);
  if (!patience) return program::fail(patience.error(), program::kAskedWrongly);
  const Result<std::filesystem::path> path =
      arguments.has("control") ? Result<std::filesystem::path>(arguments.text("control")) : find_control_socket();
  if (!path) return program::fail(path.error());
  const Result<std::string> answer = ask_station(*path, *command, patience->value_or(program::kForEver));
  if (!answer) return program::fail(answer.error());
  const bool done = answer->starts_with(kDone);
  const std::string text = program::escaped(done ? answer->substr(kDone.size()) : *answer);
  std::fprintf(done ? stdout : stderr, "%s%s\n", done ? "" : "error: ", text.c_str());
  return done ? program::kDone : program::kFailed;
}

}  // namespace

bool HandOver::on_command(const std::string& command, const ControlSocket::Reply& reply) {
  if (command == "accept") {
    link_.accept_touch();
    const bool holds = link_.state() == wire::LinkState::Connected;
    reply(holds ? "nothing to accept: this station is connected to its server, so it may already palpate"
                : std::string(kDone) +
                      "this station takes the touch (the permission to palpate) as soon as it is free, or another "
                      "doctor offers it");
    return true;
  }
  if (command == "withdraw") {
    ask("", reply);
    return true;
  }
  if (!command.starts_with(kOffer)) return false;
  ask(command.substr(kOffer.size()), reply);
  return true;
}

void HandOver::ask(const std::string& to, const ControlSocket::Reply& reply) {
  if (waiting_)
    return reply("an earlier hand-over command still waits for the server's answer. fix: try again in some seconds");
  if (!link_.hand_over(to))
    return reply(
        "this station is not connected to its server. fix: wait until the station logs 'link connected', then try "
        "again");
  waiting_ = reply;
}

void HandOver::on_answer(bool done, const std::string& outcome) {
  say(outcome);
  if (const auto reply = std::exchange(waiting_, std::nullopt)) (*reply)((done ? std::string(kDone) : "") + outcome);
}

int hand_over_command(int argc, const char* const* argv) {
  return program::run_program(usage(), argc, argv, run_asked);
}

}  // namespace telepalp::station
