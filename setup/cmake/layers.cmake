# A layer is a static library of all sources in its folder and below; tests, what only they use, and mains left out.
function(mwt_add_layer layer)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${layer}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "_(test|main)\\.cpp$|/testing/")
  add_library(mwt_${layer} STATIC ${sources})
  target_link_libraries(mwt_${layer} PUBLIC mwt_compiler)
endfunction()
