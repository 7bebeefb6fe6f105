include(CMakePackageConfigHelpers)

# Three components: the program, the Python module, and the libraries (cmake/package.cmake makes a package of each); and
# the compiled files of the Python module's wheel.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME csgsim)
set(module_dir ${CMAKE_INSTALL_LIBDIR}/csgsim)
set(data_dir ${CMAKE_INSTALL_DATADIR}/csgsim)

install(TARGETS csgsim)
foreach(part IN ITEMS PICTURES TEXT VIEWER)
  if(CSGSIM_${part})
    string(TOLOWER ${part} name)
    install(TARGETS csgsim_${name}_module LIBRARY DESTINATION ${module_dir})
  endif()
endforeach()
file(RELATIVE_PATH module_from_program /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${module_dir})
# The run path of the build is the longer one, so installing does not pad it with empty entries, which mean the current
# folder.
set_target_properties(csgsim PROPERTIES INSTALL_RPATH $ORIGIN/${module_from_program}
  BUILD_RPATH "$ORIGIN;$ORIGIN/${module_from_program}")

# The program generates these files itself: ${CSGSIM_DESCRIPTION} (sim/shell/manual). Zsh has no folder read by all
# systems.
set(CSGSIM_ZSH_COMPLETIONS ${CMAKE_INSTALL_DATADIR}/zsh/site-functions CACHE STRING "Where zsh looks for completion")
install(DIRECTORY ${CSGSIM_DESCRIPTION}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 FILES_MATCHING PATTERN "*.1.gz")
install(FILES ${CSGSIM_DESCRIPTION}/csgsim.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME csgsim)
install(FILES ${CSGSIM_DESCRIPTION}/_csgsim DESTINATION ${CSGSIM_ZSH_COMPLETIONS})
install(FILES ${CSGSIM_DESCRIPTION}/csgsim.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES cmake/debian/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN manifest EXCLUDE PATTERN book EXCLUDE)
# The program contains the machines and processors; the files serve as documentation and as templates for new ones.
install(DIRECTORY hw/machines/ DESTINATION ${data_dir}/machines FILES_MATCHING PATTERN "*.toml")
install(DIRECTORY hw/process/ DESTINATION ${data_dir}/processes FILES_MATCHING PATTERN "*.toml")
install(DIRECTORY hw/processors/ DESTINATION ${data_dir}/processors FILES_MATCHING PATTERN "*.toml")
install(DIRECTORY tests/models tests/scenes DESTINATION ${data_dir}/examples FILES_MATCHING
  PATTERN "*.csg" PATTERN "*.scad" PATTERN "*.toml" PATTERN "README.md" PATTERN solids EXCLUDE)
install(DIRECTORY traces/benchmark/ DESTINATION ${data_dir}/benchmark FILES_MATCHING
  PATTERN "*.toml" PATTERN "*.csv" PATTERN "*.txt" PATTERN "*.png" PATTERN models EXCLUDE)
install(FILES ${CSGSIM_SUITE_MODELS} DESTINATION ${data_dir}/benchmark/models)
install(DIRECTORY tests/corpus/parts DESTINATION ${data_dir}/examples)
# Links of the pages that lead out of docs/.
install(CODE "
  set(root \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\")
  cmake_path(ABSOLUTE_PATH root)
  execute_process(COMMAND \${CMAKE_COMMAND} -DDOCS=\${root}/${CMAKE_INSTALL_DOCDIR} -DDATA=\${root}/${data_dir}
    -P \"${PROJECT_SOURCE_DIR}/cmake/install_docs.cmake\" COMMAND_ERROR_IS_FATAL ANY)")

if(CSGSIM_PYTHON)
  set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME python)
  set(python_dir lib/python3/dist-packages)
  if(NOT EXISTS /etc/debian_version)
    execute_process(COMMAND ${CSGSIM_PYTHON_PROGRAM} -c
      "import os, sys, sysconfig; print(os.path.relpath(sysconfig.get_path('platlib'), sys.prefix))"
      OUTPUT_VARIABLE python_dir OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  endif()
  set(CSGSIM_PYTHON_DIR ${python_dir} CACHE STRING "Where Python looks for modules")
  file(RELATIVE_PATH module_from_python /prefix/${CSGSIM_PYTHON_DIR}/csgsim /prefix/${module_dir})
  # Modules are beside it in a wheel.
  set_target_properties(csgsim_python PROPERTIES INSTALL_RPATH "$ORIGIN;$ORIGIN/${module_from_python}"
    BUILD_RPATH "$ORIGIN/../..;$ORIGIN/${module_from_python}")
  install(TARGETS csgsim_python LIBRARY DESTINATION ${CSGSIM_PYTHON_DIR}/csgsim)
  install(DIRECTORY sim/python/csgsim/ DESTINATION ${CSGSIM_PYTHON_DIR}/csgsim FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN py.typed)
  # The compiled files of the wheel (setup.py): the prefix is the folder of the package.
  set(modules csgsim_python csgsim_pictures_module csgsim_text_module)
  if(NOT CSGSIM_PICTURES)
    list(REMOVE_ITEM modules csgsim_pictures_module)
  endif()
  if(NOT CSGSIM_TEXT)
    list(REMOVE_ITEM modules csgsim_text_module)
  endif()
  install(TARGETS ${modules} LIBRARY DESTINATION . COMPONENT wheel EXCLUDE_FROM_ALL)
endif()

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
get_property(rooms GLOBAL PROPERTY CSGSIM_ROOMS)
install(TARGETS ${rooms} EXPORT csgsimTargets)
foreach(folder hw host sim)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/csgsim FILES_MATCHING PATTERN "*.h"
    PATTERN "sim/app" EXCLUDE PATTERN "sim/python" EXCLUDE PATTERN "sim/web" EXCLUDE)
endforeach()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/csgsim)
install(EXPORT csgsimTargets NAMESPACE csgsim:: DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/csgsimConfigVersion.cmake COMPATIBILITY SameMinorVersion)
configure_package_config_file(cmake/csgsimConfig.cmake.in ${PROJECT_BINARY_DIR}/csgsimConfig.cmake
  INSTALL_DESTINATION ${package_dir} PATH_VARS module_dir NO_CHECK_REQUIRED_COMPONENTS_MACRO)
install(FILES ${PROJECT_BINARY_DIR}/csgsimConfig.cmake ${PROJECT_BINARY_DIR}/csgsimConfigVersion.cmake
  DESTINATION ${package_dir})

# Used by builds without CMake. The libraries depend on one another in both directions, so they are searched as a group.
set(minizip_module "")
if(CSGSIM_CONVERT)
  set(minizip_module "minizip ")
endif()
set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH prefix_from_pkgconfig /prefix/${pkgconfig_dir} /prefix)
set(room_libraries "")
foreach(room IN LISTS rooms)
  get_target_property(type ${room} TYPE)
  if(type STREQUAL STATIC_LIBRARY)
    string(APPEND room_libraries "-l${room} ")
  endif()
endforeach()
configure_file(cmake/csgsim.pc.in ${PROJECT_BINARY_DIR}/csgsim.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/csgsim.pc DESTINATION ${pkgconfig_dir})
