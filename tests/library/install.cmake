# Installs what belongs to the library, as a package would: -DBUILD=… -DPREFIX=….
file(REMOVE_RECURSE "${PREFIX}")
foreach(component library development)
  execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --component ${component} --prefix "${PREFIX}"
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
