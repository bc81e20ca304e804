# Writes FILE, the translation unit that tells the commit of SOURCE_DIR, when it has changed. Each program links it, and
# nothing includes it: a commit recompiles these few lines and links the programs again.
# usage: cmake -DSOURCE_DIR=DIR -DFILE=commit.cpp -P write_commit.cmake
set(ENV{GIT_OPTIONAL_LOCKS} 0)
execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --exclude * --abbrev=7 --dirty=-modified
  OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
file(CONFIGURE OUTPUT ${FILE} @ONLY CONTENT [[
#include "support/program/version.h"

const char* telepalp::program::commit() noexcept { return "@COMMIT@"; }
]])
