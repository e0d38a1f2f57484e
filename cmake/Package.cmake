# What scripts/package makes: a Debian package of all that `cmake --install` installs.
set(doc_staging ${CMAKE_BINARY_DIR}/install/doc)
file(MAKE_DIRECTORY ${doc_staging})
function(shoal_compressed source name)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${source})
  execute_process(COMMAND gzip -9nc ${CMAKE_SOURCE_DIR}/${source}
    OUTPUT_FILE ${doc_staging}/${name} COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${doc_staging}/${name} DESTINATION share/doc/shoal)
endfunction()
shoal_compressed(CHANGELOG.md changelog.gz)
shoal_compressed(packaging/changelog.Debian changelog.Debian.gz)
install(FILES packaging/copyright DESTINATION share/doc/shoal)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME shoal)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
if(CMAKE_CROSSCOMPILING AND CMAKE_SYSTEM_PROCESSOR STREQUAL aarch64)
  set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE arm64)
endif()
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "shoal maintainers <maintainers@shoal.example>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY
  "missions of several vehicles over a lossy acoustic network")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"shoal simulates vessels and underwater vehicles that steer by a helm of their
own, and decides for each message whether it arrives, and why not.
.
This package has the programs, missions, documentation, the Python package
shoal, and what programs in C and C++ need to embed a mission.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3 (>= 3.11)")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS iproute2)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
  "gnuplot-nox, python3-numpy, liblcm-bin, liblcm-dev, libfmt-dev, libeigen3-dev, libsodium-dev, libtomlplusplus-dev, libexpat1-dev, libzstd-dev")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA
  "${CMAKE_SOURCE_DIR}/packaging/postinst;${CMAKE_SOURCE_DIR}/packaging/prerm;${CMAKE_SOURCE_DIR}/packaging/shlibs;${CMAKE_SOURCE_DIR}/packaging/triggers")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
