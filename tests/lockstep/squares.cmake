# The pixel-square machine. Each row are figures of one machine; those that it does not name are as in squares.cpp.
add_executable(lockstep_squares squares.cpp)
target_link_libraries(lockstep_squares PRIVATE csgsim_agree csgsim::kinds fmt::fmt csgsim_flags)
foreach(row IN ITEMS
    "degree=1" "depth=1" "depth=1 renderers=2 port=24 link_width=17" "depth=1 renderers=3 buffers=2 port=24 move=1"
    "depth=1 buffers=2 word=3 latency=11" "depth=2 renderers=2 buffers=2 port=24 port_depth=2 move=3 clear=5"
    "depth=2 order=1 port=1000 link_width=256" "depth=2 renderers=3 port=1 programs=15 link_width=1"
    "depth=3 renderers=3 buffers=2 port=1 programs=15 move=2 link_width=6" "depth=3 order=2 renderers=2 clear=1"
    "depth=7 renderers=2 buffers=2 port=24 port_depth=7 order=2" "depth=7 renderers=3 buffers=2 port=1000 move=32"
    "depth=1000 renderers=1 buffers=2 port=24 move=1 clear=40" "depth=1000 renderers=2 buffers=1 port=1 programs=15"
    "depth=1000 renderers=3 buffers=2 port=24 order=1 link_width=256 move=5"
    "depth=5 renderers=3 buffers=1 port=24 port_depth=5 word=2"
    "depth=64 renderers=4 buffers=2 port=32 port_depth=64 width=4 height=4 move=1 clear=40"
    "depth=1 renderers=5 buffers=2 port=3 width=2 height=2 picture_width=7 picture_height=9"
    "width=5 height=3 picture_width=33 picture_height=11 renderers=2 buffers=2 depth=2 port=24 port_depth=2 move=1"
    "width=5 height=3 picture_width=33 picture_height=11 renderers=3 depth=1 port=1000 order=1 reads=2 clear=100"
    "width=70 height=9 picture_width=33 picture_height=7 renderers=2 buffers=2 depth=3 port=24 reads=2 move=7"
    "width=1 height=1 picture_width=5 picture_height=4 renderers=3 buffers=2 depth=1 port=24 bits=8 programs=200"
    "width=1 height=1 picture_width=5 picture_height=4 renderers=2 buffers=1 depth=2 port=1 bits=33 programs=200"
    "width=1 height=1 picture_width=5 picture_height=4 renderers=3 buffers=2 depth=9 port=65 port_depth=3 move=2 programs=200"
    "width=16 height=16 picture_width=40 picture_height=33 renderers=2 buffers=2 depth=64 port=32 bits=72 programs=15 move=1 clear=72"
    "divider=1 bits=200 depth=1 port=24 programs=15"
    "divider=1 bits=200 depth=40 levels=2 group=2 list=1000 port=24 renderers=2 buffers=2 move=1 clear=9 programs=15"
    "divider=1 bits=200 depth=3 levels=2 group=3 list=12 port=32 port_depth=9 link_width=9 word=2 latency=7 programs=15"
    "divider=1 bits=200 depth=1000 levels=2 group=1 list=0 order=2 box=0 halfspace=0 cell=0 node=0 link_width=256 programs=15"
    "divider=1 bits=200 depth=64 levels=2 group=2 list=40 order=1 box=2 halfspace=4 cell=3 node=5 link_width=1 renderers=3 programs=10"
    "divider=1 bits=200 depth=8 levels=2 group=2 list=40 store=1 record=1 linear=3 port=24 programs=15"
    "divider=1 bits=200 depth=1 levels=2 group=2 list=1000 store=9 record=70 halfspaces=5 nodes=1 linear=2 node=2 port=24 renderers=2 programs=15"
    "divider=1 bits=200 depth=64 store=40 dividers=3 record=256 halfspace=9 cell=2 node=2 linear=1 port=24 renderers=3 buffers=2 move=1 programs=15"
    "divider=1 bits=200 depth=5 levels=2 group=2 list=9 store=2 dividers=2 record=13 linear=7 port=24 renderers=2 programs=15"
    "depth=1000 latch=1 port=24" "depth=64 latch=1 port=7 renderers=2 port_depth=3" "depth=64 latch=3 port=500 renderers=3"
    "width=5 height=3 picture_width=33 picture_height=11 renderers=2 latch=5 depth=9 port=33 port_depth=2"
    "width=1 height=1 picture_width=5 picture_height=4 renderers=3 latch=2 depth=9 port=65 programs=200"
    "depth=64 renderers=3 buffers=2 port=24 hz=20000 refresh=7 refresh_bits=100 refresh_clocks=3"
    "depth=64 renderers=3 buffers=1 latch=2 port=9 banks=3 hz=50000 refresh=60 refresh_bits=33"
    "depth=64 renderers=4 buffers=2 port=5 banks=2 port_depth=9" "depth=9 renderers=2 port=13 banks=9 hz=9973 refresh=1 refresh_bits=7"
    "depth=64 renderers=3 buffers=2 port=24 pictures=2 hz=100 refresh=60"
    "divider=1 bits=200 depth=64 levels=2 group=2 list=1000 record=32 port=24 renderers=3 latch=1 banks=4 hz=90000 refresh=30 refresh_bits=64 refresh_clocks=2 programs=15"
    "stepped=1 degree=1 depth=9 port=24" "stepped=1 depth=64 renderers=3 buffers=2 port=24 move=1 programs=20"
    "stepped=1 width=5 height=3 picture_width=33 picture_height=11 renderers=2 depth=2 port=24 port_depth=2"
    "stepped=1 divider=1 bits=200 depth=64 levels=2 group=2 list=1000 record=32 port=24 renderers=2 programs=10"
    "divider=2 ring=32" "divider=2 depth=1 processors=3 ring=24 port_depth=1" "divider=2 processors=2 renderers=3 ring=17 channels=1 buffers=2 move=1"
    "divider=2 processors=4 renderers=2 ring=32 channels=2 ring_word=3 latency=7 depth=5 port_depth=3 clear=9"
    "divider=2 processors=3 renderers=4 ring=64 channels=8 ring_word=2 buffers=2 move=3 banks=2 hz=90000 refresh=30 refresh_bits=64 refresh_clocks=2"
    "divider=2 processors=9 renderers=1 ring=6 ring_word=2 depth=2 port_depth=2 banks=3 programs=15"
    "divider=2 processors=3 renderers=3 ring=256 channels=3 width=4 height=4 order=2 latch=1 port_depth=9 depth=64"
    "divider=2 processors=5 renderers=3 ring=1 channels=4 width=5 height=3 picture_width=33 picture_height=11 depth=3 port_depth=1 programs=15"
    "divider=2 width=1 height=1 picture_width=5 picture_height=4 processors=3 renderers=5 ring=65 channels=2 ring_word=3 banks=2 bits=8 port_depth=2 programs=200"
    "stepped=1 divider=2 processors=2 renderers=2 ring=32 channels=3 ring_word=2 programs=20"
    "latency=300 word=7 depth=4 renderers=2 buffers=2 port=24 move=4 clear=3" "word=2 depth=1 port=24"
    "width=1 height=1 picture_width=3 picture_height=7 bits=16 depth=1000 link_width=6 latency=7 clear=2 port=13 programs=200"
    "width=1 height=1 picture_width=3 picture_height=7 bits=16 depth=1 link_width=6 clear=2 port=7 move=1 programs=200")
  csgsim_lockstep_row(lockstep_squares "squares ${row}" "${row}")
endforeach()

csgsim_test(pixel_square
  SOURCES test_pixel_square.cpp
  LINK csgsim::cycle csgsim::functional
  LABELS lockstep)
