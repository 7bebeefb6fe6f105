# Tables of the house are rows, a file each: `extern const TYPE NAME{...};`. Their names, in the order of the table, stand in the
# CMakeLists.txt of their folder alone.
#
# csgsim_rows(OUTPUT HEADERS NAMESPACE TYPE FUNCTION NAMES...): writes OUTPUT into the build folder, a source that defines
# `std::span<const TYPE* const> FUNCTION()` of the namespace, as the first of the headers declares it.
function(csgsim_rows output headers namespace type function)
  set(includes "")
  foreach(header IN LISTS headers)
    string(APPEND includes "#include \"${header}\"\n")
  endforeach()
  set(declarations "")
  set(rows "")
  foreach(name IN LISTS ARGN)
    if(NOT name MATCHES "::")  # of another namespace, whose header declares it
      string(APPEND declarations "extern const ${type} ${name};\n")
    endif()
    string(APPEND rows "    &${name},\n")
  endforeach()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/rows.cpp.in ${output} @ONLY)
endfunction()
