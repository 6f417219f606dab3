# One test program per layer, from the x_test.cpp files beside the code. Suites named ...Slow carry the label `slow`.
include(GoogleTest)

# Half of a build is the compiling of tests, and optimising them costs more than it gains: tests spend their time in the libraries,
# which stay optimised. These flags come after all others; the presets `ci` and `sanitize` set them.
set(MWT_TEST_FLAGS "" CACHE STRING "Further compiler flags for the sources of tests, such as -O0")
separate_arguments(test_flags NATIVE_COMMAND "${MWT_TEST_FLAGS}")

function(mwt_add_tests layer)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${layer}/*_test.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(${layer}_test ${sources})
  target_link_libraries(${layer}_test PRIVATE ${ARGN} GTest::gtest_main)
  target_compile_definitions(${layer}_test PRIVATE MWT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_compile_options(${layer}_test PRIVATE ${test_flags} ${MWT_PRECOMPILED_HEADER_FLAGS})
  if(MWT_UNITY_BUILD)
    mwt_compile_folders_as_units(${layer}_test ${sources})
  endif()
  # Most of what a test's source includes. Nothing else, so that no test compiles without its own includes.
  target_precompile_headers(${layer}_test PRIVATE <gtest/gtest.h>)
  gtest_discover_tests(${layer}_test TEST_PREFIX ${layer}. TEST_FILTER "-*Slow*" DISCOVERY_TIMEOUT 120
                       PROPERTIES LABELS ${layer} TIMEOUT 600)
  gtest_discover_tests(${layer}_test TEST_PREFIX ${layer}. TEST_FILTER "*Slow*" DISCOVERY_TIMEOUT 120
                       TEST_LIST ${layer}_slow_tests PROPERTIES LABELS slow TIMEOUT 3000)
endfunction()

# Point sets that the tests of several layers use.
add_library(mwt_shapes_for_tests STATIC geometry/testing/shapes.cpp)
target_link_libraries(mwt_shapes_for_tests PUBLIC mwt_geometry)

# CGAL: only as an opinion to compare hulls with.
mwt_add_tests(base mwt_base)
mwt_add_tests(geometry mwt_geometry mwt_shapes_for_tests CGAL::CGAL)
mwt_add_tests(generators mwt_generators CGAL::CGAL)
# Algorithms and generators do not include each other; only their tests do.
mwt_add_tests(algorithms mwt_algorithms mwt_generators mwt_shapes_for_tests)
mwt_add_tests(verifier mwt_verifier Boost::headers MPFI::MPFI ZSTD::ZSTD OpenSSL::Crypto)
# Boost, JSON and SQLite: to read results by other means than the harness's own.
mwt_add_tests(harness mwt_harness mwt_shapes_for_tests Boost::headers Boost::iostreams ZSTD::ZSTD nlohmann_json::nlohmann_json SQLiteCpp)
mwt_add_tests(library mwt_library mwt_base)
# The harness's tests also run the programs as their users do.
if(TARGET harness_test)
  target_compile_definitions(harness_test PRIVATE MWT_EXECUTABLE="$<TARGET_FILE:mwt>"
                             MWT_VERIFY_EXECUTABLE="$<TARGET_FILE:mwt_verify>"
                             MWT_BENCHMARK_EXECUTABLE="$<TARGET_FILE:mwt_benchmark>")
  add_dependencies(harness_test mwt mwt_verify mwt_benchmark)
endif()
# A program of somebody else, built against the installed library. The sanitizers' runtime is none of its business.
if(NOT MWT_SANITIZE)
  add_test(NAME library.consumer COMMAND ${PROJECT_SOURCE_DIR}/library/examples/consumer_test.sh ${PROJECT_BINARY_DIR})
  add_test(NAME library.python COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/library/python/mwt_test.py ${PROJECT_BINARY_DIR}/python)
  add_test(NAME library.notebooks COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/library/examples/notebooks/notebook_test.py
                                          ${PROJECT_BINARY_DIR}/python)
  add_test(NAME library.packages COMMAND ${PROJECT_SOURCE_DIR}/setup/packaging/package_test.sh ${PROJECT_BINARY_DIR})
  set_tests_properties(library.packages PROPERTIES LABELS slow TIMEOUT 900 RUN_SERIAL ON)
  set_tests_properties(library.consumer library.python library.notebooks PROPERTIES LABELS library TIMEOUT 600 SKIP_RETURN_CODE 77)
endif()
# mwt cluster on a Slurm of the test's own; skipped, with the reason, where none can be started. Optimised builds only: what it tests is
# processes and files.
if(NOT MWT_SANITIZE)
  set(cluster_tests ${PROJECT_SOURCE_DIR}/harness/study/cluster/testing)
  add_test(NAME harness.cluster COMMAND ${cluster_tests}/with_slurm.sh 4 /usr/bin/python3 ${cluster_tests}/cluster_test.py $<TARGET_FILE:mwt>)
  set_tests_properties(harness.cluster PROPERTIES LABELS slow TIMEOUT 3000 SKIP_RETURN_CODE 77)
endif()
# A second program with 1% more instructions in one kernel, whose counts must tell it from the first.
if(NOT MWT_SANITIZE)
  add_test(NAME harness.more_instructions COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/harness/tracking/testing/more_instructions_test.py
                                                  ${PROJECT_BINARY_DIR})
  set_tests_properties(harness.more_instructions PROPERTIES LABELS slow TIMEOUT 1200 SKIP_RETURN_CODE 77)
endif()
# What figures compute; the page of the claims, that of another study and the dashboard of nightly runs in a headless Chromium.
# Optimised builds only: sanitizers find nothing in Python.
if(NOT MWT_SANITIZE)
  add_test(NAME plots.figures COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/plots/figures_test.py)
  add_test(NAME plots.page COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/plots/page_test.py $<TARGET_FILE:mwt>)
  add_test(NAME plots.foreign_page COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/plots/foreign_page_test.py $<TARGET_FILE:mwt>)
  add_test(NAME plots.dashboard COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/plots/dashboard_test.py $<TARGET_FILE:mwt>)
  add_test(NAME harness.explorer_page COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/harness/explore/page_test.py $<TARGET_FILE:mwt>)
  add_test(NAME plots.tour COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/plots/tour_test.py $<TARGET_FILE:mwt>)
  set_tests_properties(plots.tour PROPERTIES LABELS plots TIMEOUT 600 SKIP_RETURN_CODE 77)
  set_tests_properties(harness.explorer_page PROPERTIES LABELS harness TIMEOUT 600 SKIP_RETURN_CODE 77)
  add_test(NAME plots.paper COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/plots/paper_test.py $<TARGET_FILE:mwt>)
  add_test(NAME plots.paper_compiles COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/plots/paper_test.py $<TARGET_FILE:mwt> --compile)
  set_tests_properties(plots.paper PROPERTIES LABELS plots TIMEOUT 600 SKIP_RETURN_CODE 77)
  set_tests_properties(plots.paper_compiles PROPERTIES LABELS slow TIMEOUT 1200 SKIP_RETURN_CODE 77)
  set_tests_properties(plots.figures plots.page plots.foreign_page plots.dashboard PROPERTIES LABELS plots TIMEOUT 600 SKIP_RETURN_CODE 77)
endif()
