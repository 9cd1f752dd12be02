# Copies into the folder of LIBRARY the libraries that it needs and that not every system has.
get_filename_component(folder ${LIBRARY} DIRECTORY)
file(GLOB before ${folder}/lib*)
if(before)
  file(REMOVE ${before})
endif()
file(GET_RUNTIME_DEPENDENCIES LIBRARIES ${LIBRARY} RESOLVED_DEPENDENCIES_VAR needed
  PRE_EXCLUDE_REGEXES "^lib(c|m|dl|rt|util|pthread|stdc\\+\\+|gcc_s|asan|ubsan|tsan)[.]so" "^ld-linux")
foreach(file IN LISTS needed)
  get_filename_component(name ${file} NAME)
  file(COPY_FILE ${file} ${folder}/${name})
endforeach()
