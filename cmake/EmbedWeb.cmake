# Embeds the files of a folder into a program.
#
#   include(EmbedWeb)
#   shoal_embed_web(OUT_VARIABLE ${CMAKE_SOURCE_DIR}/web)
#   shoal_embed_files(OUT_VARIABLE EmbeddedPage lib/tools/report/embedded_page.h
#     ${CMAKE_SOURCE_DIR}/web page/dom.js campaign/report.js)
#
# sets OUT_VARIABLE to a generated source file that defines shoal::EmbeddedWeb()
# (apps/viewer/embedded_web.h), or the function that a header declares. It is written again when a
# file changes, comes or goes. The target `embedded_web` (the header's name) makes the file alone; a
# library's own commands wait for all that it links. As a script (cmake -P) this file writes it.

if(CMAKE_SCRIPT_MODE_FILE)
  set(arrays "")
  set(table "")
  file(STRINGS ${LIST} names)
  set(number 0)
  foreach(name IN LISTS names)
    file(READ ${FOLDER}/${name} hex HEX)
    string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," hex "${hex}")
    # An empty array is not C++; the size gives how much of it counts.
    string(APPEND arrays "const unsigned char kFile${number}[] = {\n${hex}0};\n")
    string(APPEND table
      "    {\"/${name}\", {kFile${number}, sizeof kFile${number} - 1}},\n")
    math(EXPR number "${number} + 1")
  endforeach()
  file(WRITE ${OUT}
    "// Made by cmake/EmbedWeb.cmake.\n"
    "#include \"${HEADER}\"\n\n"
    "namespace shoal {\n\nnamespace {\n\n${arrays}\n"
    "const EmbeddedFile kFiles[] = {\n${table}};\n\n}  // namespace\n\n"
    "std::span<const EmbeddedFile> ${FUNCTION}() { return kFiles; }\n\n"
    "}  // namespace shoal\n")
  return()
endif()

set(SHOAL_EMBED_WEB_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(shoal_embed_files out_variable function header folder)
  cmake_path(GET header STEM name)
  set(list ${CMAKE_CURRENT_BINARY_DIR}/${name}.list)
  string(REPLACE ";" "\n" lines "${ARGN}")
  file(CONFIGURE OUTPUT ${list} CONTENT "${lines}\n" @ONLY)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${name}.cc)
  list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE paths)
  add_custom_command(OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DLIST=${list} -DOUT=${out}
      -DFUNCTION=${function} -DHEADER=${header} -P ${SHOAL_EMBED_WEB_SCRIPT}
    DEPENDS ${paths} ${list} ${SHOAL_EMBED_WEB_SCRIPT}
    COMMENT "Embedding ${folder}")
  add_custom_target(${name} DEPENDS ${out})
  set(${out_variable} ${out} PARENT_SCOPE)
endfunction()

function(shoal_embed_web out_variable folder)
  # The endings that ContentTypeOf knows (apps/viewer/page_files.cc).
  set(patterns)
  foreach(ending html js css json svg txt png)
    list(APPEND patterns ${folder}/*.${ending})
  endforeach()
  file(GLOB_RECURSE files CONFIGURE_DEPENDS LIST_DIRECTORIES false RELATIVE ${folder} ${patterns})
  # The page of a campaign is a file, not served (lib/tools/report/report_page.h).
  list(FILTER files EXCLUDE REGEX "^campaign/")
  list(SORT files)
  if(NOT "index.html" IN_LIST files)
    message(FATAL_ERROR "${folder} holds no index.html")
  endif()
  shoal_embed_files(out EmbeddedWeb apps/viewer/embedded_web.h ${folder} ${files})
  set(${out_variable} ${out} PARENT_SCOPE)
endfunction()
