# The language, the warnings, the sanitizers: the same for every layer.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# The layers also go into a Python module. With hidden names, calls are as direct as in a program.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

add_library(mwt_compiler INTERFACE)
# For building only: programs that use the installed library choose their own flags.
target_include_directories(mwt_compiler INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
# No contraction of a*b+c: the same points and the same error bounds on every platform.
target_compile_options(mwt_compiler INTERFACE
                       "$<BUILD_INTERFACE:-ffp-contract=off;-Wall;-Wextra;-Wshadow;-Wconversion;-Wpedantic>")
if(MWT_WARNINGS_AS_ERRORS)
  target_compile_options(mwt_compiler INTERFACE $<BUILD_INTERFACE:-Werror>)
endif()
if(MWT_SANITIZE)
  target_compile_options(mwt_compiler INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(mwt_compiler INTERFACE -fsanitize=address,undefined)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # ccache caches objects that use a precompiled header only with these settings and -fpch-preprocess.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE_PROGRAM})
  set(MWT_PRECOMPILED_HEADER_FLAGS -fpch-preprocess)
endif()
