# Subsystem libraries from files (docs/shared_libraries.md). Part of the package.
set(TANDEM_SUBSYSTEM_LIBRARY_SOURCE ${CMAKE_CURRENT_LIST_DIR}/subsystem_library.cpp.in)

# tandem_add_subsystem_library(NAME FILE): the module NAME, a shared library that lib: loads, of a mechanism's or a
# diagram's TOML file. The text of the file is compiled in; files that it names (tables, records, nested diagrams) are
# read where they stand now.
function(tandem_add_subsystem_library name file)
  get_filename_component(file ${file} ABSOLUTE)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} text)
  if(text MATCHES "(^|\n)[ \t]*\\[*blocks[].= \t]")
    set(kind diagram)
  elseif(text MATCHES "(^|\n)[ \t]*dimension[ \t]*=")
    set(kind mechanism)
  else()
    message(FATAL_ERROR "tandem_add_subsystem_library: ${file} is neither a diagram (it has no blocks) nor a mechanism "
      "(it has no dimension)")
  endif()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.subsystem.cpp)
  configure_file(${TANDEM_SUBSYSTEM_LIBRARY_SOURCE} ${source} @ONLY)
  add_library(${name} MODULE ${source})
  target_link_libraries(${name} PRIVATE tandem::${kind}_source)
  # One symbol is exported, and none of ours is taken from the program that loads it.
  target_link_options(${name} PRIVATE -Wl,--exclude-libs,ALL -Wl,--as-needed)
  set_target_properties(${name} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    UNITY_BUILD OFF)
endfunction()
