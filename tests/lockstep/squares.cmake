# The pixel-square machine. Each row are figures of one machine; those that it does not name are as in squares.cpp.
add_executable(lockstep_squares squares.cpp)
target_link_libraries(lockstep_squares PRIVATE
  csgsim_lockstep csgsim_random_program csgsim::reference csgsim::functional csgsim::cycle fmt::fmt csgsim_flags)
foreach(row IN ITEMS
    "depth=1" "depth=1 renderers=2 port=24" "depth=1 renderers=3 buffers=2 port=24" "depth=1 buffers=2 host=3"
    "depth=2 renderers=2 buffers=2 port=24" "depth=2 order=1 port=1000" "depth=2 renderers=3 port=1 programs=15"
    "depth=3 renderers=3 buffers=2 port=1 programs=15" "depth=3 order=2 renderers=2"
    "depth=7 renderers=2 buffers=2 port=24 order=2" "depth=7 renderers=3 buffers=2 port=1000"
    "depth=1000 renderers=1 buffers=2 port=24" "depth=1000 renderers=2 buffers=1 port=1 programs=15"
    "depth=1000 renderers=3 buffers=2 port=24 order=1" "depth=5 renderers=3 buffers=1 port=24"
    "depth=64 renderers=4 buffers=2 port=32 width=4 height=4 primitive=0 halfspace=0"
    "depth=1 renderers=5 buffers=2 port=3 width=2 height=2 picture_width=7 picture_height=9 primitive=0 halfspace=0"
    "width=5 height=3 picture_width=33 picture_height=11 renderers=2 buffers=2 depth=2 port=24"
    "width=5 height=3 picture_width=33 picture_height=11 renderers=3 depth=1 port=1000 order=1 reads=2"
    "width=70 height=9 picture_width=33 picture_height=7 renderers=2 buffers=2 depth=3 port=24 reads=2"
    "width=1 height=1 picture_width=5 picture_height=4 renderers=3 buffers=2 depth=1 port=24 bits=8 programs=200"
    "width=1 height=1 picture_width=5 picture_height=4 renderers=2 buffers=1 depth=2 port=1 bits=33 programs=200"
    "width=16 height=16 picture_width=40 picture_height=33 renderers=2 buffers=2 depth=64 port=32 bits=72 programs=15"
    "halfspace=100 primitive=30 host=7 depth=4 renderers=2 buffers=2 port=24" "host=2 depth=1 port=24")
  csgsim_lockstep_row(lockstep_squares "squares ${row}" "${row}")
endforeach()

csgsim_test(pixel_square
  SOURCES test_pixel_square.cpp
  LINK csgsim::cycle csgsim::functional
  LABELS lockstep)
