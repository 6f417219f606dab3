# The library for programs of others: cmake --install puts headers, static libraries and find_package(mwt) in place.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

file(GLOB library_sources CONFIGURE_DEPENDS library/source/*.cpp)
list(FILTER library_sources EXCLUDE REGEX "_test\\.cpp$")
add_library(mwt_library STATIC ${library_sources})
target_include_directories(mwt_library PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/library/include>
                           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(mwt_library PUBLIC cxx_std_20)
target_link_libraries(mwt_library PRIVATE mwt_harness)
set_target_properties(mwt_library PROPERTIES EXPORT_NAME mwt OUTPUT_NAME mwt)

install(TARGETS mwt_library mwt_harness mwt_verifier mwt_algorithms mwt_generators mwt_geometry mwt_base mwt_compiler
        EXPORT mwt-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY library/include/mwt DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/mwt)
install(EXPORT mwt-targets NAMESPACE mwt:: DESTINATION ${config_folder} COMPONENT development)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/mwt-config-version.cmake COMPATIBILITY SameMajorVersion)
install(FILES library/mwt-config.cmake library/dependencies.cmake ${PROJECT_BINARY_DIR}/mwt-config-version.cmake
        DESTINATION ${config_folder} COMPONENT development)

# The Python module, for Debian's Python: build/PRESET/python can be put into PYTHONPATH; pip install library/python installs it.
set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that the module is for")
find_package(Python 3.11 REQUIRED COMPONENTS Interpreter Development.Module)
find_package(pybind11 REQUIRED)
set(python_folder ${PROJECT_BINARY_DIR}/python/mwt)
pybind11_add_module(mwt_python MODULE NO_EXTRAS library/python/mwt/_mwt.cpp)
target_link_libraries(mwt_python PRIVATE mwt_library mwt_compiler)
set_target_properties(mwt_python PROPERTIES OUTPUT_NAME _mwt LIBRARY_OUTPUT_DIRECTORY ${python_folder})
file(GLOB python_sources CONFIGURE_DEPENDS library/python/mwt/*.py library/python/mwt/*.pyi library/python/mwt/py.typed)
add_custom_command(TARGET mwt_python POST_BUILD COMMAND ${CMAKE_COMMAND} -E copy ${python_sources} ${python_folder})
# Debian's Python seeks modules of packages there. Optional: the program and the library install without it.
set(python_module_folder lib/python3/dist-packages)
install(TARGETS mwt_python LIBRARY DESTINATION ${python_module_folder}/mwt COMPONENT python OPTIONAL)
install(FILES ${python_sources} DESTINATION ${python_module_folder}/mwt COMPONENT python)
