#include "support/program/terminal.h"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace telepalp::program {
namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

}  // namespace

bool takes_progress(std::FILE* stream) { return ::isatty(::fileno(stream)) == 1 && environment("TERM") != "dumb"; }

bool takes_colour(std::FILE* stream) { return takes_progress(stream) && environment("NO_COLOR").empty(); }

}  // namespace telepalp::program
