# Code specific to the functional engine: numbers in lanes, blocks classified by their corners, instruction sets,
# wrapping, tiles.
csgsim_test(functional_lockstep APART
  SOURCES ${PROJECT_SOURCE_DIR}/tests/lockstep/functional_lockstep_test.cpp
  LINK csgsim_lockstep_check csgsim_random_program csgsim::functional csgsim::reference rapidcheck fmt::fmt hwy::hwy
  LABELS lockstep)
