# Compiles the values of harness/run/machine/build_info.h into the harness. Every build queries the commit, but rewrites the file
# (and compiles it again) only when a value has changed.
if(CMAKE_SCRIPT_MODE_FILE)
  find_program(GIT git)
  set(GIT_COMMIT "unknown")
  if(GIT)
    execute_process(COMMAND ${GIT} describe --always --abbrev=40 --dirty --exclude=*
                    WORKING_DIRECTORY ${SOURCE_FOLDER} OUTPUT_VARIABLE described RESULT_VARIABLE failed
                    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT failed)
      set(GIT_COMMIT ${described})
    endif()
  endif()
  configure_file(${SOURCE_FOLDER}/setup/cmake/build_info.cpp.in ${OUTPUT} @ONLY)
  return()
endif()

set(build_info ${PROJECT_BINARY_DIR}/build_info.cpp)
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
set(all_flags "${CMAKE_BUILD_TYPE} ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} -ffp-contract=off")
string(REGEX REPLACE " +" " " all_flags "${all_flags}")
add_custom_target(mwt_build_info BYPRODUCTS ${build_info} COMMENT "Querying the commit"
  COMMAND ${CMAKE_COMMAND} -DSOURCE_FOLDER=${PROJECT_SOURCE_DIR} -DOUTPUT=${build_info}
          -DPROGRAM_VERSION=${PROJECT_VERSION}
          "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" "-DCOMPILER_FLAGS=${all_flags}"
          -P ${CMAKE_CURRENT_LIST_FILE} VERBATIM)
target_sources(mwt_harness PRIVATE ${build_info})
add_dependencies(mwt_harness mwt_build_info)
