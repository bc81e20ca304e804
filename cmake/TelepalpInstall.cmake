# What an installation holds: programs, viewer, data, documents, man pages, shell completion, service units. The same
# files make the Debian package: see deploy/package.
set(TELEPALP_DATADIR ${CMAKE_INSTALL_DATADIR}/telepalp)  # laid out as the repository: see support/program/shipped.h

# A build directory elsewhere finds the repository's data by this file, not by a path within a program.
file(WRITE ${PROJECT_BINARY_DIR}/telepalp_source.txt "${PROJECT_SOURCE_DIR}\n")

install(DIRECTORY ${PROJECT_BINARY_DIR}/viewer DESTINATION ${TELEPALP_DATADIR})
install(DIRECTORY haptic_station/scenes DESTINATION ${TELEPALP_DATADIR}/haptic_station
  FILES_MATCHING PATTERN "*.scene.textproto")
install(DIRECTORY deploy/demo_data DESTINATION ${TELEPALP_DATADIR}/deploy PATTERN "*.py" EXCLUDE)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES README.md CHANGELOG.md LICENSE proto/WIRE.md clients/viewer/THIRD_PARTY.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(PROGRAMS deploy/demo DESTINATION ${CMAKE_INSTALL_BINDIR} RENAME telepalp-demo)
install(FILES deploy/service/telepalp-server.service deploy/service/telepalp-station.service
  DESTINATION lib/systemd/system)
install(FILES deploy/service/telepalp.sysusers.conf DESTINATION lib/sysusers.d RENAME telepalp.conf)

# pam_limits reads /etc alone, so a package (prefix /usr) puts the file there; another prefix has its own etc.
install(CODE "
  cmake_path(GET CMAKE_INSTALL_PREFIX PARENT_PATH root)
  if(NOT CMAKE_INSTALL_PREFIX MATCHES \"/usr$\")
    set(root \${CMAKE_INSTALL_PREFIX})
  elseif(root STREQUAL \"/\")
    set(root \"\")
  endif()
  file(INSTALL ${PROJECT_SOURCE_DIR}/deploy/service/telepalp.limits.conf RENAME telepalp.conf
    DESTINATION \${root}/etc/security/limits.d)")

# Man pages and completion are written from each program's own --help, so that they cannot differ from it.
get_property(programs GLOBAL PROPERTY TELEPALP_PROGRAMS)
list(TRANSFORM programs REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE program_files)
list(JOIN program_files " " program_files)
install(CODE "
  execute_process(COMMAND sh ${PROJECT_SOURCE_DIR}/deploy/service/write_help_pages
    ${PROJECT_BINARY_DIR}/help_pages ${PROJECT_SOURCE_DIR}/deploy/demo ${program_files}
    COMMAND_ERROR_IS_FATAL ANY)")
install(DIRECTORY ${PROJECT_BINARY_DIR}/help_pages/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
install(FILES ${PROJECT_BINARY_DIR}/help_pages/completion
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME telepalp-server)
foreach(program telepalp-demo ${programs})
  if(NOT program STREQUAL telepalp-server)
    install(FILES ${PROJECT_BINARY_DIR}/help_pages/completion
      DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ${program})
  endif()
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME telepalp)
set(CPACK_PACKAGE_VENDOR telepalp)
set(CPACK_PACKAGE_CONTACT "telepalp <telepalp@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "examine a patient by touch, across a network")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "bash, util-linux, coreutils")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/deploy/service/postinst ${PROJECT_SOURCE_DIR}/deploy/service/prerm
    ${PROJECT_SOURCE_DIR}/deploy/service/conffiles)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
