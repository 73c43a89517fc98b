# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0

# CLOTHFIT_INSTRUCTION_SET: what -march gets, such as x86-64-v3 or native. "host" is the highest
# level of x86-64 that this machine has; empty is the compiler's default, and so is host elsewhere.
set(CLOTHFIT_INSTRUCTION_SET host CACHE STRING
    "Instruction set: host, x86-64-v2, x86-64-v3, x86-64-v4, or any other name that -march takes")
set(CLOTHFIT_MARCH ${CLOTHFIT_INSTRUCTION_SET})
if(CLOTHFIT_MARCH STREQUAL "host")
  set(CLOTHFIT_MARCH "")
  if(NOT CMAKE_CROSSCOMPILING AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    try_run(CLOTHFIT_HOST_RUN CLOTHFIT_HOST_COMPILED ${PROJECT_BINARY_DIR}/host
            ${PROJECT_SOURCE_DIR}/cmake/host_instruction_set.cc
            CMAKE_FLAGS -DINCLUDE_DIRECTORIES=${PROJECT_SOURCE_DIR}
            RUN_OUTPUT_VARIABLE CLOTHFIT_MARCH)
    string(STRIP "${CLOTHFIT_MARCH}" CLOTHFIT_MARCH)
  endif()
endif()
message(STATUS "Instruction set: ${CLOTHFIT_INSTRUCTION_SET} (${CLOTHFIT_MARCH})")
