# Embeds the modems of a folder into the library that reads mission files, so that programs find
# them wherever they are installed.
#
#   include(EmbedModems)
#   shoal_embed_modems(OUT_VARIABLE ${CMAKE_SOURCE_DIR}/data/modems)
#
# sets OUT_VARIABLE to a generated source file that defines shoal::OwnModems()
# (lib/mission/file/own_modems.h). As a script (cmake -P) this file writes it.

if(CMAKE_SCRIPT_MODE_FILE)
  set(table "")
  foreach(file IN LISTS FILES)
    get_filename_component(name ${file} NAME_WE)
    file(READ ${file} text)
    string(APPEND table "    {\"${name}\", R\"toml(${text})toml\"},\n")
  endforeach()
  file(WRITE ${OUT}
    "// Made by cmake/EmbedModems.cmake.\n"
    "#include \"lib/mission/file/own_modems.h\"\n\n"
    "namespace shoal {\n\nnamespace {\n\nconst OwnModem kOwnModems[] = {\n${table}};\n\n"
    "}  // namespace\n\n"
    "std::span<const OwnModem> OwnModems() { return kOwnModems; }\n\n}  // namespace shoal\n")
  return()
endif()

set(SHOAL_EMBED_MODEMS_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(shoal_embed_modems out_variable folder)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.toml)
  list(SORT files)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/own_modems.cc)
  add_custom_command(OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} "-DFILES=${files}" -DOUT=${out} -P ${SHOAL_EMBED_MODEMS_SCRIPT}
    DEPENDS ${files} ${SHOAL_EMBED_MODEMS_SCRIPT} VERBATIM
    COMMENT "Embedding ${folder}")
  add_custom_target(own_modems DEPENDS ${out})  # For scripts/tidy.
  set(${out_variable} ${out} PARENT_SCOPE)
endfunction()
