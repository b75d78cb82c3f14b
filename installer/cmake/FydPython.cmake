# The library in Python: `import fyd`, for Debian's own interpreter, with Debian's pybind11.
#
# It links the archive Fyd::core, hidden, not libfyd: libfyd promises no binary compatibility before 1.0, so a module that
# carries its own copy cannot meet another; and it opens scenes and meshes, which libfyd does not. Not where sanitizers
# or fuzzers are built in: the interpreter is without them.
if(EXISTS "/usr/bin/python3" AND NOT DEFINED Python_EXECUTABLE)
  set(Python_EXECUTABLE "/usr/bin/python3")  # the first on the path may be another, without Debian's modules
endif()
set(PYBIND11_FINDPYTHON ON)
find_package(Python 3.11 COMPONENTS Interpreter Development.Module QUIET)
if(Python_FOUND)
  find_package(pybind11 2.10 CONFIG QUIET)
endif()
set(FYD_BUILD_PYTHON AUTO CACHE STRING "Build the Python module: ON, OFF, or AUTO: where pybind11 is installed")
if(FYD_BUILD_PYTHON STREQUAL "AUTO")  # decided anew at each configuration, so that OFF for one build does not stay
  set(FYD_BUILD_PYTHON OFF)
  if(pybind11_FOUND AND NOT FYD_SANITIZE AND NOT FYD_BUILD_FUZZERS AND NOT CMAKE_CROSSCOMPILING)
    set(FYD_BUILD_PYTHON ON)
  endif()
endif()
if(NOT FYD_BUILD_PYTHON)
  return()
endif()
if(NOT pybind11_FOUND)
  message(FATAL_ERROR "FYD_BUILD_PYTHON: needs Debian's pybind11-dev and python3-dev")
endif()
set(FYD_PYTHON_DIR "${PROJECT_BINARY_DIR}/python")  # what PYTHONPATH names

# fyd_python(PACKAGE SOURCE…): the package's compiled half; the other half is linked beside it in the build folder.
function(fyd_python package)
  pybind11_add_module(fyd_python MODULE NO_EXTRAS ${ARGN})
  fyd_unity(fyd_python "${CMAKE_CURRENT_SOURCE_DIR}" ${ARGN})
  target_link_libraries(fyd_python PRIVATE Fyd::core)
  # What takes time is computed in the core: what stands between it and Python needs no more than a quick compilation.
  target_compile_options(fyd_python PRIVATE $<$<CONFIG:Release>:-O1>)
  target_include_directories(fyd_python SYSTEM PRIVATE ${pybind11_INCLUDE_DIR} ${Python_INCLUDE_DIRS})
  # Python looks for one symbol; another module, or libfyd, meets none of ours.
  set(exports "${CMAKE_CURRENT_SOURCE_DIR}/exports.map")
  target_link_options(fyd_python PRIVATE LINKER:--version-script=${exports} LINKER:--as-needed)
  set_target_properties(fyd_python PROPERTIES LINK_DEPENDS "${exports}")
  set_target_properties(fyd_python PROPERTIES OUTPUT_NAME _fyd LIBRARY_OUTPUT_DIRECTORY "${FYD_PYTHON_DIR}/fyd"
    BUILD_RPATH_USE_ORIGIN ON)
  file(GLOB files CONFIGURE_DEPENDS "${package}/*.py" "${package}/*.pyi" "${package}/py.typed")
  file(MAKE_DIRECTORY "${FYD_PYTHON_DIR}/fyd")
  foreach(file IN LISTS files)
    get_filename_component(name "${file}" NAME)
    file(CREATE_LINK "${file}" "${FYD_PYTHON_DIR}/fyd/${name}" SYMBOLIC)
  endforeach()
  # Debian's interpreter looks for packages of all its versions below /usr alone, elsewhere for those of its own. Which
  # prefix it is, only the installation knows: it may be given then, and is when a package is made.
  install(CODE "set(fyd_python_folder \"lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}\")
if(CMAKE_INSTALL_PREFIX STREQUAL \"/usr\")
  set(fyd_python_folder \"lib/python3\")
endif()" COMPONENT python)
  set(destination "\${fyd_python_folder}/dist-packages/fyd")
  install(TARGETS fyd_python LIBRARY DESTINATION "${destination}" COMPONENT python)
  install(FILES ${files} DESTINATION "${destination}" COMPONENT python)
endfunction()
