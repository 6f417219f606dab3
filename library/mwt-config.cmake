# find_package(mwt 1 REQUIRED), then target_link_libraries(program PRIVATE mwt::mwt).
include(${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/mwt-targets.cmake)
