# SPDX-License-Identifier: GPL-3.0-or-later
#[[
Finds OpenFOAM: libraries as Debian installs them, headers from a source tree of the same version.

  find_package(OpenFOAM 1912 EXACT REQUIRED COMPONENTS finiteVolume sampling)

gives the target OpenFOAM::OpenFOAM (always) and one OpenFOAM::<component> for each component, which
carries its headers (as system headers), its library and the components it builds upon.

Looks for
  headers    FOAM_SRC (CMake or environment variable): the src folder of a source tree whose lnInclude
             folders exist; else $WM_PROJECT_DIR/src; else the tree that cmake/setup.sh keeps.
  libraries  FOAM_LIBBIN (CMake or environment variable); else the linker's default path.

Debian's package has no headers, hence the two places.
]]

# Below, one line a component: library, header folders below src, the components it builds upon.
set(_foam_OpenFOAM "OpenFOAM|OpenFOAM OSspecific/POSIX|")
set(_foam_fileFormats "fileFormats|fileFormats|OpenFOAM")
set(_foam_surfMesh "surfMesh|surfMesh|fileFormats")
set(_foam_meshTools "meshTools|meshTools|surfMesh")
set(_foam_finiteVolume "finiteVolume|finiteVolume|meshTools")
set(_foam_dynamicMesh "dynamicMesh|dynamicMesh|finiteVolume")
set(_foam_dynamicFvMesh "dynamicFvMesh|dynamicFvMesh|dynamicMesh")
set(_foam_lagrangian "lagrangian|lagrangian/basic|finiteVolume")
set(_foam_distributionModels "distributionModels|lagrangian/distributionModels|lagrangian")
set(_foam_sampling "sampling|sampling|lagrangian")
set(_foam_functionObjects "fieldFunctionObjects|functionObjects/field|sampling")
set(_foam_forces "forces|functionObjects/forces|functionObjects incompressibleTurbulenceModels")
set(_foam_fvOptions "fvOptions|fvOptions|sampling")
set(_foam_decompositionMethods
    "decompositionMethods|parallel/decompose/decompositionMethods|meshTools")
set(_foam_turbulenceModels "turbulenceModels|TurbulenceModels/turbulenceModels|fvOptions")
set(_foam_incompressibleTransportModels
    "incompressibleTransportModels|transportModels/incompressible|finiteVolume")
set(_foam_incompressibleTurbulenceModels
    "incompressibleTurbulenceModels|TurbulenceModels/incompressible|turbulenceModels incompressibleTransportModels")
set(_foam_phaseTurbulenceModels
    "DPMTurbulenceModels|TurbulenceModels/turbulenceModels|incompressibleTurbulenceModels")
# The parcel templates of this library name thermophysics even where a cloud has none.
set(_foam_lagrangianIntermediate
    "lagrangianIntermediate|lagrangian/intermediate thermophysicalModels/specie thermophysicalModels/basic thermophysicalModels/thermophysicalProperties thermophysicalModels/reactionThermo thermophysicalModels/SLGThermo thermophysicalModels/radiation transportModels/compressible regionModels/regionModel regionModels/surfaceFilmModels|distributionModels dynamicFvMesh incompressibleTransportModels")

if(DEFINED ENV{INTERSTICE_CACHE})
    set(_foam_cache "$ENV{INTERSTICE_CACHE}")
elseif(DEFINED ENV{XDG_CACHE_HOME})
    set(_foam_cache "$ENV{XDG_CACHE_HOME}/interstice")
else()
    set(_foam_cache "$ENV{HOME}/.cache/interstice")
endif()

if(FOAM_SRC AND NOT EXISTS "${FOAM_SRC}/OpenFOAM/lnInclude/Time.H")
    message(FATAL_ERROR "FOAM_SRC=${FOAM_SRC} has no OpenFOAM/lnInclude/Time.H: it must name the src "
        "folder of an OpenFOAM v1912 source tree in which wmake/wmakeLnIncludeAll src was run.")
endif()
find_path(FOAM_SRC
    NAMES OpenFOAM/lnInclude/Time.H
    HINTS ENV FOAM_SRC
    PATHS "$ENV{WM_PROJECT_DIR}/src" "${_foam_cache}/openfoam-v1912/src"
    DOC "src folder of OpenFOAM's source tree, with its lnInclude folders"
    NO_DEFAULT_PATH)
find_library(OpenFOAM_LIBRARY
    NAMES OpenFOAM
    HINTS ENV FOAM_LIBBIN "${FOAM_LIBBIN}"
    DOC "OpenFOAM's core library")
get_filename_component(_foam_libbin "${OpenFOAM_LIBRARY}" DIRECTORY)
# With dummy Pstream folders beside it (an OpenFOAM built from source) the one for MPI is meant.
find_library(OpenFOAM_Pstream_LIBRARY
    NAMES Pstream
    HINTS "${_foam_libbin}/$ENV{FOAM_MPI}" "${_foam_libbin}"
    NO_DEFAULT_PATH)
mark_as_advanced(OpenFOAM_LIBRARY OpenFOAM_Pstream_LIBRARY)

if(FOAM_SRC AND EXISTS "${FOAM_SRC}/../META-INFO/api-info")
    file(STRINGS "${FOAM_SRC}/../META-INFO/api-info" _foam_api REGEX "^api=[0-9]+")
    string(REGEX REPLACE "^api=" "" OpenFOAM_VERSION "${_foam_api}")
endif()

set(OpenFOAM_OpenFOAM_FOUND TRUE)
set(_foam_wanted OpenFOAM ${OpenFOAM_FIND_COMPONENTS})
set(_foam_targets "")
# A component pulls in what it builds upon; the loop ends since the table has no circles.
while(_foam_wanted)
    list(POP_FRONT _foam_wanted _foam_component)
    if(NOT _foam_component IN_LIST _foam_targets)
        list(APPEND _foam_targets ${_foam_component})
        if(NOT DEFINED _foam_${_foam_component})
            message(FATAL_ERROR "FindOpenFOAM does not know the component ${_foam_component}: "
                "add its line to the table in ${CMAKE_CURRENT_LIST_FILE}.")
        endif()
        string(REPLACE "|" ";" _foam_row "${_foam_${_foam_component}}")
        list(GET _foam_row 0 _foam_name)
        list(GET _foam_row 2 _foam_needs)
        separate_arguments(_foam_needs)
        list(APPEND _foam_wanted ${_foam_needs})
        find_library(OpenFOAM_${_foam_component}_LIBRARY
            NAMES ${_foam_name} HINTS "${_foam_libbin}" NO_DEFAULT_PATH)
        mark_as_advanced(OpenFOAM_${_foam_component}_LIBRARY)
        if(OpenFOAM_${_foam_component}_LIBRARY)
            set(OpenFOAM_${_foam_component}_FOUND TRUE)
        endif()
    endif()
endwhile()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenFOAM
    REQUIRED_VARS OpenFOAM_LIBRARY OpenFOAM_Pstream_LIBRARY FOAM_SRC
    VERSION_VAR OpenFOAM_VERSION
    HANDLE_COMPONENTS
    REASON_FAILURE_MESSAGE
    "Run cmake/setup.sh, which installs OpenFOAM v1912 and fetches its headers, or point FOAM_SRC to the src folder (with lnInclude folders) and FOAM_LIBBIN to the libraries of an OpenFOAM v1912.")

if(OpenFOAM_FOUND AND NOT TARGET MPI::MPI_CXX)
    find_package(MPI REQUIRED COMPONENTS CXX)
endif()

if(OpenFOAM_FOUND)
    foreach(_foam_component IN LISTS _foam_targets)
        if(TARGET OpenFOAM::${_foam_component})
            continue()
        endif()
        string(REPLACE "|" ";" _foam_row "${_foam_${_foam_component}}")
        list(GET _foam_row 1 _foam_folders)
        list(GET _foam_row 2 _foam_needs)
        separate_arguments(_foam_folders)
        separate_arguments(_foam_needs)
        list(TRANSFORM _foam_folders REPLACE "^(.+)$" "${FOAM_SRC}/\\1/lnInclude")
        list(TRANSFORM _foam_needs PREPEND "OpenFOAM::")

        # No soname: or else a program would look for the library at the path where it was linked.
        add_library(OpenFOAM::${_foam_component} SHARED IMPORTED)
        set_target_properties(OpenFOAM::${_foam_component} PROPERTIES
            IMPORTED_LOCATION "${OpenFOAM_${_foam_component}_LIBRARY}"
            IMPORTED_NO_SONAME TRUE
            INTERFACE_INCLUDE_DIRECTORIES "${_foam_folders}"
            INTERFACE_LINK_LIBRARIES "${_foam_needs}")
    endforeach()

    # A library of headers alone, for which wmake makes no lnInclude folder.
    if(TARGET OpenFOAM::phaseTurbulenceModels)
        set_property(TARGET OpenFOAM::phaseTurbulenceModels APPEND PROPERTY
            INTERFACE_INCLUDE_DIRECTORIES "${FOAM_SRC}/TurbulenceModels/phaseIncompressible/PhaseIncompressibleTurbulenceModel")
    endif()

    # transportModels has headers that are named with their folder.
    if(TARGET OpenFOAM::incompressibleTransportModels)
        set_property(TARGET OpenFOAM::incompressibleTransportModels APPEND PROPERTY
            INTERFACE_INCLUDE_DIRECTORIES "${FOAM_SRC}/transportModels")
    endif()

    # NoRepository: the headers of templates bring their definitions along. --no-as-needed: libraries
    # that only register models with the run-time selection must stay although no symbol asks for them.
    set_target_properties(OpenFOAM::OpenFOAM PROPERTIES
        INTERFACE_COMPILE_DEFINITIONS "OPENFOAM=1912;WM_DP;WM_LABEL_SIZE=32;NoRepository"
        INTERFACE_LINK_OPTIONS "LINKER:--no-as-needed"
        INTERFACE_LINK_LIBRARIES "${OpenFOAM_Pstream_LIBRARY};MPI::MPI_CXX;${CMAKE_DL_LIBS}")
endif()
