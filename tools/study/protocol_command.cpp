#include "tools/study/protocol_command.h"

#include <boost/asio/ip/address.hpp>
#include <boost/asio/signal_set.hpp>
#include <csignal>

#include "support/program/ending.h"
#include "support/program/files/whole_file.h"
#include "support/program/log.h"
#include "support/program/options.h"
#include "tools/study/commands.h"
#include "tools/study/protocol/hands/device_hand.h"
#include "tools/study/protocol/people.h"
#include "tools/study/protocol/protocol_page.h"

namespace telepalp::study {
namespace {

namespace asio = boost::asio;
constexpr std::chrono::milliseconds kLastWords{800};  // in which the page gets the last state

const program::Usage kProtocolUsage{
    .program = "telepalp-study protocol",
    .purpose =
        "a person punctures with each mechanism of a design, by the protocol of the simulated operators: "
        "training, then all mechanisms in random order. It serves the page at which the person works, and tells "
        "the overshoots at the end",
    .positional = {},
    .options = {kDesignOption,
                {"device", "DEVICE",
                 "the person holds a haptic device, and the page only tells what to do: haply[:URL] or udp:HOST:PORT"},
                {"participant", "NAME", "short name of the person, such as p07"},
                {"conditions", "LIST", "some of force, vision and both, such as force,both", "both"},
                {"training", "N", "penetrations before each condition, five with each of a few mechanisms", "15"},
                {"penetrations", "N", "of each mechanism in each condition", "5"},
                kSeedOption,
                {"out", "DIR",
                 "folder of report.html, study.json, trials.csv and participants/; the same command goes on"},
                {"port", "PORT", "port of the page; 0: any free one", "0"},
                {"listen", "ADDRESS", "address of this machine; another than loopback lets the network see the page",
                 "127.0.0.1"},
                {"report", "", "serve no page: only tell what has been done"},
                {"json", "", "print study.json instead of the table"}},
    .example = "telepalp-study protocol --participant p01 --out protocol",
};

struct ProtocolAsked {
  Protocol protocol;
  Participant participant;
  std::string device;  // empty: the browser's mouse moves the hand
  std::filesystem::path out;
  Door door;
};

Result<void> read_counts(const program::Arguments& arguments, Protocol& protocol) {
  const Result<std::int64_t> training = arguments.whole("training", 0, 200);
  if (!training) return training.error();
  const Result<std::int64_t> penetrations = arguments.whole("penetrations", 1, 50);
  if (!penetrations) return penetrations.error();
  const Result<std::uint64_t> seed = read_seed(arguments);
  if (!seed) return seed.error();
  protocol.training = static_cast<int>(*training);
  protocol.penetrations = static_cast<int>(*penetrations);
  protocol.seed = *seed;
  return {};
}

Result<ProtocolAsked> read_protocol_options(const program::Arguments& arguments) {
  ProtocolAsked asked;
  Result<Design> read = read_design_choice(arguments);
  if (!read) return read.error();
  asked.protocol.design = std::move(*read);
  Result<std::vector<Condition>> conditions = read_conditions(arguments.text("conditions"));
  if (!conditions) return conditions.error();
  asked.protocol.conditions = std::move(*conditions);
  if (const Result<void> counts = read_counts(arguments, asked.protocol); !counts) return counts.error();
  Result<Participant> participant = participant_of(arguments.text("participant"));
  if (!participant && !arguments.has("report")) return participant.error();
  if (participant) asked.participant = std::move(*participant);
  asked.device = arguments.text("device");
  if (!asked.device.empty()) asked.protocol.hand = PersonHand::Device;
  const Result<std::filesystem::path> out = read_out(arguments);
  if (!out) return out.error();
  asked.out = *out;
  const Result<std::int64_t> port = arguments.whole("port", 0, 65'535);
  if (!port) return port.error();
  Result<Door> door = new_door(arguments.text("listen"), *port);
  if (!door) return door.error();
  asked.door = std::move(*door);
  return asked;
}

/// Writes all files of the folder, and prints the table.
int tell(const ProtocolAsked& asked, bool as_json) {
  Result<People> people = read_people(asked.protocol, asked.out);
  if (!people) return program::fail(people.error());
  for (const std::string& other : people->left_out)
    program::log(kProgram, other + " followed another protocol, and is left out of the report");
  if (people->records.empty())
    return program::fail(Error{.what = "nobody has followed this protocol",
                               .where = (asked.out / "participants").string(),
                               .fix = "give the options with which it was begun, or --participant NAME to begin"});
  const PeopleResult result = result_of(asked.protocol, std::move(*people));
  const std::string json = people_json(asked.protocol, result);
  for (const auto& [file, text] :
       {std::pair<const char*, std::string>{"trials.csv", people_csv(asked.protocol, result)},
        {"study.json", json},
        {"report.html", people_html(asked.protocol, result)}})
    if (const auto written = program::write_whole_file(asked.out / file, text, program::Readers::Group); !written)
      return program::fail(written.error());
  return program::print(as_json ? json : people_text(asked.protocol, result));
}

/// Serves the page until the last penetration is done, or Ctrl-C. Error: the port, a file of the page, the journal, or
/// the session file.
Result<void> serve(const ProtocolAsked& asked, Session session, Journal journal, Place place) {
  asio::io_context io(1);
  asio::steady_timer end(io);
  const auto desk = std::make_shared<Desk>(
      std::move(session), std::move(journal), asked.participant.name,
      [&] {
        end.expires_after(kLastWords);
        end.async_wait([&](const boost::system::error_code& cancelled) {
          if (!cancelled) io.stop();
        });
      },
      std::move(place));
  asio::signal_set signals(io, SIGINT, SIGTERM);
  signals.async_wait([&](const boost::system::error_code& cancelled, int) {
    if (!cancelled) io.stop();
  });
  Result<Page> page = protocol_page(desk);
  if (!page) return page.error();
  Result<std::unique_ptr<PageServer>> server = PageServer::open(io, asked.door, std::move(*page));
  if (!server) return server.error();
  if (const int printed = program::print(page_address((*server)->door()) + "\n"); printed != program::kDone)
    return Error{.what = "the address of the page could not be printed", .where = "stdout", .fix = "free its disk"};
  if (!asio::ip::make_address(asked.door.listen).is_loopback())
    program::log(kProgram, "the page is not encrypted: whoever can read this network can use it");
  program::log(kProgram, "open this address in a browser; Ctrl-C ends the program, and the same command goes on");
  io.run();
  desk->leave();
  const Result<void> closed = desk->close();
  if (desk->failed()) return *desk->failed();
  return closed;
}

Result<void> follow(const ProtocolAsked& asked) {
  const std::filesystem::path file = journal_file(asked.out, asked.participant.name);
  if (const Result<Plant> plant = plant_for(asked.protocol, asked.participant); !plant) return plant.error();
  Result<Journal> journal = Journal::open(
      file,
      {.identity = identity_of(asked.protocol), .participant = asked.participant.name, .hand = asked.protocol.hand});
  if (!journal) return journal.error();
  if (journal->repaired())
    program::log(kProgram, file.string() + ": the last row was cut off; its penetration is asked for again");
  Result<Session> session = Session::make(asked.protocol, asked.participant, journal->attempts(), file.string());
  if (!session) return session.error();
  program::log(kProgram, asked.participant.name + ": " + std::to_string(session->done()) + " of " +
                             std::to_string(session->all()) + " penetrations are done");
  if (session->stage() == Stage::Finished) return {};
  std::unique_ptr<DeviceThread> hand;
  Place place;
  if (!asked.device.empty()) {
    Result<std::unique_ptr<DeviceThread>> connected = connect_device_thread(asked.device);
    if (!connected) return connected.error();
    hand = std::move(*connected);
    place.hand = [&hand = *hand](Prepared prepared, Condition condition) {
      return begin_at_device(hand, std::move(prepared), condition);
    };
  }
  Result<SittingFile> kept = SittingFile::open(asked.out, asked.participant.name, identity_of(asked.protocol));
  if (!kept) return kept.error();
  program::log(kProgram, "this sitting is kept in " + kept->name().string());
  place.file.emplace(std::move(*kept));
  return serve(asked, std::move(*session), std::move(*journal), std::move(place));
}

}  // namespace

int run_protocol(int argc, const char* const* argv) {
  return program::run_program(kProtocolUsage, argc, argv, [](const program::Arguments& arguments) {
    const Result<ProtocolAsked> asked = read_protocol_options(arguments);
    if (!asked) return program::fail(asked.error(), program::kAskedWrongly);
    if (!arguments.has("report"))
      if (const Result<void> followed = follow(*asked); !followed) return program::fail(followed.error());
    return tell(*asked, arguments.has("json"));
  });
}

}  // namespace telepalp::study
