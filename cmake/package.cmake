# The Debian package: cpack -G DEB. It installs below /usr what `cmake --install` does, and what Debian's policy asks for besides.

set(package_texts ${CMAKE_CURRENT_BINARY_DIR}/generated/package)
set(maintainer "The authors of Eikonal <maintainers@users.noreply.h-seed-79f5d62f.example>")

# Of the last commit, so that the same sources make the same package.
execute_process(COMMAND git -C ${CMAKE_CURRENT_SOURCE_DIR} log -1 --format=%aD OUTPUT_VARIABLE EIKONAL_PACKAGE_DATE
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT EIKONAL_PACKAGE_DATE)
    set(EIKONAL_PACKAGE_DATE "Thu, 01 Jan 2026 00:00:00 +0000")
endif()
configure_file(packaging/changelog.in ${package_texts}/changelog @ONLY)
find_program(GZIP gzip)
add_custom_command(OUTPUT ${package_texts}/changelog.gz ${package_texts}/eikonal.1.gz
    COMMAND ${GZIP} -9nc ${package_texts}/changelog > ${package_texts}/changelog.gz
    COMMAND ${GZIP} -9nc ${shell_texts}/eikonal.1 > ${package_texts}/eikonal.1.gz
    DEPENDS ${package_texts}/changelog ${shell_texts}/eikonal.1 VERBATIM)
add_custom_target(package_texts ALL DEPENDS ${package_texts}/changelog.gz ${package_texts}/eikonal.1.gz)
add_dependencies(package_texts shell_texts)

set(package_doc ${CMAKE_INSTALL_DATADIR}/doc/eikonal)
install(FILES packaging/copyright ${package_texts}/changelog.gz DESTINATION ${package_doc} COMPONENT package EXCLUDE_FROM_ALL)
install(FILES packaging/lintian-overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME eikonal COMPONENT package EXCLUDE_FROM_ALL)
install(FILES ${package_texts}/eikonal.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT package EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME eikonal)
set(CPACK_PACKAGE_VENDOR "Eikonal")
set(CPACK_PACKAGE_CONTACT "${maintainer}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
# One package of two components: what is installed anyway, and what only the package has.
set(CPACK_COMPONENTS_ALL Unspecified package)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Where the module of image formats is, for dpkg-shlibdeps.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_CURRENT_BINARY_DIR})
# The program calls OpenCL's loader; PoCL makes the processor a device.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "pocl-opencl-icd")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "path tracer for OpenCL devices that reads scenes of pbrt-v4
Eikonal renders scenes of pbrt-v4 and Wavefront OBJ files by path tracing, in
waves of many rays, on GPUs and on processors (through PoCL). It writes EXR,
PNG and other images, resumes renders that were interrupted, and joins parts
that several machines have rendered, bit for bit.")
include(CPack)
