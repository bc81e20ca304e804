# How every target of telepalp is made. A target may include only what it links: there is one include root (the
# repository), so the direction of dependencies is also checked by tests/architecture/architecture_test.cpp.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

option(TELEPALP_TESTS "build the tests and telepalp-bench" ON)
set(TELEPALP_SANITIZE "" CACHE STRING "comma-separated sanitizers, as for the compiler's option -fsanitize=")

option(TELEPALP_PCH "compile with precompiled headers; OFF proves that each file includes what it uses" ON)
option(TELEPALP_UNITY "compile the sources of a target together, eight at a time; OFF compiles each alone" ON)

# The sloppiness is what precompiled headers need. ccache keeps paths relative to the base directory.
find_program(CCACHE ccache)
if(CCACHE)
  set(launcher ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
    ${CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
endif()

# What is built names its sources by their place in the repository (`codec/depth.cpp`), never by a folder of the machine
# that built it: std::source_location and __FILE__ end up in messages and in the installed programs.
add_compile_options(-ffile-prefix-map=${PROJECT_BINARY_DIR}/= -ffile-prefix-map=${PROJECT_SOURCE_DIR}/=)

add_library(telepalp_flags INTERFACE)
target_compile_options(telepalp_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(telepalp_flags INTERFACE -Wno-restrict)  # GCC bug 105651: "a" + std::string() warns
endif()
if(TELEPALP_PCH AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Out of a precompiled header GCC 12 warns of copies within <string>, as it does not out of the same header parsed.
  target_compile_options(telepalp_flags INTERFACE -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
endif()
target_include_directories(telepalp_flags INTERFACE ${PROJECT_SOURCE_DIR})
if(TELEPALP_SANITIZE)
  # Without recovery, undefined behaviour ends the test that meets it: by default it is printed, and the test passes.
  add_compile_options(-fsanitize=${TELEPALP_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${TELEPALP_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-Wno-maybe-uninitialized)  # GCC bug 105562: instrumented, std::regex and std::optional warn
  endif()
  if(TELEPALP_SANITIZE MATCHES "thread" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-Wno-tsan)  # Asio has a fence, which tsan cannot see; its queues are also locked, which it sees
  endif()
endif()

# telepalp_doors([WHY "reason"] a.h sub/b.h …): the public headers of this folder. Files outside the folder may include
# these and no other header of it. WHY is needed for more than four. tests/architecture_test reads the lists and every
# #include.
function(telepalp_doors)
  cmake_parse_arguments(ARG "" "WHY" "" ${ARGN})
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE folder)
  set_property(GLOBAL APPEND PROPERTY TELEPALP_DOORS "room ${folder}")
  if(ARG_WHY)
    set_property(GLOBAL APPEND PROPERTY TELEPALP_DOORS "why ${folder}")
  endif()
  foreach(door ${ARG_UNPARSED_ARGUMENTS})
    if(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${door})
      message(FATAL_ERROR "telepalp_doors() in ${folder}/CMakeLists.txt names the header ${door}, which does not "
        "exist. fix: correct the name")
    endif()
    set_property(GLOBAL APPEND PROPERTY TELEPALP_DOORS "${folder} ${folder}/${door}")
  endforeach()
endfunction()

# Half of the compiler's time went into the headers of the standard library, Eigen and GoogleTest. Each is parsed once
# for the libraries and once for the tests. The list names system headers alone: a change of the repository's headers
# precompiles nothing again.
set(TELEPALP_COMMON_HEADERS <algorithm> <array> <atomic> <chrono> <cmath> <cstdint> <cstdio> <cstring> <deque>
  <filesystem> <fstream> <functional> <iterator> <limits> <map> <memory> <numbers> <numeric> <optional> <random> <set>
  <span> <sstream> <string> <string_view> <thread> <tuple> <utility> <variant> <vector> <Eigen/Core> <Eigen/Geometry>
  <google/protobuf/generated_message_util.h> <google/protobuf/generated_message_reflection.h>
  <google/protobuf/map.h> <google/protobuf/message.h> <google/protobuf/repeated_field.h>
  <google/protobuf/unknown_field_set.h>)

# telepalp_precompiled(NAME LIBRARY|TEST): lets a target use the precompiled headers of its kind.
function(telepalp_precompiled name kind)
  if(TELEPALP_PCH AND NOT TELEPALP_FUZZ)
    string(TOLOWER ${kind} kind)
    target_precompile_headers(${name} REUSE_FROM telepalp_${kind}_headers)
  endif()
endfunction()

# Called once, after the packages are found.
function(telepalp_make_precompiled_headers)
  if(NOT TELEPALP_PCH OR TELEPALP_FUZZ)
    return()
  endif()
  file(CONFIGURE OUTPUT precompiled.cpp CONTENT "int main() {}\n")
  add_library(telepalp_library_headers STATIC ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(telepalp_library_headers PRIVATE telepalp_flags Eigen3::Eigen protobuf::libprotobuf)
  target_precompile_headers(telepalp_library_headers PRIVATE ${TELEPALP_COMMON_HEADERS})
  if(TELEPALP_TESTS)
    add_executable(telepalp_test_headers EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/precompiled.cpp)
    target_link_libraries(telepalp_test_headers PRIVATE telepalp_flags Eigen3::Eigen protobuf::libprotobuf GTest::gtest)
    target_compile_options(telepalp_test_headers PRIVATE ${TELEPALP_TEST_OPTIMISATION})
    target_precompile_headers(telepalp_test_headers PRIVATE ${TELEPALP_COMMON_HEADERS} <gtest/gtest.h>)
  endif()
endfunction()

# Each source would read the repository's own headers again, which takes most of the time that precompiled system headers
# do not save. So eight sources of a target are compiled as one unit, and their names must differ, also in unnamed
# namespaces. A source with compile options of its own is compiled alone. BY_FOLDER: the sources of each folder are one
# unit, however many they are; so names need to differ only within a folder.
function(telepalp_together name)
  if(NOT TELEPALP_UNITY)
    return()
  endif()
  cmake_parse_arguments(ARG "BY_FOLDER" "" "" ${ARGN})
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  if(ARG_BY_FOLDER)
    get_target_property(sources ${name} SOURCES)
    foreach(source ${sources})
      cmake_path(GET source PARENT_PATH folder)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP "in_${folder}")
    endforeach()
    set_target_properties(${name} PROPERTIES UNITY_BUILD_MODE GROUP)
  endif()
endfunction()

# telepalp_library(NAME SOURCES a.cpp … LINKS targets …)
function(telepalp_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  telepalp_precompiled(${name} LIBRARY)
  telepalp_together(${name})
  target_link_libraries(${name} PUBLIC ${ARG_LINKS} PRIVATE telepalp_flags)
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
endfunction()

# Looked at in every build, and written only when the commit is another one.
set(TELEPALP_COMMIT_FILE ${PROJECT_BINARY_DIR}/commit.cpp)
add_custom_target(telepalp_commit BYPRODUCTS ${TELEPALP_COMMIT_FILE}
  COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DFILE=${TELEPALP_COMMIT_FILE}
    -P ${PROJECT_SOURCE_DIR}/cmake/write_commit.cmake
  VERBATIM COMMENT "Asking git for the commit that --version prints")

# telepalp_program(NAME SOURCES main.cpp … LINKS targets …): a program. Users' programs, which are those outside of
# tests/, are installed: TelepalpInstall.cmake names the package of each.
function(telepalp_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES} ${TELEPALP_COMMIT_FILE})
  telepalp_together(${name})
  set_source_files_properties(${TELEPALP_COMMIT_FILE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)  # changes at each commit
  add_dependencies(${name} telepalp_commit)
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} telepalp_flags)
  if(CMAKE_CURRENT_SOURCE_DIR MATCHES "^${PROJECT_SOURCE_DIR}/tests/")
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY TELEPALP_PROGRAMS ${name})
endfunction()

# telepalp_test(NAME [SERIAL] [WHOLE] [OPTIMISED] SOURCES a_test.cpp … LINKS targets … [NEEDS fixtures …]): one GoogleTest binary, one ctest
# entry for each test. SERIAL: the test tells of time and has the machine to itself (`ctest -LE timed` leaves it out).
# WHOLE: one ctest entry for the program, because its tests share what is expensive to start, such as running programs.
# NEEDS: ctest fixtures, such as npm_install_tests. OPTIMISED: compiled as the product is, for a test that measures, or
# whose own sources compute for long; the others are compiled quickly.
set(TELEPALP_TEST_OPTIMISATION $<$<CONFIG:Release>:-O1>)
function(telepalp_test name)
  cmake_parse_arguments(ARG "SERIAL;WHOLE;OPTIMISED" "" "SOURCES;LINKS;NEEDS" ${ARGN})
  if(NOT ARG_SERIAL)
    set(ARG_SERIAL FALSE)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  telepalp_together(${name})
  if(NOT ARG_OPTIMISED)
    target_compile_options(${name} PRIVATE ${TELEPALP_TEST_OPTIMISATION})
    telepalp_precompiled(${name} TEST)
  endif()
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} telepalp_flags GTest::gtest GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_BINARY_DIR}/where)  # where.h, from tests/support
  set(properties TIMEOUT 300 RUN_SERIAL ${ARG_SERIAL})
  if(ARG_SERIAL)
    list(APPEND properties LABELS timed)
  endif()
  if(ARG_NEEDS)
    list(APPEND properties FIXTURES_REQUIRED ${ARG_NEEDS})
  endif()
  if(ARG_WHOLE)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES ${properties})
    return()
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
endfunction()
