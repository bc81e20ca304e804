#include "support/program/ending.h"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>

#include "support/program/options.h"

namespace telepalp::program {
namespace {

// Read by signal handlers, which may neither lock nor allocate; written before the handlers are installed.
std::array<char, 400> last_words_text{};
std::size_t last_words_size = 0;
volatile std::sig_atomic_t seconds_allowed = 0;
volatile std::sig_atomic_t limit_runs = 0;

extern "C" void give_up(int /*signal*/) {
  if (::write(STDERR_FILENO, last_words_text.data(), last_words_size) < 0) _exit(kFailed);
  _exit(kFailed);
}

extern "C" void start_limit(int /*signal*/) {
  if (limit_runs != 0) return;
  limit_runs = 1;
  ::alarm(static_cast<unsigned>(seconds_allowed));
}

struct Sentence {
  std::array<char, 400> text{};
  std::size_t size = 0;
};
// say_when_stopped() writes the one that handlers do not read, and then exchanges them.
std::array<Sentence, 2> sentences{};
std::atomic<const Sentence*> said_when_stopped{nullptr};
static_assert(std::atomic<const Sentence*>::is_always_lock_free);

/// SA_RESETHAND has restored the signal's own action, which raise() starts when this handler returns.
extern "C" void say_and_end(int signal) {
  const Sentence* sentence = said_when_stopped.load();
  if (sentence != nullptr && ::write(STDERR_FILENO, sentence->text.data(), sentence->size) < 0) _exit(128 + signal);
  ::raise(signal);
}

void handle(int signal, void (*handler)(int), int flags = SA_RESTART) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  ::sigaction(signal, &action, nullptr);
}

void prepare(std::chrono::seconds limit, std::string_view last_words) {
  if (limit_runs != 0) return;
  last_words_size = std::min(last_words.size(), last_words_text.size() - 1);
  std::copy_n(last_words.begin(), last_words_size, last_words_text.begin());
  last_words_text[last_words_size++] = '\n';
  seconds_allowed = static_cast<int>(limit.count());
  handle(SIGALRM, give_up);
}

}  // namespace

void end_within(std::chrono::seconds limit, std::string_view last_words) {
  prepare(limit, last_words);
  start_limit(0);
}

void end_within_when_signalled(std::chrono::seconds limit, std::string_view last_words) {
  prepare(limit, last_words);
  handle(SIGINT, start_limit);
  handle(SIGTERM, start_limit);
}

void say_when_stopped(std::string_view sentence) {
  const Sentence* now = said_when_stopped.load();
  Sentence& next = now == &sentences[0] ? sentences[1] : sentences[0];
  next.size = std::min(sentence.size(), next.text.size() - 1);
  std::copy_n(sentence.begin(), next.size, next.text.begin());
  next.text[next.size++] = '\n';
  said_when_stopped.store(&next);
  if (now != nullptr) return;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal, say_and_end, SA_RESETHAND);
}

void work_is_done() {
  ::alarm(0);
  sigset_t all{};
  sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace telepalp::program
