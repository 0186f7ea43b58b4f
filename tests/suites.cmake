# relief_add_suites(PROGRAM [PREFIX text] [FILTER pattern] [PROPERTIES name value ...]): each suite of a GoogleTest
# program becomes one test of ctest, run in one process: starting the program for every test by itself took longer than
# most tests do. Suites are asked of the built program, so that none is forgotten.
if(CMAKE_SCRIPT_MODE_FILE)
  # cmake -DPROGRAM= -DPREFIX= -DFILTER= -DPROPERTIES= -DOUT= -P suites.cmake
  execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=${FILTER} OUTPUT_VARIABLE _list
    COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "(^|\n)[^ \n]+\\." _suites "${_list}")
  if(NOT _suites)
    message(FATAL_ERROR "${PROGRAM} lists no tests of ${FILTER}")
  endif()
  set(_script "")
  foreach(_suite IN LISTS _suites)
    string(STRIP "${_suite}" _suite)
    string(REGEX REPLACE "\\.$" "" _name "${_suite}")
    string(APPEND _script "add_test([=[${PREFIX}${_name}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${_suite}*]=])\n"
      "set_tests_properties([=[${PREFIX}${_name}]=] PROPERTIES ${PROPERTIES})\n")
  endforeach()
  file(WRITE ${OUT} "${_script}")
  return()
endif()

function(relief_add_suites program)
  cmake_parse_arguments(_suites "" "PREFIX;FILTER;LIST" "PROPERTIES" ${ARGN})
  if(NOT _suites_FILTER)
    set(_suites_FILTER "*")
  endif()
  set(_out ${CMAKE_CURRENT_BINARY_DIR}/${program}${_suites_LIST}_suites.cmake)
  string(REPLACE ";" " " _properties "${_suites_PROPERTIES}")
  add_custom_command(TARGET ${program} POST_BUILD BYPRODUCTS ${_out} VERBATIM
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${program}> -DPREFIX=${_suites_PREFIX} -DFILTER=${_suites_FILTER}
      -DPROPERTIES=${_properties} -DOUT=${_out} -P ${PROJECT_SOURCE_DIR}/tests/suites.cmake)
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${_out})
endfunction()
