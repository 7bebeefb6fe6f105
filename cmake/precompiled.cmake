# With CSGSIM_PRECOMPILE, the most frequently included headers are compiled once for the libraries, and once for the
# tests. The presets debug and lint do not use them, to check that each file includes what it uses. Headers used by only
# some files, such as nlohmann/json and CLI11, are left out: GCC would instantiate their templates, and copy their
# virtual functions, in
# every file.
option(CSGSIM_PRECOMPILE "Compile the headers that most files include once" OFF)

# csgsim_precompiled_headers(NAME LINK... HEADERS...): defines the library for csgsim_use_precompiled.
function(csgsim_precompiled_headers name)
  cmake_parse_arguments(OF "" "" "LINK;HEADERS" ${ARGN})
  if(NOT CSGSIM_PRECOMPILE)
    return()
  endif()
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/precompiled/${name}.cpp CONTENT "")
  add_library(csgsim_precompiled_${name} STATIC ${PROJECT_BINARY_DIR}/precompiled/${name}.cpp)
  target_link_libraries(csgsim_precompiled_${name} PUBLIC ${OF_LINK} PRIVATE csgsim_flags)
  target_precompile_headers(csgsim_precompiled_${name} PRIVATE ${OF_HEADERS})
endfunction()

function(csgsim_use_precompiled target name)
  if(CSGSIM_PRECOMPILE)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:csgsim_precompiled_${name}>)
    target_precompile_headers(${target} REUSE_FROM csgsim_precompiled_${name})
  endif()
endfunction()

set(csgsim_common_headers <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <optional>
  <set> <span> <stdexcept> <string> <string_view> <utility> <variant> <vector> <fmt/format.h> <glm/geometric.hpp>)
csgsim_precompiled_headers(rooms LINK fmt::fmt glm::glm HEADERS ${csgsim_common_headers})
if(CSGSIM_PRECOMPILE)
  set_target_properties(csgsim_precompiled_rooms PROPERTIES POSITION_INDEPENDENT_CODE ON)
endif()
# GCC 13 and later reject a precompiled header of another optimisation level.
set(CSGSIM_SHELL_PRECOMPILED OFF)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
  set(CSGSIM_SHELL_PRECOMPILED ON)
  csgsim_precompiled_headers(shell LINK csgsim_shell_flags fmt::fmt glm::glm HEADERS ${csgsim_common_headers})
  if(CSGSIM_PRECOMPILE)
    set_target_properties(csgsim_precompiled_shell PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
endif()
