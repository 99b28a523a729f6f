# SPDX-License-Identifier: GPL-3.0-or-later
#[[
Tests on several ranks.

  interstice_case(cavity PATH cases/cavity RANKS 1 2 4 [DIRECTION x|y|z])

copies a case folder into the build tree, once for each number of ranks, runs blockMesh there and, for
more than one rank, decomposePar in equal slices along DIRECTION (x unless given). ctest does so when
a test asks for the case.

  interstice_test(MomentumExchange
      SOURCES MomentumExchangeTest.cpp
      LIBRARIES interstice
      RANKS 1 2 4
      [CASE cavity]           run with -case <the copy>, and -parallel on more than one rank
      [MAIN foam|mpi|own]     foam: MPI, argList, Time; mpi: MPI alone; own: one of SOURCES has it
      [LABELS unit]
      [FAILS_WITH "text"]     the program must end with an error and print this
      [TIMEOUT 120]           seconds
      [ARGUMENTS ...])

builds one program and registers MomentumExchange.np1, .np2 and .np4, each in a folder of its own.
]]

# The only environment a test needs, so that ctest works from any shell. Ranks that wait let others
# work: there are more ranks than cores.
set(interstice_test_environment
    "WM_PROJECT_DIR=$<IF:$<BOOL:$ENV{WM_PROJECT_DIR}>,$ENV{WM_PROJECT_DIR},/usr/share/openfoam>"
    OMPI_ALLOW_RUN_AS_ROOT=1
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    OMPI_MCA_mpi_yield_when_idle=1)
set(interstice_case_script "${CMAKE_CURRENT_LIST_DIR}/prepareCase.sh")
set(interstice_expect_failure "${CMAKE_CURRENT_LIST_DIR}/expectFailure.sh")

function(interstice_case name)
    cmake_parse_arguments(PARSE_ARGV 1 case "" "PATH;DIRECTION" "RANKS")
    if(NOT case_DIRECTION)
        set(case_DIRECTION x)
    endif()
    get_filename_component(source "${case_PATH}" ABSOLUTE)

    foreach(ranks IN LISTS case_RANKS)
        add_test(NAME case.${name}.np${ranks}
            COMMAND bash "${interstice_case_script}" "${source}"
                "${PROJECT_BINARY_DIR}/tests/cases/${name}.np${ranks}" ${ranks} ${case_DIRECTION})
        set_tests_properties(case.${name}.np${ranks} PROPERTIES
            FIXTURES_SETUP case.${name}.np${ranks}
            ENVIRONMENT "${interstice_test_environment}"
            LABELS case
            TIMEOUT 120)
    endforeach()
endfunction()

function(interstice_test name)
    cmake_parse_arguments(PARSE_ARGV 1 test "" "CASE;MAIN;TIMEOUT;FAILS_WITH"
        "SOURCES;LIBRARIES;RANKS;LABELS;ARGUMENTS")
    if(NOT test_RANKS)
        set(test_RANKS 1)
    endif()
    if(NOT test_LABELS)
        set(test_LABELS unit)
    endif()
    if(NOT test_TIMEOUT)
        set(test_TIMEOUT 120)
    endif()
    if(NOT test_MAIN)
        set(test_MAIN mpi)
    endif()

    add_executable(${name} ${test_SOURCES})
    target_link_libraries(${name} PRIVATE ${test_LIBRARIES} GTest::gtest MPI::MPI_CXX
        interstice_warnings)
    target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}")
    set_target_properties(${name} PROPERTIES
        RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests/bin")
    if(test_MAIN STREQUAL foam)
        target_link_libraries(${name} PRIVATE interstice_foam_test_main)
    elseif(test_MAIN STREQUAL mpi)
        target_link_libraries(${name} PRIVATE interstice_mpi_test_main)
    elseif(NOT test_MAIN STREQUAL own)
        message(FATAL_ERROR "interstice_test(${name}): MAIN is ${test_MAIN}; foam, mpi or own is meant.")
    endif()

    set(judge "")
    if(test_FAILS_WITH)
        set(judge bash "${interstice_expect_failure}" "${test_FAILS_WITH}")
    endif()

    foreach(ranks IN LISTS test_RANKS)
        set(folder "${PROJECT_BINARY_DIR}/tests/runs/${name}.np${ranks}")
        file(MAKE_DIRECTORY "${folder}")
        set(arguments ${test_ARGUMENTS})
        if(test_CASE)
            list(APPEND arguments -case "${PROJECT_BINARY_DIR}/tests/cases/${test_CASE}.np${ranks}")
            if(ranks GREATER 1)
                list(APPEND arguments -parallel)
            endif()
        endif()

        add_test(NAME ${name}.np${ranks}
            # Unbound, since every mpiexec would bind its first rank to the first core.
            COMMAND ${judge} ${MPIEXEC_EXECUTABLE} --oversubscribe --bind-to none
                ${MPIEXEC_NUMPROC_FLAG} ${ranks} $<TARGET_FILE:${name}> ${arguments}
            WORKING_DIRECTORY "${folder}")
        set_tests_properties(${name}.np${ranks} PROPERTIES
            PROCESSORS ${ranks}
            ENVIRONMENT "${interstice_test_environment}"
            LABELS "${test_LABELS}"
            TIMEOUT ${test_TIMEOUT})
        if(test_CASE)
            # Two tests on one case take turns: either may write there.
            set_tests_properties(${name}.np${ranks} PROPERTIES
                FIXTURES_REQUIRED case.${test_CASE}.np${ranks}
                RESOURCE_LOCK case.${test_CASE}.np${ranks})
        endif()
    endforeach()
endfunction()
