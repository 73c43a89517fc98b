# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0

# What `make install` and `make deb` put where. A component is a package: command, development,
# python. The package for Python is in python/CMakeLists.txt.
include(CMakePackageConfigHelpers)

# Man pages and bash's completion, written by the command that they are of.
set(share ${PROJECT_BINARY_DIR}/share)
add_custom_command(OUTPUT ${share}/stamp
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${share}
  COMMAND clothfit manual-pages ${share}
  COMMAND sh -c "gzip -n9 ${share}/man/man1/*"
  COMMAND ${CMAKE_COMMAND} -E touch ${share}/stamp
  DEPENDS clothfit libclothfit
  COMMENT "Writing man pages and completion"
  VERBATIM)
add_custom_target(manual_pages DEPENDS ${share}/stamp)

# All that is installed, for `make install`: tests are no part of it.
add_custom_target(installed DEPENDS manual_pages clothfit libclothfit)
if(TARGET clothfit_python)
  add_dependencies(installed clothfit_python)
endif()

install(TARGETS clothfit RUNTIME COMPONENT command)
install(TARGETS libclothfit EXPORT clothfitTargets
        LIBRARY COMPONENT command NAMELINK_COMPONENT development)
install(DIRECTORY ${share}/man ${share}/bash-completion TYPE DATA COMPONENT command)
install(DIRECTORY data/demo data/lift DESTINATION ${CMAKE_INSTALL_DATADIR}/clothfit/data
        COMPONENT command)

# The same library for higher levels of x86-64, which the loader prefers where the processor has
# them: tools/make_deb makes the folder.
set(CLOTHFIT_LEVELS "" CACHE PATH "Folder with x86-64-v3/libclothfit.so.0 and the like")
if(CLOTHFIT_LEVELS)
  install(DIRECTORY ${CLOTHFIT_LEVELS}/ DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibc-hwcaps
          USE_SOURCE_PERMISSIONS COMPONENT command)
endif()

set(headers base.h clothfit.h config.h diagnosis.h dual.h recording.h run.h simulation.h term.h)
list(TRANSFORM headers PREPEND clothfit/)
install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/clothfit COMPONENT development)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/clothfit)
install(EXPORT clothfitTargets NAMESPACE clothfit:: FILE clothfitConfig.cmake
        DESTINATION ${config_folder} COMPONENT development)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/clothfitConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/clothfitConfigVersion.cmake DESTINATION ${config_folder}
        COMPONENT development)
install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/clothfit/examples
        COMPONENT development)

include(cmake/package.cmake)
