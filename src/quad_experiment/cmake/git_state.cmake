cmake_minimum_required(VERSION 3.18)
# Writes OUTPUT with the commit of SOURCE_DIR; touches it only when the commit changes, so that little is rebuilt.
execute_process(
  COMMAND git -C ${SOURCE_DIR} describe --always --dirty --abbrev=12
  OUTPUT_VARIABLE state OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(state "unknown")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#define QUAD_GIT_STATE \"@state@\"\n" @ONLY)
