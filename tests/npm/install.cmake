# Run with cmake -P. npm writes node_modules/.package-lock.json last, so its age tells whether the folder is whole.
set(installed ${CMAKE_CURRENT_LIST_DIR}/node_modules/.package-lock.json)
if(EXISTS ${installed} AND NOT ${CMAKE_CURRENT_LIST_DIR}/package-lock.json IS_NEWER_THAN ${installed})
  return()
endif()
execute_process(COMMAND npm ci --no-audit --no-fund --loglevel=error WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR}
  RESULT_VARIABLE failed OUTPUT_VARIABLE told ERROR_VARIABLE complained)
if(failed)
  message(FATAL_ERROR "npm ci failed in tests/npm: ${failed}. The tests need npm packages from npm's registry. fix: see npm's messages:\n${told}${complained}")
endif()
file(TOUCH ${installed})
