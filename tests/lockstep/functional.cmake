# What the functional engine does its own way: numbers in lanes, blocks decided by their corners, instruction sets, wrapping, tiles.
csgsim_test(functional_lockstep APART
  SOURCES ${PROJECT_SOURCE_DIR}/tests/lockstep/functional_lockstep_test.cpp
  LINK csgsim_lockstep_check csgsim_random_program csgsim::functional csgsim::reference rapidcheck fmt::fmt hwy::hwy
  LABELS lockstep)
