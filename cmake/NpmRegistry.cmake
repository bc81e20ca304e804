# TELEPALP_NPM: whether npm can install packages here. Behind a proxy whose certificate is unknown, or without a network,
# it cannot: then the viewer is taken as it was bundled last (clients/viewer/dist), and the tests that hold telepalp
# against npm's packages are left out, which deploy/test says.
find_program(NPM npm)
find_program(NODE NAMES node nodejs)
if(NOT TELEPALP_NPM AND NPM AND NODE)
  execute_process(COMMAND ${NPM} view esbuild version --fetch-retries=0 --fetch-timeout=15000
    RESULT_VARIABLE npm_failed OUTPUT_QUIET ERROR_QUIET TIMEOUT 60)
  if(npm_failed STREQUAL "0")
    set(TELEPALP_NPM ON CACHE BOOL "npm can install packages")
  endif()
endif()
if(NOT TELEPALP_NPM)
  message(WARNING "npm's registry cannot be reached: the build takes the viewer from clients/viewer/dist, and leaves out "
    "the tests that need npm packages. fix: give this machine access to the registry, then run cmake again")
endif()
