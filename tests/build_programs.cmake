# SPDX-License-Identifier: GPL-3.0-or-later
# Build all test programs in the directory BINARY_DIR. deal.II's script of a test takes a guard file (interrupt_guard.cc)
# that is in place for the trace of an interrupted run, and links the program again; where the file is put aside, as the
# script does after a run, it does not. So they are put in place for the build and aside after it.
file(GLOB_RECURSE _guards ${BINARY_DIR}/tests/interrupt_guard.cc)
if(_guards)
  file(REMOVE ${_guards})
endif()
file(GLOB_RECURSE _guards ${BINARY_DIR}/tests/interrupt_guard.cc_bck)
foreach(_guard ${_guards})
  string(REGEX REPLACE "_bck$" "" _name ${_guard})
  file(RENAME ${_guard} ${_name})
endforeach()

execute_process(COMMAND ${CMAKE_COMMAND} --build ${BINARY_DIR} --target test_programs RESULT_VARIABLE _status)

file(GLOB_RECURSE _guards ${BINARY_DIR}/tests/interrupt_guard.cc)
foreach(_guard ${_guards})
  file(RENAME ${_guard} ${_guard}_bck)
endforeach()
if(NOT _status EQUAL 0)
  message(FATAL_ERROR "The test programs were not built.")
endif()
