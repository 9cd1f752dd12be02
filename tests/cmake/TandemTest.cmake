# How tests are registered, and the list of those that are not.
find_package(GTest REQUIRED)
include(GoogleTest)
file(WRITE ${PROJECT_BINARY_DIR}/tests_left_out.txt "")

# tandem_leave_out(NAME WHY): notes a test that is not registered.
function(tandem_leave_out name why)
  file(APPEND ${PROJECT_BINARY_DIR}/tests_left_out.txt "${name}: ${why}\n")
endfunction()

# tandem_gtest(LABEL TIMEOUT): the executable tandem_LABEL_tests of all sources below LABEL/, its tests registered one by
# one, each with a limit in seconds.
function(tandem_gtest label timeout)
  # Globbed while the folder still grows by the hour; CONFIGURE_DEPENDS notices a new file at the next build.
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${label}/*.cpp ${label}/*.c)
  if(TANDEM_SANITIZE)
    math(EXPR timeout "10 * ${timeout}")
  endif()
  set(target tandem_${label}_tests)
  add_executable(${target} ${sources})
  # What they test is optimized. At -O1 GCC takes some of Eigen's members for uninitialized.
  target_compile_options(${target} PRIVATE "$<$<CONFIG:Release>:-O1;-Wno-maybe-uninitialized>")
  target_link_libraries(${target} PRIVATE tandem_test_support GTest::gtest_main)
  # At the start of ctest, not of the build, so that a test program that can't start does not break the build.
  gtest_discover_tests(${target} NO_PRETTY_VALUES DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${label} TIMEOUT ${timeout})
endfunction()

# tandem_script_test(NAME COMMAND...): a test that runs a command, mostly a build of its own.
function(tandem_script_test name)
  add_test(NAME ${name} COMMAND ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS slow TIMEOUT 900 PROCESSORS 2)
endfunction()

# tandem_target_test(NAME TARGET): a test that builds a target of this build; one at a time, as they share its folder.
function(tandem_target_test name target)
  tandem_script_test(${name} ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target ${target})
  set_tests_properties(${name} PROPERTIES RESOURCE_LOCK build_folder)
endfunction()
