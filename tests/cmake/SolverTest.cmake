# SPDX-License-Identifier: GPL-3.0-or-later
#[[
Tests that run the solver and judge what it does, written in Python.

  interstice_solver_test(A11SealedPlug LABEL verification RANKS 1 2 [LONG 4] [NAME name]
      [ARGUMENTS ...] [TIMEOUT 900])

registers <folder>.A11SealedPlug.np1 and so on (or .name): A11SealedPlug.py of the folder with --solver, --ranks
and --work, a folder of its own below tests/<folder> in the build tree. LONG: numbers of ranks on which it has the
label long besides.
]]
find_package(Python3 REQUIRED COMPONENTS Interpreter)

function(interstice_solver_test file)
    cmake_parse_arguments(PARSE_ARGV 1 test "" "LABEL;NAME;TIMEOUT" "RANKS;LONG;ARGUMENTS")
    if(NOT test_TIMEOUT)
        set(test_TIMEOUT 900)
    endif()
    get_filename_component(folder "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
    foreach(ranks IN LISTS test_RANKS test_LONG)
        set(run ${file}.np${ranks})
        if(test_NAME)
            set(run ${file}.${test_NAME})
        endif()
        set(labels ${test_LABEL})
        if(ranks IN_LIST test_LONG)
            list(APPEND labels long)
        endif()
        add_test(NAME ${folder}.${run}
            COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/${file}.py"
                --solver $<TARGET_FILE:demPimpleFoam>
                --work "${PROJECT_BINARY_DIR}/tests/${folder}/${run}"
                --ranks ${ranks} ${test_ARGUMENTS})
        set_tests_properties(${folder}.${run} PROPERTIES
            PROCESSORS ${ranks}
            ENVIRONMENT "${interstice_test_environment};PYTHONDONTWRITEBYTECODE=1"
            LABELS "${labels}"
            TIMEOUT ${test_TIMEOUT})
    endforeach()
endfunction()
