# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0

# Warnings, instruction set and instrumentation that every target of clothfit shares.
add_library(clothfit_options INTERFACE)
target_compile_options(clothfit_options INTERFACE
  -Wall -Wextra -Wconversion -Wshadow -Wno-sign-conversion
  $<$<BOOL:${CLOTHFIT_WERROR}>:-Werror>
  # GCC 12 takes its own AVX-512 intrinsics for uninitialised (GCC bug 105593).
  -Wno-maybe-uninitialized -Wno-array-bounds
  # GCC 14 takes one of its own for a memcpy beyond what it reads.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-stringop-overread>
  # Square roots and the like set no errno here, so they may be inlined. Nothing else of fast-math.
  -fno-math-errno)
if(CLOTHFIT_MARCH)
  target_compile_options(clothfit_options INTERFACE -march=${CLOTHFIT_MARCH})
endif()
# What is hidden is bound within this program, see shared_ceres.cmake. Where our Eigen and Ceres' do
# meet, in Ceres' headers, they align alike.
target_compile_options(clothfit_options INTERFACE -fvisibility=hidden -fvisibility-inlines-hidden)
if(CLOTHFIT_LIBRARY)
  target_compile_options(clothfit_options INTERFACE -fno-semantic-interposition)
endif()
target_compile_definitions(clothfit_options INTERFACE EIGEN_MAX_ALIGN_BYTES=16)
if(CLOTHFIT_SANITIZE)
  # A check of every pointer for null and alignment takes twice as long to compile as all the rest, and
  # on this code says nothing that the address sanitizer does not say.
  target_compile_options(clothfit_options INTERFACE
    -fsanitize=${CLOTHFIT_SANITIZE}
    -fno-sanitize=null,alignment,vptr,object-size,nonnull-attribute,returns-nonnull-attribute
    -fno-sanitize-recover=all)
  target_link_options(clothfit_options INTERFACE -fsanitize=${CLOTHFIT_SANITIZE})
endif()
if(CLOTHFIT_COVERAGE)
  target_compile_options(clothfit_options INTERFACE --coverage)
  target_link_options(clothfit_options INTERFACE --coverage)
endif()

# clothfit_library(NAME SOURCES... ) : one static library for one folder.
function(clothfit_library name)
  add_library(${name} STATIC ${ARGN})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE clothfit_options)
endfunction()
