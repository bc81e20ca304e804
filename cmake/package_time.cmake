# Read by cpack before it makes the packages: each file in them gets the time of the commit, or of the environment's
# SOURCE_DATE_EPOCH, so that packages of the same files are the same bytes (https://reproducible-builds.org/specs).
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  execute_process(COMMAND git -C ${CMAKE_CURRENT_LIST_DIR} log -1 --format=%ct
    OUTPUT_VARIABLE package_time OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT package_time)  # sources without git
    file(TIMESTAMP ${CMAKE_CURRENT_LIST_DIR}/../CHANGELOG.md package_time "%s" UTC)
  endif()
  set(ENV{SOURCE_DATE_EPOCH} ${package_time})
endif()
