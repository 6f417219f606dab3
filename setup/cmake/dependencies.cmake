# Everything from Debian packages; setup/packages.txt lists them. What the installed library needs is in a file of its own.
include(library/dependencies.cmake)

set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE ON)
find_package(CGAL REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(benchmark REQUIRED)
find_package(GTest REQUIRED)
find_package(SQLiteCpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
mwt_find_library(HTTPLIB::HTTPLIB httplib.h cpp-httplib)
