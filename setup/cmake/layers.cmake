# A layer is a static library of all sources in its folder and below; tests, what only they use, and mains left out.
function(mwt_add_layer layer)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${layer}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "_(test|main)\\.cpp$|/testing/")
  add_library(mwt_${layer} STATIC ${sources})
  target_link_libraries(mwt_${layer} PUBLIC mwt_compiler)
  if(MWT_UNITY_BUILD)
    mwt_compile_folders_as_units(mwt_${layer} ${sources})
  endif()
endfunction()

# Links what the installed library's users need not have: header-only packages, and libraries of rooms that it does not call.
function(mwt_link_for_building target)
  foreach(library IN LISTS ARGN)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:${library}>)
  endforeach()
endfunction()

# Compiles all sources of a folder together: most of the time of a build is the reading of headers. Names in unnamed namespaces must
# therefore differ within a folder. Kernels stay by themselves: they include themselves once per instruction set.
function(mwt_compile_folders_as_units target)
  list(FILTER ARGN EXCLUDE REGEX "_kernels\\.cpp$")
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # A class private to one source may have members of types from that source's unnamed namespace; GCC takes the source for a header here.
  target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  foreach(source IN LISTS ARGN)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(REPLACE "/" "_" group ${folder})
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()
