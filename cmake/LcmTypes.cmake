# Finds Debian's LCM (it ships no CMake files, and its lcm.pc asks for glib headers that nothing
# needs) and turns lcmtypes/*.lcm into C++, C and, where a JDK is there, Java.
#
#   shoal_lcm_types(shoal_a_t.lcm shoal_b_t.lcm ...)
#
# makes   shoal_lcmtypes    C++ headers <shoal/a_t.hpp>; generated, hence SYSTEM
#         shoal_lcmtypes_c  C types <shoal_a_t.h>, for programs outside the C++ tree
#         shoal_types_jar   build/shoal_types.jar, for lcm-spy and Java programs

find_program(LCM_GEN lcm-gen REQUIRED)
find_path(LCM_INCLUDE_DIR lcm/lcm-cpp.hpp REQUIRED)
find_library(LCM_LIBRARY lcm REQUIRED)
find_file(LCM_JAR lcm.jar PATHS /usr/share/java NO_CMAKE_FIND_ROOT_PATH)
find_program(JAVAC javac)
find_program(JAR jar)

add_library(shoal_lcm INTERFACE)
target_include_directories(shoal_lcm SYSTEM INTERFACE ${LCM_INCLUDE_DIR})
target_link_libraries(shoal_lcm INTERFACE ${LCM_LIBRARY} Threads::Threads)

function(shoal_lcm_types)
  set(cpp_dir ${CMAKE_BINARY_DIR}/gen/cpp)
  set(c_dir ${CMAKE_BINARY_DIR}/gen/c)
  set(java_dir ${CMAKE_BINARY_DIR}/gen/java)
  file(MAKE_DIRECTORY ${cpp_dir} ${c_dir} ${java_dir})
  foreach(file IN LISTS ARGN)
    string(REGEX REPLACE "^shoal_(.*)\\.lcm$" "\\1" type ${file})
    set(source ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    add_custom_command(OUTPUT ${cpp_dir}/shoal/${type}.hpp
      COMMAND ${LCM_GEN} --cpp --cpp-std c++11 --cpp-hpath ${cpp_dir} ${source}
      DEPENDS ${source} VERBATIM)
    add_custom_command(OUTPUT ${c_dir}/shoal_${type}.c ${c_dir}/shoal_${type}.h
      COMMAND ${LCM_GEN} --c --c-cpath ${c_dir} --c-hpath ${c_dir} ${source}
      DEPENDS ${source} VERBATIM)
    list(APPEND headers ${cpp_dir}/shoal/${type}.hpp)
    list(APPEND c_sources ${c_dir}/shoal_${type}.c)
    list(APPEND sources ${source})
  endforeach()

  add_custom_target(shoal_lcmtypes_gen DEPENDS ${headers})
  add_library(shoal_lcmtypes INTERFACE)
  target_include_directories(shoal_lcmtypes SYSTEM INTERFACE ${cpp_dir})
  target_link_libraries(shoal_lcmtypes INTERFACE shoal_lcm)
  add_dependencies(shoal_lcmtypes shoal_lcmtypes_gen)

  add_library(shoal_lcmtypes_c STATIC ${c_sources})
  target_include_directories(shoal_lcmtypes_c SYSTEM PUBLIC ${c_dir})
  target_link_libraries(shoal_lcmtypes_c PUBLIC shoal_lcm)
  # Sixty types, which programs outside the C++ tree take.
  target_compile_options(shoal_lcmtypes_c PRIVATE ${SHOAL_BRIEF_OPTIONS})

  # The text of every type, for tools that print messages without knowing them beforehand.
  set(embedded ${CMAKE_BINARY_DIR}/gen/lcm_sources.cc)
  add_custom_command(OUTPUT ${embedded}
    COMMAND ${CMAKE_COMMAND} "-DOUTPUT=${embedded}" "-DFILES=${sources}"
      -P ${CMAKE_SOURCE_DIR}/cmake/EmbedLcmSources.cmake
    DEPENDS ${sources} ${CMAKE_SOURCE_DIR}/cmake/EmbedLcmSources.cmake VERBATIM)
  add_library(shoal_lcm_sources STATIC ${embedded})
  target_include_directories(shoal_lcm_sources PUBLIC ${CMAKE_SOURCE_DIR})
  set_target_properties(shoal_lcm_sources shoal_lcmtypes_c PROPERTIES POSITION_INDEPENDENT_CODE ON)

  if(JAVAC AND JAR AND LCM_JAR)
    set(jar_file ${CMAKE_BINARY_DIR}/shoal_types.jar)
    add_custom_command(OUTPUT ${jar_file}
      COMMAND ${CMAKE_COMMAND} -E rm -rf ${java_dir}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${java_dir}/classes
      COMMAND ${LCM_GEN} --java --jpath ${java_dir}/src ${sources}
      COMMAND sh -c "${JAVAC} --release 11 -cp ${LCM_JAR} -d ${java_dir}/classes ${java_dir}/src/shoal/*.java"
      COMMAND ${JAR} cf ${jar_file} -C ${java_dir}/classes .
      DEPENDS ${sources} VERBATIM)
    add_custom_target(shoal_types_jar ALL DEPENDS ${jar_file})
  else()
    message(STATUS "No JDK or no lcm.jar: lcm-spy will not decode shoal's types "
      "(apt-get install default-jdk-headless liblcm-java)")
  endif()
endfunction()
