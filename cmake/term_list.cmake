# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0

# clothfit_term_list(LIST ALIAS [DIRECTORY] [MORE lines...] SOURCES variable): writes what follows
# from a list of force terms. A line of the list is `header: Term...`, the header in the list's own
# folder. In DIRECTORY (default: build/generated), which has to be an include directory,
#   folder/LIST.h          defines ALIAS as the TypeList of all terms,
#   folder/header_batch.cc instantiates the terms of one header; these go into `variable`.
# MORE lines are added to the list's. Configuring starts again where the list changes.
function(clothfit_term_list list_path alias)
  cmake_parse_arguments(ARG "" "DIRECTORY;SOURCES" "MORE" ${ARGN})
  if(NOT ARG_DIRECTORY)
    set(ARG_DIRECTORY ${PROJECT_BINARY_DIR}/generated)
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${list_path})
  cmake_path(GET list_path PARENT_PATH folder)
  cmake_path(GET list_path STEM name)
  file(STRINGS ${PROJECT_SOURCE_DIR}/${list_path} lines REGEX "^[^#]")
  set(includes)
  set(all_terms)
  set(sources)
  foreach(line ${lines} ${ARG_MORE})
    if(NOT line MATCHES "^[a-z0-9_]+:( [A-Za-z0-9]+)+$")
      message(FATAL_ERROR "${list_path}: '${line}': expected 'header: Term...'")
    endif()
    string(REGEX MATCHALL "[A-Za-z0-9_]+" terms "${line}")
    list(POP_FRONT terms file)
    set(header ${folder}/${file}.h)
    string(APPEND includes "#include \"${header}\"\n")
    list(APPEND all_terms ${terms})
    set(instances)
    foreach(term ${terms})
      string(APPEND instances
             "template std::unique_ptr<ForceBatch> MakeForceBatch<${term}>(const TermContext&);\n")
    endforeach()
    set(source ${ARG_DIRECTORY}/${folder}/${file}_batch.cc)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/term_batch.cc.in ${source} @ONLY)
    list(APPEND sources ${source})
  endforeach()
  # Their derivatives take the time, not the headers: each alone, so that one term changed compiles
  # one term.
  set_source_files_properties(${sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  list(JOIN all_terms ", " all_terms)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/term_list.h.in ${ARG_DIRECTORY}/${folder}/${name}.h
                 @ONLY)
  set(${ARG_SOURCES} ${sources} PARENT_SCOPE)
endfunction()
