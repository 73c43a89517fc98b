# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0

# The Debian packages clothfit, libclothfit-dev and python3-clothfit, by CPack: see tools/make_deb.
set(packages clothfit libclothfit-dev python3-clothfit)
set(components command development python)

# Debian asks for an address. clothfit has none, so this one leads nowhere on purpose (RFC 2606).
set(CLOTHFIT_MAINTAINER "The clothfit authors <clothfit@clothfit.invalid>" CACHE STRING
    "Maintainer of the Debian packages: name and address, for who hands them on")

# Of each package: who may copy it, and what has changed.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/debian)
configure_file(cmake/debian/changelog.in ${PROJECT_BINARY_DIR}/debian/changelog @ONLY)
execute_process(COMMAND gzip -knf9 ${PROJECT_BINARY_DIR}/debian/changelog)
foreach(package component IN ZIP_LISTS packages components)
  install(FILES cmake/debian/copyright ${PROJECT_BINARY_DIR}/debian/changelog.gz
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# CPack's default, for which it puts nothing before the descriptions below.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_NAME} built using CMake")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_CONTACT "${CLOTHFIT_MAINTAINER}")
set(CPACK_PACKAGE_VENDOR "The clothfit authors")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/clothfit)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)

set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME clothfit)
set(CPACK_DEBIAN_COMMAND_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/triggers)
set(CPACK_COMPONENT_COMMAND_DESCRIPTION
"recovers the motion and the physics of real cloth
clothfit fits a simulated cloth to a recording of a real one, by pictures,
markers or tracks, so that the simulation explains the recording. It tells
every parameter with an interval, and what physics the simulation lacks.")

set(same_version "clothfit (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libclothfit-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${same_version}")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"recovers the physics of real cloth, for C++ programs
The headers of libclothfit, its package for CMake and examples, one of which
adds a force term of its own.")

math(EXPR next_python "${Python3_VERSION_MINOR} + 1")
set(python 3.${Python3_VERSION_MINOR})
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-clothfit)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "${same_version}, python3 (>= ${python}), python3 (<< 3.${next_python}), python3-numpy")
# Bytecode is made when it is installed, and goes with it.
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/python/postinst
                                              ${PROJECT_SOURCE_DIR}/cmake/debian/python/prerm)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
"recovers the physics of real cloth, for Python
Fits, diagnoses and simulations with derivatives, with NumPy's arrays.")
include(CPack)
