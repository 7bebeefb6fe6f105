# The multi-processor. Each row: the seed of a machine's figures, and a number of Programs.
add_executable(lockstep_multi_processor multi_processor.cpp parts.cpp row.cpp)
target_link_libraries(lockstep_multi_processor PRIVATE
  csgsim_lockstep csgsim_random_program csgsim::reference csgsim::functional csgsim::cycle fmt::fmt csgsim_flags)
foreach(seed RANGE 1 24)
  csgsim_lockstep_row(lockstep_multi_processor "multi-processor ${seed}" "${seed} 25")
endforeach()
