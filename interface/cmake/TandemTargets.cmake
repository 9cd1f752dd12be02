# How every target of tandem is compiled, made and installed.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Compile options of our own targets only: linked PRIVATE and inside BUILD_INTERFACE, so never handed on to users.
# Sign conversions are let through, as GCC's -Wconversion does and clang's does not. -Wrestrict raises a false alarm on
# "text" + std::string before GCC 13 (GCC bug 105651).
# No contraction to fused multiply-add, or results differ between processors. (-O3 is CMake's own for Release.)
# Where several sources make one translation unit, a local name may well be that of a constant of another of them.
# Functions of a library call each other directly though the code is position independent. Each has a section of its own, so
# that the library of an FMU has only those that it needs.
add_library(tandem_build_flags INTERFACE)
target_compile_options(tandem_build_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Wshadow
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
  $<$<BOOL:${CMAKE_UNITY_BUILD}>:-Wno-shadow> $<$<BOOL:${TANDEM_WERROR}>:-Werror> -ffp-contract=off -fno-semantic-interposition -ffunction-sections)
if(TANDEM_SANITIZE)
  target_compile_options(tandem_build_flags INTERFACE
    -fsanitize=${TANDEM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>) # Boost.Asio has fences in what nothing here runs; this sanitizer can't see them
  target_link_options(tandem_build_flags INTERFACE -fsanitize=${TANDEM_SANITIZE})
endif()

# Of sources that run once, as they read files: an FMU's library is to be small.
set(TANDEM_SMALL $<$<CONFIG:Release>:-Os>)

# tandem_library(NAME [SMALL] HEADERS ... SOURCES ... [PUBLIC ...] [PRIVATE ...]): the exported target tandem::NAME with the
# public headers below include/; header-only while it has no sources. SMALL: see TANDEM_SMALL.
function(tandem_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "SMALL" "" "HEADERS;SOURCES;PUBLIC;PRIVATE")
  set(target tandem_${name})
  set(scope INTERFACE)
  if(arg_SOURCES)
    set(scope PUBLIC)
    add_library(${target} STATIC ${arg_SOURCES})
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:tandem_build_flags> ${arg_PRIVATE})
    if(arg_SMALL)
      target_compile_options(${target} PRIVATE ${TANDEM_SMALL})
    endif()
  else()
    add_library(${target} INTERFACE)
  endif()
  add_library(tandem::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_sources(${target} ${scope} FILE_SET HEADERS BASE_DIRS include FILES ${arg_HEADERS})
  target_link_libraries(${target} ${scope} ${arg_PUBLIC})
  target_compile_features(${target} ${scope} cxx_std_20)
  install(TARGETS ${target} EXPORT tandemTargets FILE_SET HEADERS)
endfunction()

# What find_package(tandem) reads.
function(tandem_install_package)
  set(destination ${CMAKE_INSTALL_LIBDIR}/cmake/tandem)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/interface/cmake/tandemConfig.cmake.in
    ${PROJECT_BINARY_DIR}/tandemConfig.cmake INSTALL_DESTINATION ${destination})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/tandemConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/tandemConfig.cmake ${PROJECT_BINARY_DIR}/tandemConfigVersion.cmake
    ${PROJECT_SOURCE_DIR}/interface/cmake/TandemSubsystemLibrary.cmake
    ${PROJECT_SOURCE_DIR}/interface/cmake/subsystem_library.cpp.in
    DESTINATION ${destination})
  install(EXPORT tandemTargets NAMESPACE tandem:: DESTINATION ${destination})
endfunction()
