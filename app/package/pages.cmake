# cmake -DPROGRAM= [-DWINDOW=] -DOUT= -P pages.cmake: writes manual pages to OUT/man1 and completions to
# OUT/completions.
file(REMOVE_RECURSE ${OUT})
file(MAKE_DIRECTORY ${OUT})
# Leaks at the programs' end are checked by the tests, not here.
set(ENV{ASAN_OPTIONS} detect_leaks=0)
if(WINDOW)
  execute_process(COMMAND ${WINDOW} --help OUTPUT_FILE ${OUT}/reliefscope.help COMMAND_ERROR_IS_FATAL ANY)
endif()
execute_process(COMMAND ${PROGRAM} --manual ${OUT} COMMAND_ERROR_IS_FATAL ANY)
find_program(GZIP gzip)
if(GZIP)
  file(GLOB _pages ${OUT}/man1/*.1)
  execute_process(COMMAND ${GZIP} -9nf ${_pages} COMMAND_ERROR_IS_FATAL ANY)
endif()
file(TOUCH ${OUT}/made)
