# Debian's SystemC exports only the C++17 API symbol.
add_library(csgsim_systemc INTERFACE)
add_library(csgsim::systemc ALIAS csgsim_systemc)
set_target_properties(csgsim_systemc PROPERTIES EXPORT_NAME systemc)
target_compile_definitions(csgsim_systemc INTERFACE SC_CPLUSPLUS=201703L)
target_link_libraries(csgsim_systemc INTERFACE systemc Threads::Threads)
set_property(GLOBAL APPEND PROPERTY CSGSIM_ROOMS csgsim_systemc)
