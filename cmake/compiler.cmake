# Flags of the project's own code; exported targets carry none of them.
add_library(csgsim_flags INTERFACE)
set(CSGSIM_SANITIZED 0)
if(CSGSIM_SANITIZE)
  set(CSGSIM_SANITIZED 1)
endif()
target_compile_options(csgsim_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wswitch-enum -Wnon-virtual-dtor
  # GCC 12 falsely reports overlapping and overlong copies in std::string (GCC bugs 105329, 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-array-bounds -Wno-stringop-overflow>
  # Floating-point results are the same on every computer and at every optimisation level.
  -ffp-contract=off)
# Flags of code that is never time-critical: the command line, pages, plots.
add_library(csgsim_shell_flags INTERFACE)
target_compile_options(csgsim_shell_flags INTERFACE $<$<CONFIG:Release>:-O1>)
if(CSGSIM_SANITIZE)
  # Null and alignment checks of each pointer would add a quarter to the compile time; a null pointer crashes anyway.
  add_compile_options(-fsanitize=${CSGSIM_SANITIZE} -fno-sanitize=null,alignment,object-size -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${CSGSIM_SANITIZE})
endif()
# Fewer Highway targets in sanitized builds: each target is a copy of every loop, and the checks multiply them. The two
# remaining targets cover the code of the others.
set(CSGSIM_FEWER_TARGETS "HWY_DISABLED_TARGETS=(HWY_AVX3_DL|HWY_AVX3|HWY_SSE4)")
# About a hundred programs are linked; lld takes a third of the time of GNU's linker. Not with GCC 12: lld 14 then loses
# exception handlers.
if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  include(CheckLinkerFlag)
  check_linker_flag(CXX -fuse-ld=lld CSGSIM_HAS_LLD)
  if(CSGSIM_HAS_LLD)
    add_link_options(-fuse-ld=lld)
  endif()
endif()

# csgsim_library(NAME SOURCES... [LINK LIBS...]): a library of one folder, included from the top as "folder/file.h".
function(csgsim_library name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(csgsim_${name} STATIC ${ROOM_SOURCES})
  add_library(csgsim::${name} ALIAS csgsim_${name})
  set_target_properties(csgsim_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(csgsim_${name} PUBLIC cxx_std_20)
  target_include_directories(csgsim_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/csgsim>)
  target_link_libraries(csgsim_${name} PUBLIC ${ROOM_LINK} PRIVATE $<BUILD_INTERFACE:csgsim_flags> ${ROOM_PRIVATE_LINK})
  if("$<BUILD_INTERFACE:csgsim_shell_flags>" IN_LIST ROOM_PRIVATE_LINK AND CSGSIM_SHELL_PRECOMPILED)
    csgsim_use_precompiled(csgsim_${name} shell)
  else()
    csgsim_use_precompiled(csgsim_${name} rooms)
  endif()
  set_property(GLOBAL APPEND PROPERTY CSGSIM_ROOMS csgsim_${name})
endfunction()

# csgsim_embed_files(VARIABLE PATHS...): the texts of files, rows {name without folders, text} of C++.
function(csgsim_embed_files variable)
  set(rows "")
  foreach(path IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
    get_filename_component(name ${path} NAME)
    file(READ ${path} text)
    string(APPEND rows "    {\"${name}\", R\"csgsim(${text})csgsim\"},\n")
  endforeach()
  set(${variable} "${rows}" PARENT_SCOPE)
endfunction()
