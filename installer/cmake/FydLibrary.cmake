# libfyd: the shared library for other programs, its headers, and what CMake and pkg-config need to find them.
if(CMAKE_LIBRARY_ARCHITECTURE)  # where Debian looks for libraries, below /usr/local and other prefixes too
  set(CMAKE_INSTALL_LIBDIR "lib/${CMAKE_LIBRARY_ARCHITECTURE}")
endif()
include(GNUInstallDirs)
set(FYD_CODECS_FOLDER "${CMAKE_INSTALL_LIBDIR}/fyd")  # of what core/base/codecs/codecs.cpp loads
include(CMakePackageConfigHelpers)

# fyd_with_included(OUT HEADER…): the headers, paths below the source folder, and all of ours that they include.
function(fyd_with_included out)
  set(wanted ${ARGN})
  set(found "")
  while(wanted)
    list(POP_FRONT wanted header)
    if(NOT header IN_LIST found)
      list(APPEND found "${header}")
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${header}")
      file(STRINGS "${PROJECT_SOURCE_DIR}/${header}" includes REGEX "^#include \"core/")
      foreach(line IN LISTS includes)
        string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included "${line}")
        list(APPEND wanted "${included}")
      endforeach()
    endif()
  endwhile()
  list(SORT found)
  set(${out} ${found} PARENT_SCOPE)
endfunction()

# fyd_library(OBJECTS HEADER…): makes libfyd from these objects and installs it with the headers.
function(fyd_library objects)
  fyd_with_included(headers ${ARGN})
  set_property(GLOBAL PROPERTY FYD_PUBLIC_HEADERS "${headers}")  # tests/library and the API pages read it

  add_library(fyd_library SHARED ${objects})
  add_library(Fyd::fyd ALIAS fyd_library)
  set(map "${PROJECT_SOURCE_DIR}/installer/library/libfyd.map")
  set_target_properties(fyd_library PROPERTIES OUTPUT_NAME fyd EXPORT_NAME fyd LINKER_LANGUAGE CXX LINK_DEPENDS "${map}"
    VERSION ${PROJECT_VERSION} SOVERSION 0 LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
  target_compile_features(fyd_library PUBLIC cxx_std_20)
  target_include_directories(fyd_library INTERFACE "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/fyd>")
  target_link_libraries(fyd_library
    PUBLIC fmt::fmt tl::expected Eigen3::Eigen opencv_core
    PRIVATE $<TARGET_PROPERTY:fyd_core,LINK_LIBRARIES>)
  target_link_options(fyd_library PRIVATE "LINKER:--version-script=${map}" LINKER:--as-needed LINKER:-z,defs)

  install(TARGETS fyd_library EXPORT FydTargets
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library NAMELINK_COMPONENT development)
  foreach(header IN LISTS headers)
    get_filename_component(folder "${header}" DIRECTORY)
    install(FILES "${PROJECT_SOURCE_DIR}/${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/fyd/${folder}"
      COMPONENT development)
  endforeach()

  set(package "${CMAKE_INSTALL_LIBDIR}/cmake/Fyd")
  install(EXPORT FydTargets NAMESPACE Fyd:: DESTINATION "${package}" COMPONENT development)
  configure_package_config_file("${PROJECT_SOURCE_DIR}/installer/library/FydConfig.cmake.in"
    "${CMAKE_CURRENT_BINARY_DIR}/FydConfig.cmake" INSTALL_DESTINATION "${package}")
  write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/FydConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/FydConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/FydConfigVersion.cmake"
    DESTINATION "${package}" COMPONENT development)

  # Relative to itself, so that it also holds below a prefix that is given at installation.
  file(RELATIVE_PATH up "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
  string(REGEX REPLACE "/$" "" FYD_PC_UP "${up}")
  list(JOIN OpenCV_INCLUDE_DIRS " -isystem " FYD_PC_OPENCV)
  configure_file("${PROJECT_SOURCE_DIR}/installer/library/fyd.pc.in" "${CMAKE_CURRENT_BINARY_DIR}/fyd.pc" @ONLY)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/fyd.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
    COMPONENT development)
endfunction()
