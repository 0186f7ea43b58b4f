# relief_add_suites(PROGRAM [PREFIX text] [ON_DISPLAY] [PROPERTIES name value ...]): makes each suite of a GoogleTest
# program one test of ctest, run in one process, because starting the program takes longer than most tests. The built
# program lists its suites, so none is missed. ON_DISPLAY: each suite runs on an X server of its own, so that suites can
# run in parallel and nothing flickers on the user's display.
if(CMAKE_SCRIPT_MODE_FILE)
  # cmake -DPROGRAM= -DPREFIX= -DLAUNCHER= -DPROPERTIES= -DOUT= -P suites.cmake. A message about a missing display
  # matters when tests run, not when they are listed.
  execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE _list ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "(^|\n)[^ \n]+\\." _suites "${_list}")
  if(NOT _suites)
    message(FATAL_ERROR "${PROGRAM} lists no tests")
  endif()
  # Suites that take most of a minute or more begin first, so that none runs alone at the end.
  set(_long WindowTest Exports/EveryExport Exports LayoutTest ClosedPanes RandomWalk Figure DistanceTest Program
    Places/FaultsTest Places/MpiTest Duel SampledLanes Guarantees Exactness)
  set(_script "")
  set(_display 100)
  foreach(_suite IN LISTS _suites)
    string(STRIP "${_suite}" _suite)
    string(REGEX REPLACE "\\.$" "" _name "${_suite}")
    string(REPLACE "DISPLAY" "${_display}" _launcher "${LAUNCHER}")
    math(EXPR _display "${_display} + 5")
    string(APPEND _script
      "add_test([=[${PREFIX}${_name}]=] ${_launcher} [=[${PROGRAM}]=] [=[--gtest_filter=${_suite}*]=])\n"
      "set_tests_properties([=[${PREFIX}${_name}]=] PROPERTIES ${PROPERTIES}")
    list(FIND _long "${_name}" _place)
    if(NOT _place EQUAL -1)
      string(APPEND _script " COST 100")
    endif()
    string(APPEND _script ")\n")
  endforeach()
  file(WRITE ${OUT} "${_script}")
  return()
endif()

# Sets the command that starts a program on an X server of its own, of a fixed screen size; empty if Xvfb is missing.
# number: the first display number to try. Two servers that search for a free number at the same time may choose the
# same one.
function(relief_display out number)
  find_program(XVFB_RUN xvfb-run)
  find_program(XAUTH xauth)
  set(${out} "" PARENT_SCOPE)
  if(XVFB_RUN AND XAUTH)
    set(${out} ${XVFB_RUN} -a -n ${number} -s "-screen 0 1600x1000x24 -noreset" PARENT_SCOPE)
  endif()
endfunction()

function(relief_add_suites program)
  cmake_parse_arguments(_suites "ON_DISPLAY" "PREFIX" "PROPERTIES" ${ARGN})
  set(_launcher "")
  if(_suites_ON_DISPLAY)
    relief_display(_launcher DISPLAY)
    list(JOIN _launcher "]=] [=[" _launcher)
    string(REGEX REPLACE "(.+)" "[=[\\1]=]" _launcher "${_launcher}")
  endif()
  set(_out ${CMAKE_CURRENT_BINARY_DIR}/${program}_suites.cmake)
  string(REPLACE ";" " " _properties "${_suites_PROPERTIES}")
  add_custom_command(TARGET ${program} POST_BUILD BYPRODUCTS ${_out} VERBATIM
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${program}> -DPREFIX=${_suites_PREFIX} -DLAUNCHER=${_launcher}
      -DPROPERTIES=${_properties} -DOUT=${_out} -P ${PROJECT_SOURCE_DIR}/tests/suites.cmake)
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${_out})
endfunction()
