# What `cmake --install` and scripts/package put below the prefix; docs/start/install.md shows it.
include(MergeArchives)
include(PublicHeaders)

if(BUILD_SHARED_LIBS)
  message(STATUS "Shared libraries: nothing to install (the preset release has static ones)")
  return()
endif()

set(SHOAL_PYTHON_DIR lib/python3/dist-packages CACHE STRING
  "Where the Python package is installed, below the prefix")
# `cmake --install` and CPack install what is built, and do not build the tests first.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

set(programs_dir lib/shoal/bin)
set(share_dir share/shoal)
set(staging ${CMAKE_BINARY_DIR}/install)

# The programs, each beside the others, which is where `shoal run` looks for them. On the PATH they
# have names of their own: `helm` is the name of another program too. The tools, commands of `shoal`
# that are programs of their own, are not on the PATH: `shoal` starts them.
set(tools shoal_campaign shoal_encounters shoal_import shoal_log shoal_log_export shoal_play shoal_plot shoal_rays shoal_rebroker)
set(apps acomms gateway helm netsim_manager node_reporter recorder shore_broker vehicle_sim)
set(examples acoustic_ping c_listener c_planner netsim_outsider netsim_raw_modem referee)
install(TARGETS shoal viewer ${tools} ${apps} ${examples} RUNTIME DESTINATION ${programs_dir})
# Run by the others, never by a user: it has no name on the PATH.
if(TARGET netcdf_reader)
  install(TARGETS netcdf_reader RUNTIME DESTINATION ${programs_dir})
endif()
function(shoal_link_program name program)
  file(MAKE_DIRECTORY ${staging}/bin)
  file(CREATE_LINK ../${programs_dir}/${program} ${staging}/bin/${name} SYMBOLIC)
  install(FILES ${staging}/bin/${name} DESTINATION bin)
endfunction()
shoal_link_program(shoal shoal)
shoal_link_program(shoal-viewer shoal-viewer)
set(manual_pages shoal=shoal shoal-viewer=shoal-viewer)
foreach(app IN LISTS apps)
  string(REPLACE _ - name shoal-${app})
  shoal_link_program(${name} ${app})
  list(APPEND manual_pages ${name}=${app})
endforeach()

# Missions, campaigns, examples, data, message types, documentation.
foreach(folder missions campaigns data lcmtypes)
  install(DIRECTORY ${folder} DESTINATION ${share_dir} FILES_MATCHING
    PATTERN "*.toml" PATTERN "*.lcm" PATTERN "*.asc" PATTERN "*.nc" PATTERN "*.csv" PATTERN "*.gpx")
endforeach()
install(DIRECTORY examples DESTINATION ${share_dir} USE_SOURCE_PERMISSIONS
  PATTERN CMakeLists.txt EXCLUDE PATTERN __pycache__ EXCLUDE)
install(DIRECTORY docs/ DESTINATION share/doc/shoal)
# The same pages as a site, where mkdocs is (scripts/setup --with-docs).
find_program(SHOAL_MKDOCS mkdocs)
if(SHOAL_MKDOCS)
  file(GLOB_RECURSE pages CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/docs/*.md ${CMAKE_SOURCE_DIR}/docs/images/*)
  add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/site/index.html
    COMMAND ${CMAKE_SOURCE_DIR}/scripts/docs --out ${CMAKE_BINARY_DIR}/site
    DEPENDS ${pages} README.md CONTRIBUTING.md CHANGELOG.md lib/README.md scripts/docs
    COMMENT "Making the site of the pages" VERBATIM)
  add_custom_target(docs_site DEPENDS ${CMAKE_BINARY_DIR}/site/index.html)
  install(DIRECTORY ${CMAKE_BINARY_DIR}/site/ DESTINATION share/doc/shoal/html OPTIONAL)
endif()
install(FILES README.md CHANGELOG.md LICENSE DESTINATION share/doc/shoal)
if(TARGET shoal_types_jar)
  install(FILES ${CMAKE_BINARY_DIR}/shoal_types.jar DESTINATION ${share_dir})
endif()
install(FILES packaging/shoal.bash DESTINATION share/bash-completion/completions RENAME shoal)
install(FILES packaging/_shoal DESTINATION share/zsh/vendor-completions)

# Manual pages, from what the programs print for --help.
find_program(SHOAL_PYTHON python3)
set(SHOAL_MAN_PAGES_FROM ${CMAKE_RUNTIME_OUTPUT_DIRECTORY} CACHE PATH
  "Folder of the programs that print them: where this computer cannot run those that it builds")
if(SHOAL_PYTHON)
  set(man_stamp ${staging}/man.stamp)
  add_custom_command(OUTPUT ${man_stamp}
    COMMAND ${SHOAL_PYTHON} ${CMAKE_SOURCE_DIR}/scripts/man_pages
      ${SHOAL_MAN_PAGES_FROM} ${staging}/man1 ${manual_pages}
    COMMAND ${CMAKE_COMMAND} -E touch ${man_stamp}
    DEPENDS shoal viewer ${tools} ${apps} ${CMAKE_SOURCE_DIR}/scripts/man_pages VERBATIM
    COMMENT "Making manual pages")
  add_custom_target(man_pages ALL DEPENDS ${man_stamp})
  install(DIRECTORY ${staging}/man1 DESTINATION share/man FILES_MATCHING PATTERN "*.1.gz")
else()
  message(STATUS "No python3: no manual pages (apt-get install python3)")
endif()

# The Python package, with the message types that it reads.
install(DIRECTORY python/shoal DESTINATION ${SHOAL_PYTHON_DIR} FILES_MATCHING
  PATTERN "*.py" PATTERN py.typed PATTERN __pycache__ EXCLUDE)
install(DIRECTORY lcmtypes DESTINATION ${SHOAL_PYTHON_DIR}/shoal FILES_MATCHING PATTERN "*.lcm")

# For programs that embed shoal: find_package(shoal), or pkg-config for the C interface.
set(archive ${CMAKE_BINARY_DIR}/lib/libshoal.a)
shoal_merge_archives(shoal_archive sim ${archive})
install(TARGETS shoal_sim LIBRARY DESTINATION lib)
install(FILES ${archive} DESTINATION lib)
install(TARGETS shoal_lcmtypes_c ARCHIVE DESTINATION lib)
shoal_public_headers(public_headers
  sim/shoal_sim.h sim/simulation.h sim/director_app.h lib/mission/model/mission.h lib/mission/file/load.h)
# Included by these.
install(DIRECTORY vendor/geographiclib/include/GeographicLib DESTINATION include/shoal)
foreach(header IN LISTS public_headers)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${header} DESTINATION include/shoal/${folder})
endforeach()
install(DIRECTORY ${CMAKE_BINARY_DIR}/gen/cpp/shoal DESTINATION include
  FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ${CMAKE_BINARY_DIR}/gen/c/ DESTINATION include/shoal
  FILES_MATCHING PATTERN "*.h")
include(CMakePackageConfigHelpers)
configure_package_config_file(packaging/shoalConfig.cmake.in ${staging}/shoalConfig.cmake
  INSTALL_DESTINATION lib/cmake/shoal)
write_basic_package_version_file(${staging}/shoalConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${staging}/shoalConfig.cmake ${staging}/shoalConfigVersion.cmake
  DESTINATION lib/cmake/shoal)
configure_file(packaging/shoal_sim.pc.in ${staging}/shoal_sim.pc @ONLY)
install(FILES ${staging}/shoal_sim.pc DESTINATION lib/pkgconfig)

# All that is installed, and no test: scripts/package builds this.
add_custom_target(install_parts
  DEPENDS shoal viewer ${tools} ${apps} ${examples} shoal_sim shoal_lcmtypes_c shoal_lcmtypes_gen)
add_dependencies(install_parts shoal_archive)
foreach(target docs_site man_pages netcdf_reader shoal_types_jar)
  if(TARGET ${target})
    add_dependencies(install_parts ${target})
  endif()
endforeach()

include(Package)
