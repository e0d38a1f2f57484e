# The headers of shoal that a program outside may include.
#
#   shoal_public_headers(OUT sim/simulation.h lib/mission/model/mission.h ...)
#
# sets OUT to these headers and all that they include by "quotes", as paths in the source folder.
# Those of generated message types are left out.

function(shoal_public_headers out)
  set(open ${ARGN})
  set(found "")
  while(open)
    list(POP_FRONT open header)
    if(header IN_LIST found OR NOT EXISTS ${CMAKE_SOURCE_DIR}/${header})
      continue()
    endif()
    list(APPEND found ${header})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${header})
    file(STRINGS ${CMAKE_SOURCE_DIR}/${header} lines REGEX "^#include \"[^\"]+\"")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included "${line}")
      list(APPEND open ${included})
    endforeach()
  endwhile()
  list(SORT found)
  set(${out} ${found} PARENT_SCOPE)
endfunction()
