# cmake -DSOURCE=… -DOUT=… -P revision.cmake: writes the revision that is built, if it is another one than before.
execute_process(COMMAND git -C "${SOURCE}" describe --always --dirty --abbrev=12 --exclude=*
                OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(revision "unknown")
endif()
file(CONFIGURE OUTPUT "${OUT}" CONTENT "#define FYD_REVISION \"${revision}\"\n")
