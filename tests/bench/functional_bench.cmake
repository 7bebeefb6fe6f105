find_package(benchmark REQUIRED)

add_executable(bench_functional ${PROJECT_SOURCE_DIR}/tests/bench/functional_bench.cpp)
target_include_directories(bench_functional PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(bench_functional PRIVATE csgsim::functional csgsim::pixel_planes benchmark::benchmark csgsim_flags)
