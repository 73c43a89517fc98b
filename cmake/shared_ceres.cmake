# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0

# Ceres' templates of Eigen were compiled for the baseline instruction set, ours may not be, and two
# versions of one template must never meet in a link: half of a matrix product from each writes past
# its buffers. A shared library keeps its own; Debian's target names the static one beside it.
get_target_property(ceres_type Ceres::ceres TYPE)
if(NOT ceres_type STREQUAL "SHARED_LIBRARY")
  find_library(CERES_SHARED_LIBRARY NAMES libceres.so REQUIRED)
  get_target_property(ceres_configurations Ceres::ceres IMPORTED_CONFIGURATIONS)
  foreach(configuration ${ceres_configurations})
    set_target_properties(Ceres::ceres PROPERTIES
      IMPORTED_LOCATION_${configuration} ${CERES_SHARED_LIBRARY})
  endforeach()
endif()
