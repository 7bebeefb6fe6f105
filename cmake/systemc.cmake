# The library of SystemC and the version of its API. SystemC's headers refer to a symbol of the language standard that the
# library was built for: C++17 in Debian's packages, others elsewhere.
function(csgsim_find_systemc_standard output)
  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_LIBRARIES ${SYSTEMC_LIBRARY} Threads::Threads)
  set(CMAKE_REQUIRED_INCLUDES ${SYSTEMC_INCLUDE_DIR})
  foreach(standard IN ITEMS 201703L 202002L 201402L 201103L)
    set(CMAKE_REQUIRED_DEFINITIONS -DSC_CPLUSPLUS=${standard})
    check_cxx_source_compiles("#include <systemc>
      int sc_main(int, char**) { sc_core::sc_start(); return 0; }" CSGSIM_SYSTEMC_OF_${standard})
    if(CSGSIM_SYSTEMC_OF_${standard})
      set(${output} ${standard} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "a program does not link with ${SYSTEMC_LIBRARY}; CMakeFiles/CMakeConfigureLog.yaml has the reason. "
    "Name another SystemC, 2.3.4 or later, by -DSYSTEMC_LIBRARY=... and -DSYSTEMC_INCLUDE_DIR=...")
endfunction()
csgsim_find_systemc_standard(CSGSIM_SYSTEMC_STANDARD)

add_library(csgsim_systemc INTERFACE)
add_library(csgsim::systemc ALIAS csgsim_systemc)
set_target_properties(csgsim_systemc PROPERTIES EXPORT_NAME systemc)
target_compile_definitions(csgsim_systemc INTERFACE SC_CPLUSPLUS=${CSGSIM_SYSTEMC_STANDARD})
# SystemC 3 calls SC_HAS_PROCESS obsolete, and SystemC 2 needs it; only clang reports its use.
if(SYSTEMC_VERSION VERSION_GREATER_EQUAL 3 AND CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  target_compile_definitions(csgsim_systemc INTERFACE SC_ALLOW_DEPRECATED_IEEE_API)
endif()
target_link_libraries(csgsim_systemc INTERFACE $<BUILD_INTERFACE:${SYSTEMC_LIBRARY}> $<INSTALL_INTERFACE:systemc>
  Threads::Threads)
target_include_directories(csgsim_systemc SYSTEM INTERFACE $<BUILD_INTERFACE:${SYSTEMC_INCLUDE_DIR}>)
set_property(GLOBAL APPEND PROPERTY CSGSIM_ROOMS csgsim_systemc)
