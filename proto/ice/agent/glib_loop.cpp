#include "proto/ice/agent/glib_loop.h"

#include <pthread.h>

#include <chrono>
#include <csignal>
#include <utility>

namespace telepalp::ice {
namespace {

using namespace std::chrono_literals;

/// Starts a thread that takes no signal: the program's own threads wait for them.
std::thread without_signals(std::function<void()> body) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(std::move(body));
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

}  // namespace

GlibLoop& GlibLoop::of_process() {
  static GlibLoop loop;
  return loop;
}

GlibLoop::GlibLoop()
    : context_(g_main_context_new()), loop_(g_main_loop_new(context_, FALSE)), thread_(without_signals([this] {
        g_main_context_push_thread_default(context_);
        g_main_loop_run(loop_);
        g_main_context_pop_thread_default(context_);
      })) {}

GlibLoop::~GlibLoop() {
  for (const auto until = std::chrono::steady_clock::now() + 1s;
       agents_ > 0 && std::chrono::steady_clock::now() < until;)
    std::this_thread::sleep_for(5ms);
  run([this] { g_main_loop_quit(loop_); });
  thread_.join();
  g_main_loop_unref(loop_);
  g_main_context_unref(context_);
}

void GlibLoop::run(std::function<void()> work) {
  GSource* const source = g_idle_source_new();
  g_source_set_priority(source, G_PRIORITY_DEFAULT);
  g_source_set_callback(
      source,
      [](gpointer data) -> gboolean {
        (*static_cast<std::function<void()>*>(data))();
        return G_SOURCE_REMOVE;
      },
      new std::function<void()>(std::move(work)),
      [](gpointer data) { delete static_cast<std::function<void()>*>(data); });
  g_source_attach(source, context_);
  g_source_unref(source);
}

}  // namespace telepalp::ice
