# Debian packages, made by setup/package.sh: mwt (programs, studies), libmwt-dev (library, headers), python3-mwt (module).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mwt)
set(CPACK_PACKAGE_VENDOR "The developers of the laboratory for minimum weight triangulation")
set(CPACK_PACKAGE_CONTACT "The developers of the laboratory for minimum weight triangulation <developers@mwt.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL program development python)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME mwt)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "python3:any")  # the study `rivals` runs a Python program
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "python3-pandas, python3-matplotlib, python3-jinja2")  # mwt report --page, --paper
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "libmwt-dev, python3-mwt, python3-scipy, gcc")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "minimum weight triangulation: programs and studies
mwt triangulates points in the plane by heuristics and exact algorithms,
certifies weights, and measures how far triangulations are from the proved
optimum. mwt_verify checks proofs of optimality.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libmwt-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# What dependencies.cmake finds when a program calls find_package(mwt).
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libboost-iostreams-dev, libfmt-dev, libglpk-dev, libhwy-dev, libmpfi-dev, libssl-dev, libtbb-dev, libzstd-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS cmake)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "minimum weight triangulation: C++ library
Headers, static libraries and find_package(mwt): points in, checked
triangulation and certified interval out.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-mwt)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
math(EXPR next_python "${Python_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_python}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "minimum weight triangulation: Python module
NumPy arrays in and out: triangulations, proved optima with certified
intervals, families of points, the checker and the verifier of proofs.")

# Every package has its licence and its changes, where Debian's policy wants them.
set(changelog ${PROJECT_BINARY_DIR}/documents/changelog)
execute_process(COMMAND ${PROJECT_SOURCE_DIR}/setup/packaging/changelog.sh ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}
                        "${CPACK_PACKAGE_CONTACT}" ${changelog} COMMAND_ERROR_IS_FATAL ANY)
foreach(component_and_package program:mwt development:libmwt-dev python:python3-mwt)
  string(REPLACE ":" ";" pair ${component_and_package})
  list(GET pair 0 component)
  list(GET pair 1 package)
  install(FILES setup/packaging/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
  install(FILES ${changelog}/changelog.Debian.gz ${changelog}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
          COMPONENT ${component})
endforeach()
include(CPack)
