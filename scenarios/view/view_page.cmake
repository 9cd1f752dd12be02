# The frame of the page that `tandem view` writes: page.html with styles, licences and scripts in the places of its
# @...@ marks. Arguments: SOURCE (the folder of the page), OUTPUT, LIBRARIES and STYLES (files, with | between),
# LICENCES (files, with | between), SCRIPTS (names in SOURCE, with | between).
function(join_files to before after)
  set(all "")
  foreach(file ${ARGN})
    file(READ "${file}" text)
    string(REGEX REPLACE "//# sourceMappingURL=[^\n]*" "" text "${text}") # it names a file that is not there
    string(REGEX REPLACE "/[*]# sourceMappingURL=[^\n]*" "" text "${text}")
    string(FIND "${text}" "</script" ends_script)
    if(NOT ends_script EQUAL -1)
      message(FATAL_ERROR "${file} holds </script, so it can't stand in a page")
    endif()
    string(APPEND all "${before}" "${text}" "${after}")
  endforeach()
  set(${to} "${all}" PARENT_SCOPE)
endfunction()

foreach(list LIBRARIES STYLES LICENCES SCRIPTS)
  string(REPLACE "|" ";" ${list} "${${list}}")
endforeach()
list(TRANSFORM SCRIPTS PREPEND "${SOURCE}/")

join_files(libraries "<script>\n" "\n</script>\n" ${LIBRARIES})
join_files(scripts "<script>\n" "</script>\n" ${SCRIPTS})
join_files(styles "" "\n" ${STYLES} "${SOURCE}/style.css")
join_files(licences "" "\n\n" ${LICENCES})
string(REPLACE "&" "&amp;" licences "${licences}")
string(REPLACE "<" "&lt;" licences "${licences}")

file(READ "${SOURCE}/page.html" page)
foreach(part styles licences scripts libraries)
  string(REPLACE "@${part}@" "${${part}}" page "${page}")
endforeach()
file(WRITE "${OUTPUT}" "${page}")
