# Debian packages by CPack, one for each component: what is installed beside the libraries, and what each package is.
# installer/package.sh builds them; resources/manual/installing.md describes them.
set(resources "${PROJECT_SOURCE_DIR}/resources")
set(package_files "${PROJECT_SOURCE_DIR}/installer/package")
# Programs find scenes and surfaces below share/fyd-console, in the build folder as when installed (core/sim/resources.h).
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/share")
file(CREATE_LINK "${resources}" "${PROJECT_BINARY_DIR}/share/fyd-console" SYMBOLIC)

find_program(FYD_PYTHON3 python3)
if(NOT FYD_PYTHON3 OR NOT CMAKE_SYSTEM_NAME STREQUAL "Linux")
  return()  # the man pages and the rest of what documents.py writes cannot be made
endif()

# Whoever publishes the packages says who and where they are.
set(FYD_MAINTAINER "FYD Console maintainers <maintainers@fyd-console.example.org>" CACHE STRING "Maintainer of the packages")
set(FYD_HOMEPAGE "https://fyd-console.example.org" CACHE STRING "The project's page; its folder images/ has the manual's pictures")
set(revision 0fyd1)  # before a revision 1, which would be Debian's own

if(TARGET fyd-console)
  install(TARGETS fyd-console RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT console)
  install(FILES "${resources}/desktop/fyd-console.desktop" "${resources}/desktop/fyd-console-review.desktop"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/applications" COMPONENT console)
  install(FILES "${resources}/desktop/fyd-console.xml" DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages" COMPONENT console)
  install(FILES "${resources}/icons/fyd-console.svg"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps" COMPONENT console)
endif()
install(TARGETS fyd RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT program)
install(DIRECTORY "${resources}/scenes" "${resources}/textures"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/fyd-console" COMPONENT program)
install(FILES "${PROJECT_SOURCE_DIR}/installer/udev/70-fyd-touchpad.rules" DESTINATION lib/udev/rules.d COMPONENT program)

string(TOUPPER "CMAKE_CXX_FLAGS_${CMAKE_BUILD_TYPE}" flags)
if("${CMAKE_CXX_FLAGS} ${${flags}}" MATCHES "(^| )-g")
  set(binaries "")
  foreach(target fyd fyd-console fyd_library fyd_codecs fyd_python)
    if(TARGET ${target})
      string(APPEND binaries " \"$<TARGET_FILE:${target}>\"")
    endif()
  endforeach()
  install(CODE "execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND \"${package_files}/debug_symbols.sh\"
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\" ${binaries})" COMPONENT symbols)
endif()

# fyd_package(COMPONENT NAME SECTION DEPENDS… TEXT …): the package NAME of the component, if something of it is installed.
# The first line of TEXT is the summary. Libraries that the binaries are linked to come to its dependencies by themselves.
set(CPACK_COMPONENTS_ALL "")
get_cmake_property(fyd_components COMPONENTS)
macro(fyd_package component name section)
  cmake_parse_arguments(one "" "TEXT;RECOMMENDS;SUGGESTS" "DEPENDS;EXTRA" ${ARGN})
  if("${component}" IN_LIST fyd_components)
    string(TOUPPER "${component}" upper)
    list(APPEND CPACK_COMPONENTS_ALL "${component}")
    list(JOIN one_DEPENDS ", " one_DEPENDS)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${name}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION "${section}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${one_DEPENDS}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_RECOMMENDS "${one_RECOMMENDS}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_SUGGESTS "${one_SUGGESTS}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA "${one_EXTRA}")
    set(CPACK_DEBIAN_${upper}_DESCRIPTION "${one_TEXT}")
    # Changelog, copyright, man pages and completion: they are asked of the programs when something is installed.
    install(CODE "execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND \"${FYD_PYTHON3}\" -B \"${package_files}/documents.py\"
      ${component} --package ${name} --version ${PROJECT_VERSION}-${revision}
      --maintainer \"${FYD_MAINTAINER}\" --homepage \"${FYD_HOMEPAGE}\" --programs \"${CMAKE_RUNTIME_OUTPUT_DIRECTORY}\"
      --root \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\")" COMPONENT ${component})
    if(EXISTS "${package_files}/${name}.lintian-overrides")
      install(FILES "${package_files}/${name}.lintian-overrides" DESTINATION "${CMAKE_INSTALL_DATADIR}/lintian/overrides"
        RENAME "${name}" COMPONENT ${component})
    endif()
  endif()
endmacro()

set(same "(= ${PROJECT_VERSION}-${revision})")  # all load the coders of libfyd0, which no binary is linked to
fyd_package(console fyd-console science DEPENDS "fyd ${same}" RECOMMENDS "qt6-translations-l10n" SUGGESTS "qt6-wayland"
  TEXT "operator's window of the FYD Touchpad, a fabric haptic display
The FYD Touchpad lets a person touch something that is far away: two motors
stretch a cloth until it feels as soft or as stiff as what a remote robot
touches, and shake it so that the finger feels the texture.

This package has the window: sessions, calibration, tuning, review and replay
of recordings, in English, Italian and French, with the manual. Without any
hardware it runs on a simulated touchpad and robot.")
fyd_package(program fyd science DEPENDS "libfyd0 ${same}" SUGGESTS "fyd-console, postgresql"
  TEXT "command line of the FYD Touchpad, a fabric haptic display
The FYD Touchpad lets a person touch something that is far away: two motors
stretch a cloth until it feels as soft or as stiff as what a remote robot
touches, and shake it so that the finger feels the texture.

This package has the command line: sessions without a window, the robot's end,
simulated touchpads and robots that speak the real protocols, calibration,
recordings and their replay, predictors for late networks, haptic scenes. With
it come scenes, stored surfaces, and udev rules for the touchpad's ports.")
fyd_package(library libfyd0 libs
  EXTRA "${package_files}/libfyd0/triggers"
  TEXT "haptic algorithms of the FYD Touchpad (shared library)
The computing part of FYD Console for other programs: textures from
accelerations, stiffness control, predictors for late networks, contact with
meshes, recordings and their bit-exact replay.

This package has the shared library, and the coders of pictures and videos,
which the programs load too.")
fyd_package(development libfyd-dev libdevel
  DEPENDS "libfyd0 ${same}" libfmt-dev libexpected-dev libeigen3-dev libopencv-dev
  TEXT "haptic algorithms of the FYD Touchpad (development files)
The computing part of FYD Console for other programs: textures from
accelerations, stiffness control, predictors for late networks, contact with
meshes, recordings and their bit-exact replay.

This package has the headers, and what CMake and pkg-config need to find the
library.")
if("python" IN_LIST fyd_components)  # built for Debian's own interpreter, of exactly this version
  execute_process(COMMAND /usr/bin/python3 -c "import sys; v = sys.version_info; print(f'{v[0]}.{v[1]};{v[0]}.{v[1] + 1}', end='')"
    OUTPUT_VARIABLE python COMMAND_ERROR_IS_FATAL ANY)
  list(GET python 0 python_this)
  list(GET python 1 python_next)
endif()
fyd_package(python python3-fyd python
  SUGGESTS fyd
  DEPENDS "python3 (>= ${python_this}~)" "python3 (<< ${python_next})" python3-numpy "libfyd0 ${same}"
  EXTRA "${package_files}/python3-fyd/postinst" "${package_files}/python3-fyd/prerm"
  TEXT "haptic algorithms of the FYD Touchpad (Python module)
Recordings of the FYD Touchpad as NumPy arrays with units, their replay with
the same or other gains, textures, predictors, sensing and haptic scenes.

This package has the module fyd for Python 3.")

fyd_package(symbols fyd-console-dbg debug RECOMMENDS "fyd ${same}" SUGGESTS gdb
  TEXT "haptic operator console of the FYD Touchpad (debug symbols)
The FYD Touchpad lets a person touch something that is far away: two motors
stretch a cloth until it feels as soft or as stiff as what a remote robot
touches, and shake it so that the finger feels the texture.

This package has the debug symbols of the programs and libraries of FYD
Console, by which gdb shows functions and lines of the source.")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME fyd-console)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_CONTACT "${FYD_MAINTAINER}")
set(CPACK_PACKAGE_HOMEPAGE_URL "${FYD_HOMEPAGE}")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SOURCE fyd-console)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${revision})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}/lib")  # where our own library is not installed yet
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
include(CPack)
