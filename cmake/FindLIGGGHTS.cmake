# SPDX-License-Identifier: GPL-3.0-or-later
#[[
Finds LIGGGHTS as a library, as Debian's liggghts and libliggghts-dev install it.

  find_package(LIGGGHTS 3.8.0 REQUIRED)

gives the target LIGGGHTS::LIGGGHTS. Another place is named with LIGGGHTS_ROOT.
]]

find_path(LIGGGHTS_INCLUDE_DIR NAMES lammps.h PATH_SUFFIXES liggghts
    DOC "Folder of LIGGGHTS' lammps.h")
find_library(LIGGGHTS_LIBRARY NAMES liggghts DOC "LIGGGHTS' library")
mark_as_advanced(LIGGGHTS_INCLUDE_DIR LIGGGHTS_LIBRARY)

# No header tells LIGGGHTS' version; the name of the library behind the link does.
if(LIGGGHTS_LIBRARY)
    file(REAL_PATH "${LIGGGHTS_LIBRARY}" _liggghts_file)
    string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+$" LIGGGHTS_VERSION "${_liggghts_file}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LIGGGHTS
    REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR
    VERSION_VAR LIGGGHTS_VERSION
    REASON_FAILURE_MESSAGE
    "Run cmake/setup.sh or install the packages liggghts and libliggghts-dev, or name the place of another LIGGGHTS with LIGGGHTS_ROOT.")

if(LIGGGHTS_FOUND AND NOT TARGET MPI::MPI_CXX)
    find_package(MPI REQUIRED COMPONENTS CXX)
endif()

if(LIGGGHTS_FOUND AND NOT TARGET LIGGGHTS::LIGGGHTS)
    add_library(LIGGGHTS::LIGGGHTS UNKNOWN IMPORTED)
    # LAMMPS_VTK is how Debian built the library: it changes the size of classes in the headers.
    set_target_properties(LIGGGHTS::LIGGGHTS PROPERTIES
        IMPORTED_LOCATION "${LIGGGHTS_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${LIGGGHTS_INCLUDE_DIR}"
        INTERFACE_COMPILE_DEFINITIONS LAMMPS_VTK
        INTERFACE_LINK_LIBRARIES MPI::MPI_CXX)
endif()
