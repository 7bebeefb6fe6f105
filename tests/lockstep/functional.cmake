# What the functional engine does its own way: numbers in lanes, instruction sets, wrapping, bands of rows.
csgsim_test(functional_lockstep
  SOURCES ${PROJECT_SOURCE_DIR}/tests/lockstep/functional_lockstep_test.cpp
  LINK csgsim_lockstep csgsim_random_program csgsim::functional csgsim::reference rapidcheck fmt::fmt hwy::hwy
  LABELS lockstep)
