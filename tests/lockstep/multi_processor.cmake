# The multi-processor. Each row: the seed of a machine's parameters, and a number of models.
add_executable(lockstep_multi_processor multi_processor.cpp)
target_link_libraries(lockstep_multi_processor PRIVATE csgsim_agree csgsim::kinds fmt::fmt csgsim_flags)
foreach(seed RANGE 1 24)
  csgsim_lockstep_row(lockstep_multi_processor "multi-processor ${seed}" "${seed} 25")
endforeach()

csgsim_test(multi_processor APART
  SOURCES test_multi_processor.cpp
  LINK csgsim::read csgsim::emit csgsim::cycle csgsim::functional csgsim::kinds
  LABELS lockstep)
