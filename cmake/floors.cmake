# A floor of the house is a static library of all sources in its folder and two levels below, tests and mains left out.
function(mwt_add_floor floor)
  file(GLOB sources CONFIGURE_DEPENDS ${floor}/*.cpp ${floor}/*/*.cpp ${floor}/*/*/*.cpp)
  list(FILTER sources EXCLUDE REGEX "_(test|main)\\.cpp$")
  add_library(mwt_${floor} STATIC ${sources})
  target_link_libraries(mwt_${floor} PUBLIC mwt_compiler)
endfunction()
