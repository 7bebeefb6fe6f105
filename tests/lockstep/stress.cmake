# Machines with generated parameters, each at its bounds or between. Each row: a kind, the first and the last seed, and
# Programs per machine, which RC_PARAMS does not change. Sanitized builds use a third of the machines.
add_executable(lockstep_stress stress.cpp random_machine.cpp)
target_link_libraries(lockstep_stress PRIVATE csgsim_agree csgsim::kinds fmt::fmt csgsim_flags)
set(rows "frame-buffer 1 60 5" "scan-line 1 60 3" "pixel-square 1 90 3" "multi-processor 1 200 3" "bit-serial-memory 1 60 3")
if(CSGSIM_SANITIZED)
  set(rows "frame-buffer 1 20 5" "scan-line 1 20 3" "pixel-square 1 30 3" "multi-processor 1 60 3" "bit-serial-memory 1 20 3")
endif()
foreach(row IN LISTS rows)
  csgsim_lockstep_row(lockstep_stress "stress ${row}" "${row}")
  string(REGEX MATCH "[0-9]+$" programs "${row}")
  set_tests_properties("lockstep: stress ${row}" PROPERTIES ENVIRONMENT "RC_PARAMS=max_success=${programs}")
endforeach()
