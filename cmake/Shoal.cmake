# The three functions that every target of shoal is made with.
#
#   shoal_library(NAME [PURE] SOURCES a.cc ... DEPENDS other_lib Eigen3::Eigen ...
#                 TESTS a_test.cc ... [TEST_DEPENDS lib ...])
#   shoal_app(NAME SOURCES x_app.cc ... DEPENDS lib ... TESTS x_app_test.cc ...)
#   shoal_test(NAME SOURCES x_test.cc ... DEPENDS lib ...)
#
# A PURE library may depend on other PURE libraries and on the numeric libraries listed in
# SHOAL_PURE_EXTERNALS, and on nothing else: anything more fails here, at configure time.
# shoal_app makes a library <NAME>_app from SOURCES and, from <NAME>_main.cc, the executable.

find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
if(SHOAL_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
  find_package(benchmark REQUIRED)
  include(GoogleTest)
endif()

find_path(GEOGRAPHICLIB_INCLUDE_DIR GeographicLib/LocalCartesian.hpp REQUIRED)
find_library(GEOGRAPHICLIB_LIBRARY NAMES GeographicLib Geographic REQUIRED)
add_library(shoal_geographiclib INTERFACE)
target_include_directories(shoal_geographiclib SYSTEM INTERFACE ${GEOGRAPHICLIB_INCLUDE_DIR})
target_link_libraries(shoal_geographiclib INTERFACE ${GEOGRAPHICLIB_LIBRARY})

find_path(RANDOM123_INCLUDE_DIR Random123/philox.h REQUIRED)
add_library(shoal_random123 INTERFACE)
target_include_directories(shoal_random123 SYSTEM INTERFACE ${RANDOM123_INCLUDE_DIR})

set(SHOAL_PURE_EXTERNALS Eigen3::Eigen shoal_geographiclib shoal_random123)

# Flags of our own targets; generated code and tests' frameworks come in as SYSTEM includes.
add_library(shoal_flags INTERFACE)
target_compile_options(shoal_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -ffp-contract=off
  # g++ 12 warns of overlapping copies inside std::string operator+ where there are none (GCC bug
  # 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
target_include_directories(shoal_flags INTERFACE ${CMAKE_SOURCE_DIR})
if(SHOAL_SANITIZE)
  add_compile_options(-fsanitize=${SHOAL_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${SHOAL_SANITIZE})
  # With sanitizers, g++ 12 sees uninitialized members inside <functional> and <regex>.
  target_compile_options(shoal_flags INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  if(SHOAL_SANITIZE MATCHES undefined)
    add_compile_options(-fno-sanitize-recover=undefined)
  endif()
endif()

function(shoal_library name)
  cmake_parse_arguments(ARG "PURE" "" "SOURCES;DEPENDS;TESTS;TEST_DEPENDS" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "shoal_library(${name}): unknown arguments ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  if(ARG_PURE)
    foreach(dependency IN LISTS ARG_DEPENDS)
      if(dependency IN_LIST SHOAL_PURE_EXTERNALS)
        continue()
      endif()
      set(is_pure FALSE)
      if(TARGET ${dependency})
        get_target_property(is_pure ${dependency} SHOAL_PURE)
      endif()
      if(NOT is_pure)
        message(FATAL_ERROR "shoal_library(${name} PURE) depends on ${dependency}, which is "
          "neither a pure library nor in SHOAL_PURE_EXTERNALS (cmake/Shoal.cmake)")
      endif()
    endforeach()
  endif()
  if(ARG_SOURCES)
    add_library(${name} STATIC ${ARG_SOURCES})
    target_link_libraries(${name} PUBLIC ${ARG_DEPENDS} PRIVATE shoal_flags)
    target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR})
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE ${ARG_DEPENDS})
    target_include_directories(${name} INTERFACE ${CMAKE_SOURCE_DIR})
  endif()
  set_target_properties(${name} PROPERTIES SHOAL_PURE "${ARG_PURE}")
  if(ARG_TESTS)
    shoal_test(${name}_test SOURCES ${ARG_TESTS} DEPENDS ${name} ${ARG_TEST_DEPENDS})
  endif()
endfunction()

function(shoal_app name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;TESTS;TEST_DEPENDS" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "shoal_app(${name}): unknown arguments ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  shoal_library(${name}_app SOURCES ${ARG_SOURCES} DEPENDS ${ARG_DEPENDS}
    TESTS ${ARG_TESTS} TEST_DEPENDS ${ARG_TEST_DEPENDS})
  add_executable(${name} ${name}_main.cc)
  target_link_libraries(${name} PRIVATE ${name}_app shoal_flags)
endfunction()

function(shoal_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  if(NOT SHOAL_TESTS)
    return()
  endif()
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} shoal_flags GTest::gtest_main
    rapidcheck rapidcheck_gtest)
  target_compile_definitions(${name} PRIVATE
    SHOAL_SOURCE_DIR="${CMAKE_SOURCE_DIR}" SHOAL_BINARY_DIR="${CMAKE_BINARY_DIR}")
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 DISCOVERY_MODE PRE_TEST)
endfunction()
