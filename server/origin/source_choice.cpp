#include "server/origin/source_choice.h"

#include <algorithm>
#include <utility>

#include "support/program/message_json.h"

namespace telepalp::origin {
namespace {

constexpr const char* kWhere = "source";
constexpr const char* kSourceExample =
    "send JSON such as {\"source\": \"synthetic\"}, with a source that GET /source lists, or {\"look_for_cameras\": "
    "true}";

}  // namespace

SourceChoice::SourceChoice(OpeningPool& pool, Parts parts) : pool_(pool), parts_(std::move(parts)) {
  state_.set_present(parts_.first.name);
}

std::vector<SourceChoice::Source> SourceChoice::sources() const {
  std::vector<Source> all{parts_.first};
  const auto add = [&](const Source& source) {
    if (std::ranges::find(all, source.name, &Source::name) == all.end()) all.push_back(source);
  };
  for (const Source& camera : cameras_) add(camera);
  add({.name = "synthetic", .title = "the synthetic patient"});
  for (const Source& recording : parts_.recordings()) add(recording);
  return all;
}

msg::SourceState SourceChoice::state() {
  if (!std::exchange(looked_, true)) look_for_cameras();
  msg::SourceState state = state_;
  for (const Source& source : sources()) {
    msg::SourceState::Source& listed = *state.add_sources();
    listed.set_name(source.name);
    listed.set_title(source.title);
  }
  return state;
}

Resource SourceChoice::resource() {
  return {.state = [this] { return state_message(state()); },
          .change = at_once([this](const std::string& json, const std::string&) { return apply(json); })};
}

Result<void> SourceChoice::apply(const std::string& json) {
  msg::SourceCommand command;
  if (const Result<void> read = program::read_json(json, command, kWhere, kSourceExample); !read) return read;
  if (command.look_for_cameras()) look_for_cameras();
  return command.has_source() ? choose(command.source()) : Result<void>{};
}

Result<void> SourceChoice::choose(const std::string& name) {
  const std::vector<Source> known = sources();
  if (std::ranges::find(known, name, &Source::name) == known.end())
    return Error{.what = "this server may not open a source of this name", .where = kWhere, .fix = kSourceExample};
  if (!state_.opening().empty())
    return Error{.what = "another source is being opened", .where = kWhere, .fix = "wait until it is shown"};
  state_.set_opening(name);
  state_.set_read_share(0.0);
  state_.clear_problem();
  parts_.open(
      name, [this](double share) { state_.set_read_share(share); },
      [this, name](Result<std::unique_ptr<Origin>> opened) {
        state_.clear_opening();
        if (!opened) return state_.set_problem(to_string(opened.error()));
        state_.set_present(name);
        parts_.show(std::move(opened).value());
      });
  return {};
}

void SourceChoice::look_for_cameras() {
  pool_.run<std::vector<Source>>(
      [look = parts_.look_for_cameras](const Progress&) -> Result<std::vector<Source>> { return look(); },
      [](double) {},
      [this](Result<std::vector<Source>> found) {
        if (found) cameras_ = std::move(found).value();
      });
}

}  // namespace telepalp::origin
