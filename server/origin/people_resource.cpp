#include "server/origin/people_resource.h"

#include "messages/people.pb.h"
#include "support/program/message_json.h"

namespace telepalp::origin {
namespace {

void set_person(msg::PeopleState::Person& person, const keys::Identity& who) {
  person.set_name(who.name);
  person.set_role(std::string(keys::name(who.role)));
  person.set_key(who.serial);
}

msg::PeopleState state_of(const access::Access& access, const access::TouchLease& touch) {
  const auto now = std::chrono::steady_clock::now();
  msg::PeopleState state;
  for (const auto& [number, stream] : access.people().present()) {
    msg::PeopleState::Person& person = *state.add_people();
    set_person(person, stream.who);
    person.set_program(stream.program);
    person.set_from(stream.from);
    person.set_since(stream.since);
  }
  for (const keys::Identity& who : access.people().sent_out(now)) set_person(*state.add_sent_out(), who);
  state.set_holds_touch(touch.holder(now).value_or(""));
  state.set_anchor(access.anchor());
  state.set_alarm(access.alarm());
  return state;
}

Result<void> apply(access::Access& access, const std::string& json, const std::string& who) {
  msg::PeopleCommand command;
  const char* const example =
      "send JSON such as {\"send_out\": \"KEY\"}, {\"let_in\": \"KEY\"} or {\"take_touch\": true}, with a key that GET "
      "/people lists";
  if (const Result<void> read = program::read_json(json, command, "people", example); !read) return read;
  if (!command.let_in().empty()) access.let_in(command.let_in(), who);
  if (command.take_touch())
    if (const Result<void> taken = access.take_touch_away(who); !taken) return taken;
  return command.send_out().empty() ? Result<void>{} : access.send_out(command.send_out(), who);
}

}  // namespace

Resource people_resource(access::Access& access) {
  return {.state = [&access] { return state_message(state_of(access, access.touch())); },
          .change =
              at_once([&access](const std::string& json, const std::string& who) { return apply(access, json, who); })};
}

}  // namespace telepalp::origin
