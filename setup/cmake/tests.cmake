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
# Scripts: optimised builds only, for sanitizers find nothing in Python, and their runtime is no business of programs of others. They
# take long, so that they begin before the many short tests. Exit code 77: what the script needs is missing, and it says what.
function(mwt_add_script_test name label timeout)
  if(NOT MWT_SANITIZE)
    add_test(NAME ${name} COMMAND ${ARGN})
    set_tests_properties(${name} PROPERTIES LABELS ${label} TIMEOUT ${timeout} SKIP_RETURN_CODE 77 COST 100)
  endif()
endfunction()

set(python /usr/bin/python3)
set(source ${PROJECT_SOURCE_DIR})
# A program of somebody else, built against the installed library; the Python module; the Debian packages.
mwt_add_script_test(library.consumer library 600 ${source}/library/examples/consumer_test.sh ${PROJECT_BINARY_DIR})
mwt_add_script_test(library.python library 600 ${python} ${source}/library/python/mwt_test.py ${PROJECT_BINARY_DIR}/python)
mwt_add_script_test(library.notebooks library 600 ${python} ${source}/library/examples/notebooks/notebook_test.py ${PROJECT_BINARY_DIR}/python)
mwt_add_script_test(library.packages slow 900 ${source}/setup/packaging/package_test.sh ${PROJECT_BINARY_DIR})
if(TEST library.packages)
  set_tests_properties(library.packages PROPERTIES RUN_SERIAL ON)
endif()
# mwt cluster on a Slurm of the test's own; skipped, with the reason, where none can be started.
set(cluster_tests ${source}/harness/study/cluster/testing)
mwt_add_script_test(harness.cluster slow 3000 ${cluster_tests}/with_slurm.sh 4 ${python} ${cluster_tests}/cluster_test.py $<TARGET_FILE:mwt>)
# A second program with 1% more instructions in one kernel, whose counts must tell it from the first.
mwt_add_script_test(harness.more_instructions slow 1200 ${python} ${source}/harness/tracking/testing/more_instructions_test.py ${PROJECT_BINARY_DIR})
# What figures compute; the pages, in a headless Chromium: that of the claims, that of another study, its figure explorer, that of two studies, the
# dashboard of nightly runs, the explorer, its tour; what mwt report --paper writes.
mwt_add_script_test(plots.figures plots 600 ${python} ${source}/plots/figures_test.py)
mwt_add_script_test(plots.page plots 600 ${python} ${source}/plots/page_test.py $<TARGET_FILE:mwt>)
mwt_add_script_test(plots.foreign_page plots 600 ${python} ${source}/plots/foreign_page_test.py $<TARGET_FILE:mwt>)
mwt_add_script_test(plots.figure_explorer slow 600 ${python} ${source}/plots/figure_explorer_test.py $<TARGET_FILE:mwt>)
mwt_add_script_test(plots.comparison_page slow 600 ${python} ${source}/plots/comparison_page_test.py $<TARGET_FILE:mwt>)
mwt_add_script_test(plots.dashboard plots 600 ${python} ${source}/plots/dashboard_test.py $<TARGET_FILE:mwt>)
mwt_add_script_test(plots.tour plots 600 ${python} ${source}/plots/tour_test.py $<TARGET_FILE:mwt>)
# With the tests of its statistics. Half a minute goes into drawing for LaTeX.
mwt_add_script_test(plots.paper slow 1200 ${python} ${source}/plots/paper_test.py $<TARGET_FILE:mwt> --compile)
mwt_add_script_test(harness.explorer_page harness 600 ${python} ${source}/harness/explore/page_test.py $<TARGET_FILE:mwt>)
