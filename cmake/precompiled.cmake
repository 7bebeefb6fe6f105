# With CSGSIM_PRECOMPILE the headers that most of the code includes are compiled once: for the libraries, and for the
# tests. The presets debug and lint go without, so that each file is seen to include what it names. What only some files
# include, as nlohmann/json and CLI11, stays out: GCC would instantiate its templates, and copy its virtual functions, in
# every file.
option(CSGSIM_PRECOMPILE "Compile the headers that most files include once" OFF)

# csgsim_precompiled_headers(NAME LINK... HEADERS...): the library that holds them; csgsim_use_precompiled names it.
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
