# Everything the compiler must know about our own code, on one target: fyd_flags.
add_library(fyd_flags INTERFACE)
target_compile_features(fyd_flags INTERFACE cxx_std_20)
target_include_directories(fyd_flags INTERFACE "${PROJECT_SOURCE_DIR}")
target_compile_options(fyd_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
                       -Wno-missing-field-initializers)  # designated initialisers leave the rest to its default
# A recording must replay bit for bit: no contraction that depends on the surrounding code.
target_compile_options(fyd_flags INTERFACE -ffp-contract=off)
target_compile_definitions(fyd_flags INTERFACE FYD_VERSION="${PROJECT_VERSION}")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # it would begin at 128 MB to look for memory that it could use again
  target_compile_options(fyd_flags INTERFACE --param=ggc-min-heapsize=524288)
endif()
if(FYD_WARNINGS_AS_ERRORS)
  target_compile_options(fyd_flags INTERFACE -Werror)
endif()
if(FYD_SANITIZE)
  target_compile_options(fyd_flags INTERFACE -fsanitize=${FYD_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(fyd_flags INTERFACE -fsanitize=${FYD_SANITIZE})
  if(FYD_SANITIZE MATCHES "thread" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(fyd_flags INTERFACE -Wno-tsan)  # asio's headers hold a fence that its code here never uses
  endif()
endif()

# Hardened, as Debian's packages are (hardening-check names each); position-independent programs are GCC's default there.
if(NOT FYD_SANITIZE AND NOT FYD_BUILD_FUZZERS AND NOT FYD_COVERAGE)
  target_compile_options(fyd_flags INTERFACE -fstack-protector-strong -fstack-clash-protection -Werror=format-security)
  target_compile_definitions(fyd_flags INTERFACE $<$<CONFIG:Release>:_FORTIFY_SOURCE=2>)  # it needs an optimised build
  target_link_options(fyd_flags INTERFACE LINKER:-z,relro LINKER:-z,now)
endif()
# The folder of the source is in no object: built in two places, a program is the same to the byte.
# Counted, an object must say where its counts are read.
if(FYD_COVERAGE)
  set(FYD_COUNTED --coverage -fprofile-update=atomic)
  if(FYD_COVERAGE STREQUAL "all")
    target_compile_options(fyd_flags INTERFACE ${FYD_COUNTED})
  endif()
  target_link_options(fyd_flags INTERFACE --coverage)
  target_sources(fyd_flags INTERFACE "${PROJECT_SOURCE_DIR}/tests/coverage/own_counts.cpp")
  target_compile_definitions(fyd_flags INTERFACE FYD_COUNTS="${PROJECT_BINARY_DIR}/counts")
else()
  target_compile_options(fyd_flags INTERFACE "-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.")
endif()

find_program(FYD_CCACHE ccache)
if(FYD_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers carry time stamps; ccache must be told not to mind. It must look at the headers themselves
  # (CCACHE_DEPEND), not at preprocessed text: there a header of which only a comment changed is the same, and the precompiled
  # one that ccache then gives holds another file's checksum for its "#pragma once", so the header is compiled twice. What a
  # cache holds from before this is not asked (CCACHE_NAMESPACE).
  set(CMAKE_CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND};-E;env;CCACHE_DEPEND=1;CCACHE_NAMESPACE=fyd-depend"
      "CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime;${FYD_CCACHE}")
endif()
find_program(FYD_LLD ld.lld)
if(FYD_LLD)
  target_link_options(fyd_flags INTERFACE -fuse-ld=lld)
endif()
