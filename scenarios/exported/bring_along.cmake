# Copies into the folder of LIBRARY the libraries that it needs and that not every system has.
file(GET_RUNTIME_DEPENDENCIES LIBRARIES ${LIBRARY} RESOLVED_DEPENDENCIES_VAR needed
  PRE_EXCLUDE_REGEXES "^lib(c|m|stdc\\+\\+|gcc_s|asan|ubsan|tsan)[.]so" "^ld-linux")
get_filename_component(folder ${LIBRARY} DIRECTORY)
foreach(file IN LISTS needed)
  get_filename_component(name ${file} NAME)
  if(NOT file STREQUAL ${folder}/${name})
    file(COPY_FILE ${file} ${folder}/${name})
  endif()
endforeach()
