# The three functions that every target of shoal is made with.
#
#   shoal_library(NAME SOURCES a.cc ... DEPENDS other_lib Eigen3::Eigen ...
#                 TESTS a_test.cc ... [TEST_DEPENDS lib ...])
#   shoal_app(NAME RUN Function SOURCES x_app.cc ... DEPENDS lib ... TESTS x_app_test.cc ...)
#   shoal_test(NAME SOURCES x_test.cc ... DEPENDS lib ...
#              [LABEL unit|process|browser|slurm|bench-smoke] [TIMEOUT seconds] [SERIAL])
#
# A library belongs to the floor of its folder, lib/<floor>/<room>. It may depend on its own floor and
# on those before it in SHOAL_FLOORS; on the pure floors, beside these, on the numeric libraries of
# SHOAL_PURE_EXTERNALS and on nothing else. Anything more fails here, at configure time.
# scripts/floors holds every #include against the same order.
# shoal_app makes a library <NAME>_app from SOURCES and the executable, whose main function calls
# `int shoal::Function(int argc, char** argv)` of the library.
#
# What builds fast is chosen by the preset (CMakePresets.json, docs/inside/building.md): precompiled
# headers (SHOAL_PCH), one translation unit per library (CMAKE_UNITY_BUILD), shared libraries
# (BUILD_SHARED_LIBS). Every test has a label and a time limit in seconds, for one test case.

# From the bottom: a floor knows those before it.
set(SHOAL_PURE_FLOORS base sea vehicle helm comms)
set(SHOAL_FLOORS ${SHOAL_PURE_FLOORS} bus mission run tools)

set(SHOAL_TEST_LABELS unit process browser slurm bench-smoke)

find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(EXPAT REQUIRED)
if(SHOAL_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
  find_package(benchmark REQUIRED)
  include(GoogleTest)
endif()

find_path(RANDOM123_INCLUDE_DIR Random123/philox.h REQUIRED)
add_library(shoal_random123 INTERFACE)
target_include_directories(shoal_random123 SYSTEM INTERFACE ${RANDOM123_INCLUDE_DIR})

find_path(SODIUM_INCLUDE_DIR sodium.h REQUIRED)
find_library(SODIUM_LIBRARY sodium REQUIRED)
add_library(shoal_sodium INTERFACE)
target_include_directories(shoal_sodium SYSTEM INTERFACE ${SODIUM_INCLUDE_DIR})
target_link_libraries(shoal_sodium INTERFACE ${SODIUM_LIBRARY})

find_path(ZMQ_INCLUDE_DIR zmq.hpp REQUIRED)
find_library(ZMQ_LIBRARY zmq REQUIRED)
add_library(shoal_zmq INTERFACE)
target_include_directories(shoal_zmq SYSTEM INTERFACE ${ZMQ_INCLUDE_DIR})
target_link_libraries(shoal_zmq INTERFACE ${ZMQ_LIBRARY})

find_path(SQLITE_INCLUDE_DIR sqlite3.h REQUIRED)
find_library(SQLITE_LIBRARY sqlite3 REQUIRED)
add_library(shoal_sqlite INTERFACE)
target_include_directories(shoal_sqlite SYSTEM INTERFACE ${SQLITE_INCLUDE_DIR})
target_link_libraries(shoal_sqlite INTERFACE ${SQLITE_LIBRARY})

find_path(ZSTD_INCLUDE_DIR zstd.h REQUIRED)
find_library(ZSTD_LIBRARY zstd REQUIRED)
add_library(shoal_zstd INTERFACE)
target_include_directories(shoal_zstd SYSTEM INTERFACE ${ZSTD_INCLUDE_DIR})
target_link_libraries(shoal_zstd INTERFACE ${ZSTD_LIBRARY})

set(SHOAL_PURE_EXTERNALS Eigen3::Eigen shoal_geographiclib shoal_musl shoal_random123)

# Flags of our own targets; generated code and tests' frameworks come in as SYSTEM includes.
add_library(shoal_flags INTERFACE)
target_compile_options(shoal_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
  # The same bits on every processor: nothing fused, and char as on x86.
  -ffp-contract=off -fsigned-char
  # g++ 12 warns of overlapping copies inside std::string operator+ where there are none (GCC bug
  # 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# Eigen's vectors add in another order on each processor, and fuse where that can.
target_compile_definitions(shoal_flags INTERFACE EIGEN_DONT_VECTORIZE)
target_include_directories(shoal_flags INTERFACE ${CMAKE_SOURCE_DIR})
# g++ collects its garbage less often: 200 MB more for the largest sources, a twelfth less time.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  target_compile_options(shoal_flags INTERFACE
    "SHELL:--param ggc-min-expand=300" "SHELL:--param ggc-min-heapsize=400000")
endif()
if(SHOAL_SANITIZE)
  add_compile_options(-fsanitize=${SHOAL_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${SHOAL_SANITIZE})
  # With sanitizers, g++ 12 sees uninitialized members inside <functional> and <regex>.
  target_compile_options(shoal_flags INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  if(SHOAL_SANITIZE MATCHES undefined)
    # LCM's own header copies no bytes from a null pointer, of empty arrays.
    add_compile_options(-fno-sanitize-recover=undefined -fno-sanitize=nonnull-attribute)
  endif()
endif()

# A linker from Debian that is several times as fast, where it is there.
find_program(SHOAL_FAST_LINKER NAMES mold ld.lld)
if(SHOAL_FAST_LINKER MATCHES "mold$")
  add_link_options(-fuse-ld=mold)
elseif(SHOAL_FAST_LINKER)
  add_link_options(-fuse-ld=lld)
endif()

# Every library can become part of libshoal_sim.so (sim/), hence position-independent; what is in
# a library calls its own functions directly all the same.
set(SHOAL_LIBRARY_OPTIONS -fno-semantic-interposition)

# What works once in a mission, at the speed of people, or little in a step: built with
# SHOAL_BRIEF_OPTIONS, since a user waits for its build longer than for it. Floors, rooms of lib/, and
# folders.
set(SHOAL_BRIEF mission run/command_line run/hosts run/launch run/moos_text run/orders run/run
  tools/analysis tools/page tools/report tools/view apps/gateway apps/netsim_manager apps/recorder
  apps/shoal apps/shoal_campaign apps/shoal_encounters apps/shoal_import apps/shoal_log
  apps/shoal_log_export apps/shoal_play apps/shoal_plot apps/shoal_rays apps/shoal_rebroker apps/viewer sim)
foreach(brief IN LISTS SHOAL_BRIEF)
  if(NOT IS_DIRECTORY ${PROJECT_SOURCE_DIR}/lib/${brief} AND NOT IS_DIRECTORY
     ${PROJECT_SOURCE_DIR}/${brief})
    message(FATAL_ERROR "cmake/Shoal.cmake: SHOAL_BRIEF names ${brief}, but there is no such folder")
  endif()
endforeach()

# Precompiled headers: of the pure floors and the bus, without what a pure library may not include
# (fmt, a mission); of what every step of a mission runs; and of what is brief. To read what a mission
# is takes two seconds. Whatever is compiled with such headers takes over their optimisation, whatever
# its own options are: hence a kind of headers for each.
set(SHOAL_PCH_PURE <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory>
  <optional> <set> <span> <string> <string_view> <utility> <variant> <vector> <Eigen/Core>)
set(SHOAL_PCH_STEP ${SHOAL_PCH_PURE} <fmt/format.h> <lib/bus/bus/bus.h>
  <lib/mission/model/mission.h>)
set(SHOAL_PCH_BRIEF ${SHOAL_PCH_STEP})
set(SHOAL_PCH_TEST ${SHOAL_PCH_PURE} <fmt/format.h> <gtest/gtest.h> <rapidcheck/gtest.h>)

# Makes the target that holds the precompiled headers of one kind (pure, step, brief, test), which
# are compiled with OPTIONS. DEPENDS: where they come from.
function(shoal_precompiled_headers kind)
  cmake_parse_arguments(ARG "" "" "OPTIONS;DEPENDS" ${ARGN})
  set(source ${CMAKE_BINARY_DIR}/gen/pch_${kind}.cc)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Holds the precompiled headers.\n")
  add_library(shoal_pch_${kind} OBJECT ${source})
  string(TOUPPER ${kind} upper)
  target_precompile_headers(shoal_pch_${kind} PRIVATE ${SHOAL_PCH_${upper}})
  target_link_libraries(shoal_pch_${kind} PRIVATE shoal_flags Eigen3::Eigen ${ARG_DEPENDS})
  target_compile_options(shoal_pch_${kind} PRIVATE ${ARG_OPTIONS})
  set_target_properties(shoal_pch_${kind} PROPERTIES UNITY_BUILD OFF)
endfunction()

if(SHOAL_PCH)
  shoal_precompiled_headers(pure OPTIONS ${SHOAL_LIBRARY_OPTIONS})
  shoal_precompiled_headers(step OPTIONS ${SHOAL_LIBRARY_OPTIONS} ${SHOAL_STEP_OPTIONS}
    DEPENDS fmt::fmt shoal_lcmtypes)
  shoal_precompiled_headers(brief OPTIONS ${SHOAL_LIBRARY_OPTIONS} ${SHOAL_BRIEF_OPTIONS}
    DEPENDS fmt::fmt shoal_lcmtypes)
  set_target_properties(shoal_pch_pure shoal_pch_step shoal_pch_brief PROPERTIES
    POSITION_INDEPENDENT_CODE ON)
  if(SHOAL_TESTS)
    shoal_precompiled_headers(test OPTIONS ${SHOAL_TEST_OPTIONS}
      DEPENDS fmt::fmt GTest::gtest rapidcheck rapidcheck_gtest)
  endif()
endif()

# Gives a target the options and the precompiled headers of its kind.
function(shoal_compile_as_its_kind target)
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${CMAKE_SOURCE_DIR}
    OUTPUT_VARIABLE folder)
  string(REGEX REPLACE "^lib/" "" room "${folder}")
  string(REGEX REPLACE "/.*" "" floor "${room}")
  set(kind step)
  if(floor IN_LIST SHOAL_PURE_FLOORS OR floor STREQUAL bus)
    set(kind pure)
  elseif(floor IN_LIST SHOAL_BRIEF OR room IN_LIST SHOAL_BRIEF)
    set(kind brief)
    target_compile_options(${target} PRIVATE ${SHOAL_BRIEF_OPTIONS})
  else()
    target_compile_options(${target} PRIVATE ${SHOAL_STEP_OPTIONS})
  endif()
  target_compile_options(${target} PRIVATE ${SHOAL_LIBRARY_OPTIONS})
  # The rooms for files that are below a mission do not know its names.
  if(SHOAL_PCH AND (NOT floor STREQUAL mission OR room STREQUAL mission/file))
    target_precompile_headers(${target} REUSE_FROM shoal_pch_${kind})
    if(NOT kind STREQUAL pure)
      target_link_libraries(${target} PRIVATE Eigen3::Eigen fmt::fmt shoal_lcmtypes)
    endif()
  endif()
endfunction()

# Fails where a library of `floor` depends on what it may not know.
function(shoal_check_floor name floor)
  list(FIND SHOAL_FLOORS ${floor} own_height)
  foreach(dependency IN LISTS ARGN)
    set(its_floor "")
    if(TARGET ${dependency})
      get_target_property(its_floor ${dependency} SHOAL_FLOOR)
    endif()
    list(FIND SHOAL_FLOORS "${its_floor}" its_height)
    if(its_height GREATER own_height)
      message(FATAL_ERROR "shoal_library(${name}) is on the floor ${floor} and depends on "
        "${dependency}, which is above it, on the floor ${its_floor} (lib/README.md)")
    elseif(its_height EQUAL -1 AND floor IN_LIST SHOAL_PURE_FLOORS
           AND NOT dependency IN_LIST SHOAL_PURE_EXTERNALS)
      message(FATAL_ERROR "shoal_library(${name}) is on the pure floor ${floor} and depends on "
        "${dependency}, which is neither a library of a pure floor, added before it, nor in "
        "SHOAL_PURE_EXTERNALS (cmake/Shoal.cmake)")
    endif()
  endforeach()
endfunction()

# Fails where a program or a library links, itself or by others, what is of `floor`.
function(shoal_check_without_floor floor)
  set(open ${ARGN})
  foreach(target IN LISTS ARGN)
    set(by_${target} ${target})
  endforeach()
  set(seen "")
  while(NOT open STREQUAL "")
    list(POP_FRONT open target)
    if(target IN_LIST seen OR NOT TARGET ${target})
      continue()
    endif()
    list(APPEND seen ${target})
    get_target_property(its_floor ${target} SHOAL_FLOOR)
    if(its_floor STREQUAL floor)
      message(FATAL_ERROR "${by_${target}}: links what is of the floor ${floor}, which is for "
        "programs of their own (docs/inside/building.md)")
    endif()
    get_target_property(linked ${target} INTERFACE_LINK_LIBRARIES)
    get_target_property(own ${target} LINK_LIBRARIES)
    foreach(dependency IN LISTS linked own)
      string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" dependency "${dependency}")
      if(NOT DEFINED by_${dependency})
        set(by_${dependency} "${by_${target}} > ${dependency}")
      endif()
      list(APPEND open ${dependency})
    endforeach()
  endwhile()
endfunction()

function(shoal_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;TESTS;TEST_DEPENDS" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "shoal_library(${name}): unknown arguments ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${CMAKE_SOURCE_DIR}/lib
    OUTPUT_VARIABLE room)
  string(REGEX REPLACE "/.*" "" floor "${room}")
  if(floor IN_LIST SHOAL_FLOORS)
    shoal_check_floor(${name} ${floor} ${ARG_DEPENDS})
  endif()
  if(ARG_SOURCES)
    add_library(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PUBLIC ${ARG_DEPENDS} PRIVATE shoal_flags)
    target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR})
    set_target_properties(${name} PROPERTIES OUTPUT_NAME shoal_${name} DEFINE_SYMBOL ""
      POSITION_INDEPENDENT_CODE ON)
    shoal_compile_as_its_kind(${name})
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE ${ARG_DEPENDS})
    target_include_directories(${name} INTERFACE ${CMAKE_SOURCE_DIR})
  endif()
  set_target_properties(${name} PROPERTIES SHOAL_FLOOR "${floor}")
  if(ARG_TESTS)
    shoal_test(${name}_test SOURCES ${ARG_TESTS} DEPENDS ${name} ${ARG_TEST_DEPENDS})
  endif()
endfunction()

function(shoal_app name)
  cmake_parse_arguments(ARG "" "RUN" "SOURCES;DEPENDS;TESTS;TEST_DEPENDS" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS OR NOT ARG_RUN)
    message(FATAL_ERROR "shoal_app(${name}): RUN is missing, or unknown: ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  shoal_library(${name}_app SOURCES ${ARG_SOURCES} DEPENDS ${ARG_DEPENDS}
    TESTS ${ARG_TESTS} TEST_DEPENDS ${ARG_TEST_DEPENDS})
  # A main that includes nothing compiles in no time.
  set(main ${CMAKE_BINARY_DIR}/gen/${name}_main.cc)
  configure_file(${CMAKE_SOURCE_DIR}/apps/main.cc.in ${main} @ONLY)
  add_executable(${name} ${main})
  target_link_libraries(${name} PRIVATE ${name}_app shoal_flags)
endfunction()

function(shoal_test name)
  cmake_parse_arguments(ARG "SERIAL" "LABEL;TIMEOUT" "SOURCES;DEPENDS" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "shoal_test(${name}): unknown arguments ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT SHOAL_TESTS)
    return()
  endif()
  if(NOT ARG_LABEL)
    set(ARG_LABEL unit)
  endif()
  if(NOT ARG_LABEL IN_LIST SHOAL_TEST_LABELS)
    message(FATAL_ERROR "shoal_test(${name}): LABEL is one of ${SHOAL_TEST_LABELS}")
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  if(SHOAL_SANITIZE)
    math(EXPR ARG_TIMEOUT "5 * ${ARG_TIMEOUT}")
  endif()
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests
    UNITY_BUILD_BATCH_SIZE ${SHOAL_TEST_BATCH})
  if(NOT TARGET property_seed)
    add_library(property_seed OBJECT ${CMAKE_SOURCE_DIR}/tests/property_seed.cc)
    target_link_libraries(property_seed PRIVATE shoal_flags)
  endif()
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} shoal_flags GTest::gtest_main
    rapidcheck rapidcheck_gtest property_seed)
  target_compile_definitions(${name} PRIVATE
    SHOAL_SOURCE_DIR="${CMAKE_SOURCE_DIR}" SHOAL_BINARY_DIR="${CMAKE_BINARY_DIR}")
  target_compile_options(${name} PRIVATE ${SHOAL_TEST_OPTIONS})
  if(SHOAL_PCH)
    target_precompile_headers(${name} REUSE_FROM shoal_pch_test)
    target_link_libraries(${name} PRIVATE fmt::fmt)
  endif()
  set(properties LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT})
  if(ARG_SERIAL)
    list(APPEND properties RUN_SERIAL TRUE)
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 DISCOVERY_MODE PRE_TEST
    PROPERTIES ${properties})
endfunction()
