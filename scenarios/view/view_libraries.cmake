# What the page of `tandem view` is made of, if Debian's packages are there: sets TANDEM_VIEW_PAGE to the file of its
# frame, which is made at build time. Without them the command says what is missing.
set(javascript /usr/share/javascript)
set(view_libraries ${javascript}/three/three.min.js ${javascript}/three/examples/js/controls/OrbitControls.js
  ${javascript}/three/examples/js/math/ConvexHull.js ${javascript}/dygraphs/dygraph.min.js)
set(view_styles ${javascript}/dygraphs/dygraph.min.css)
set(view_licences /usr/share/doc/libjs-three/copyright /usr/share/doc/libjs-dygraphs/copyright)
set(view_scripts format.js data.js clock.js theme.js shapes.js mechanism.js ground.js scene.js plots.js controls.js main.js)

foreach(file ${view_libraries} ${view_styles} ${view_licences})
  if(NOT EXISTS ${file})
    message(STATUS "tandem view left out, as ${file} is absent (packages libjs-three, libjs-dygraphs)")
    return()
  endif()
endforeach()

set(view_folder ${CMAKE_CURRENT_SOURCE_DIR}/page)
list(TRANSFORM view_scripts PREPEND ${view_folder}/ OUTPUT_VARIABLE view_files)
set(TANDEM_VIEW_PAGE ${CMAKE_CURRENT_BINARY_DIR}/generated/view_page.html)
foreach(list libraries styles licences scripts)
  string(REPLACE ";" "|" view_${list}_text "${view_${list}}")
endforeach()
add_custom_command(OUTPUT ${TANDEM_VIEW_PAGE}
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${view_folder} -D OUTPUT=${TANDEM_VIEW_PAGE}
    -D "LIBRARIES=${view_libraries_text}" -D "STYLES=${view_styles_text}" -D "LICENCES=${view_licences_text}"
    -D "SCRIPTS=${view_scripts_text}" -P ${CMAKE_CURRENT_SOURCE_DIR}/view_page.cmake
  DEPENDS ${view_files} ${view_folder}/page.html ${view_folder}/style.css ${view_libraries} ${view_styles}
    ${view_licences} ${CMAKE_CURRENT_SOURCE_DIR}/view_page.cmake
  COMMENT "Making the page of tandem view" VERBATIM)
add_custom_target(tandem_view_page DEPENDS ${TANDEM_VIEW_PAGE})
add_dependencies(tandem_view tandem_view_page)
set_source_files_properties(page.cpp PROPERTIES OBJECT_DEPENDS ${TANDEM_VIEW_PAGE}
  COMPILE_DEFINITIONS TANDEM_VIEW_PAGE="${TANDEM_VIEW_PAGE}")
