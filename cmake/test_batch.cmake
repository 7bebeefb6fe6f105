# cmake -DOUTPUT=FILE "-DSOURCES=FILE;..." -P test_batch.cmake: writes a file that compiles several test files at once,
# each in a separate namespace, since they use the same names for similar things. Their includes come before the
# namespaces, where include guards then suppress them.
set(includes "")
set(files "")
set(number 0)
foreach(source IN LISTS SOURCES)
  file(STRINGS ${source} unfit REGEX "^(namespace [A-Za-z_:]+ {|template <> ?struct [a-z]+::)" LIMIT_COUNT 1)
  if(unfit)
    message(FATAL_ERROR "${source}: a file with '${unfit}' cannot be compiled in a namespace with others; "
      "give it the property SKIP_UNITY_BUILD_INCLUSION")
  endif()
  file(STRINGS ${source} lines REGEX "^#include ")
  list(APPEND includes ${lines})
  math(EXPR number "${number} + 1")
  string(APPEND files "namespace file_${number} {\n#include \"${source}\"\n}\n")
endforeach()
list(REMOVE_DUPLICATES includes)
list(JOIN includes "\n" includes)
file(WRITE ${OUTPUT} "${includes}\n\n${files}")
