# The frame-buffer machine with its link. Each row sets parameters of one machine; planes.cpp has the defaults.
add_executable(lockstep_planes planes.cpp)
target_link_libraries(lockstep_planes PRIVATE csgsim_agree csgsim::kinds fmt::fmt csgsim_flags)
foreach(row IN ITEMS
    "degree=1" "link=1 depth=1" "link=1 depth=300 latency=3" "link=2 depth=7 word=2" "link=7 depth=3 latency=1 word=3 clear=5"
    "link=13 depth=2 latency=9 fan_in=2" "link=16 depth=1 latency=2 fan_in=64 clear=40"
    "link=32 depth=16 latency=4 clear=72 fan_in=8" "link=32 depth=1 fan_in=3 clear=1" "link=32 depth=4 word=7 latency=1"
    "link=33 depth=5 latency=30 clear=2 fan_in=5" "link=64 depth=2 latency=2 fan_in=65536 reads=2 alu=4"
    "link=64 depth=1 word=50 latency=50" "link=128 depth=3 latency=100 clear=100" "link=255 depth=1 clear=13"
    "link=256 depth=1 fan_in=2" "link=256 depth=2 latency=1 clear=3" "link=256 depth=65536 word=2 programs=40"
    "link=256 width=1 height=1 bits=8 depth=1 fan_in=2" "link=4 width=1 height=1 bits=8 depth=2 latency=5"
    "buffers=2 bits=72" "buffers=2 shared=1 bits=72"
    "buffers=2 shared=1 bits=64 width=70 height=3 pixels=2 link=32 fan_in=4 clear=20"
    "buffers=2 shared=1 bits=64 width=1 height=1 pixels=3 link=24 word=2"
    "buffers=2 shared=1 bits=80 width=21 height=40 pixels=4 clear=72 link=32 latency=4 fan_in=8 programs=40"
    "buffers=2 bits=64 width=30 height=5 pixels=7 alu=4 reads=2 link=32 depth=2 instructions=5"
    "buffers=2 shared=1 bits=64 width=64 height=2 instructions=5"
    "shared=1" "shared=1 pixels=3 width=21 height=3" "pixels=8 width=9 height=2" "shared=1 pixels=100 width=1 height=1"
    "shared=1 pixels=2 width=130 height=4 bits=64 programs=40" "pixels=2 width=50 height=1" "link=32 width=70 height=5 bits=33 fan_in=7 clear=20 depth=16 latency=4"
    "link=24 width=130 height=3 bits=64 fan_in=64 clear=9 depth=2 word=3 programs=40"
    "stepped=1" "stepped=1 degree=1" "stepped=1 width=1 height=1 bits=8 link=32" "stepped=1 width=70 height=5 bits=33 degree=1 link=64"
    "stepped=1 width=5 height=70 bits=48 alu=4 reads=2 link=64" "stepped=1 width=1 height=37 link=32" "stepped=1 width=130 height=1 degree=1"
    "stepped=1 buffers=2 shared=1 bits=64 width=21 height=40 pixels=4 clear=9 link=32 latency=4 fan_in=8 programs=40"
    "stepped=1 width=64 height=64 bits=72 alu=2 programs=25"
    "link=32 width=64 height=64 bits=72 fan_in=64 clear=72 depth=16 latency=4 programs=25"
    "alu=2 trees=2" "alu=32 trees=32 reads=2" "degree=1 alu=4 trees=3 link=32 depth=4" "alu=8 trees=5 width=70 height=3 bits=64 link=64 latency=9 depth=2"
    "alu=32 trees=17 width=1 height=1 bits=8 link=64" "alu=7 trees=7 reads=2 width=21 height=40 bits=72 fan_in=8 clear=9 word=2 programs=40"
    "degree=1 alu=16 trees=16 buffers=2 shared=1 bits=80 width=30 height=5 pixels=3 link=32 latency=4"
    "stepped=1 alu=3 trees=3" "stepped=1 alu=32 trees=32 degree=1 width=130 height=1" "stepped=1 alu=8 trees=6 reads=2 width=5 height=70 bits=48 link=64"
    "stepped=1 alu=4 trees=4 width=64 height=64 bits=72 programs=25" "stepped=1 alu=16 trees=11 width=1 height=37 link=32"
    "levels=2" "levels=3 degree=1 link=32 latency=9" "levels=16" "levels=2 width=1 height=37 link=32 fan_in=4" "levels=5 width=70 height=3 bits=64 alu=8 trees=5"
    "levels=4 buffers=2 shared=1 bits=80 width=21 height=40 pixels=4 clear=72 link=32 fan_in=8 programs=40"
    "stepped=1 levels=2" "stepped=1 levels=3 degree=1 width=130 height=5" "stepped=1 levels=7 width=37 height=1" "stepped=1 levels=2 alu=4 trees=3 width=21 height=40 bits=48 reads=2"
    "stepped=1 levels=16 alu=32 trees=32 width=70 height=5 bits=33 link=64")
  csgsim_lockstep_row(lockstep_planes "planes ${row}" "${row}")
endforeach()
