# A table is a list of rows. Each row is `extern const TYPE NAME{...};` in its own file; the names are listed, in the
# order of the table, only in the folder's CMakeLists.txt.
#
# csgsim_rows(OUTPUT HEADERS NAMESPACE TYPE FUNCTION NAMES...): writes the source OUTPUT into the build folder. It defines
# `std::span<const TYPE* const> FUNCTION()` in the namespace, as declared by the first header.
function(csgsim_rows output headers namespace type function)
  set(includes "")
  foreach(header IN LISTS headers)
    string(APPEND includes "#include \"${header}\"\n")
  endforeach()
  set(declarations "")
  set(rows "")
  foreach(name IN LISTS ARGN)
    if(NOT name MATCHES "::")  # otherwise another header declares it
      string(APPEND declarations "extern const ${type} ${name};\n")
    endif()
    string(APPEND rows "    &${name},\n")
  endforeach()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/rows.cpp.in ${output} @ONLY)
endfunction()

# csgsim_embed(OUTPUT HEADER NAMESPACE FUNCTION FOLDER NAMES...): writes the source OUTPUT into the build folder. It
# defines `std::span<const machines::BuiltIn> FUNCTION()` in the namespace, as declared by the header: each NAME with
# the
# text of FOLDER/NAME.toml.
function(csgsim_embed output header namespace function folder)
  cmake_path(ABSOLUTE_PATH folder NORMALIZE)
  set(rows "")
  foreach(name IN LISTS ARGN)
    cmake_path(APPEND folder ${name}.toml OUTPUT_VARIABLE file)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(APPEND rows "    {\"${name}\", R\"toml(${text})toml\"},\n")
  endforeach()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/embedded.cpp.in ${output} @ONLY)
endfunction()
