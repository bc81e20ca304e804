#include "tools/replay/workers/worker_watch.h"

#include "tools/replay/words/say.h"

namespace telepalp::replay {
namespace {

constexpr auto kNobodyAfter = std::chrono::seconds(5);  // a worker tells every kPresenceEvery that it is there

}  // namespace

void WorkerWatch::look(TimePoint now, const std::string& address) {
  for (const Inbox::Note& note : inbox_.take())
    if (const Result<Presence> worker = parse_presence(note.payload))
      if (workers_.hear(*worker, now) && worker->build != build_)
        say("the worker " + worker->name + " is of another version, " + worker->build + ", than this program, " +
            build_ + ", and makes none of its runs. fix: install the same version on both computers");
  workers_.forget_silent(now);
  const bool nobody = count() == 0 && now - began_ > kNobodyAfter;
  if (nobody && !said_nobody_)
    say("no worker of this version is there. fix: start telepalp-worker --connect " + address);
  said_nobody_ = nobody;
}

}  // namespace telepalp::replay
