# Run at installation: installs the headers that the project's own programs include, and what those include in turn.
# The others (SIMD kernels, builders of maps, ...) stay private.
#   RELIEF_SOURCES: the checkout.
cmake_policy(VERSION 3.25)  # installation scripts begin with none
set(_algorithms ${RELIEF_SOURCES}/algorithms)

# The files of algorithms/ that FILE includes, appended to the list.
function(included file list)
  file(STRINGS ${file} _lines REGEX "^#include \"")
  get_filename_component(_folder ${file} DIRECTORY)
  foreach(_line IN LISTS _lines)
    string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" _name "${_line}")
    foreach(_path ${_algorithms}/${_name} ${_folder}/${_name})
      if(EXISTS ${_path} AND _path MATCHES "^${_algorithms}/")
        list(APPEND ${list} ${_path})
        break()
      endif()
    endforeach()
  endforeach()
  set(${list} ${${list}} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE _users ${RELIEF_SOURCES}/app/*.cpp ${RELIEF_SOURCES}/app/*.h ${RELIEF_SOURCES}/ui/*.cpp
  ${RELIEF_SOURCES}/ui/*.h)
set(_open "")
foreach(_user IN LISTS _users)
  included(${_user} _open)
endforeach()
set(_public "")
while(_open)
  list(POP_FRONT _open _header)
  if(NOT _header IN_LIST _public)
    list(APPEND _public ${_header})
    included(${_header} _open)
  endif()
endwhile()
foreach(_header IN LISTS _public)
  file(RELATIVE_PATH _path ${_algorithms} ${_header})
  get_filename_component(_folder ${_path} DIRECTORY)
  file(INSTALL ${_header} DESTINATION ${CMAKE_INSTALL_PREFIX}/include/relief/${_folder})
endforeach()
