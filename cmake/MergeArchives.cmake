# One static library from many.
#
#   shoal_merge_archives(NAME TARGET FILE)
#
# makes FILE from TARGET and all static libraries of the project that it links, and a target NAME
# that builds it.

# Appends the static libraries that `target` links, itself included, to the list `out`.
function(shoal_static_closure target out)
  set(found ${${out}})
  if(NOT TARGET ${target} OR target IN_LIST found)
    return()
  endif()
  get_target_property(imported ${target} IMPORTED)
  get_target_property(alias ${target} ALIASED_TARGET)
  if(imported OR alias)
    return()
  endif()
  list(APPEND found ${target})
  get_target_property(libraries ${target} INTERFACE_LINK_LIBRARIES)
  foreach(library IN LISTS libraries)
    # Of PRIVATE dependencies: $<LINK_ONLY:name>.
    string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" library "${library}")
    shoal_static_closure(${library} found)
  endforeach()
  set(${out} ${found} PARENT_SCOPE)
endfunction()

function(shoal_merge_archives name target file)
  set(closure "")
  shoal_static_closure(${target} closure)
  set(script "create ${file}\n")
  set(archives "")
  foreach(each IN LISTS closure)
    get_target_property(type ${each} TYPE)
    if(type STREQUAL STATIC_LIBRARY)
      list(APPEND archives ${each})
      string(APPEND script "addlib $<TARGET_FILE:${each}>\n")
    endif()
  endforeach()
  string(APPEND script "save\nend\n")
  file(GENERATE OUTPUT ${file}.mri CONTENT "${script}")
  add_custom_command(OUTPUT ${file}
    COMMAND ${CMAKE_COMMAND} -E rm -f ${file}
    COMMAND sh -c "${CMAKE_AR} -M < ${file}.mri"
    DEPENDS ${archives} ${file}.mri VERBATIM
    COMMENT "Merging ${file}")
  add_custom_target(${name} ALL DEPENDS ${file})
endfunction()
