# What an installation holds: programs, viewer, data, documents, man pages, shell completion, service units. The same
# files make the Debian packages, one for each COMPONENT: see deploy/package.
set(TELEPALP_DATADIR ${CMAKE_INSTALL_DATADIR}/telepalp)  # laid out as the repository: see support/program/shipped.h

# The programs of each package. A thin client installs telepalp-clients alone: no PCL, no driver of a camera.
set(TELEPALP_CLIENTS telepalp-view telepalp-record telepalp-report telepalp-export telepalp-replay telepalp-link
  telepalp-mixed)
set(TELEPALP_SERVER telepalp-server telepalp-keys telepalp-meet)
set(TELEPALP_STATION telepalp-station)
set(TELEPALP_TOOLS telepalp-codec telepalp-probe telepalp-study telepalp-worker)

# A build directory elsewhere finds the repository's data by this file, not by a path within a program.
file(WRITE ${PROJECT_BINARY_DIR}/telepalp_source.txt "${PROJECT_SOURCE_DIR}\n")

install(DIRECTORY ${PROJECT_BINARY_DIR}/viewer DESTINATION ${TELEPALP_DATADIR} COMPONENT server)
install(DIRECTORY haptic_station/scenes DESTINATION ${TELEPALP_DATADIR}/haptic_station COMPONENT data
  FILES_MATCHING PATTERN "*.scene.textproto")
install(DIRECTORY deploy/demo_data DESTINATION ${TELEPALP_DATADIR}/deploy COMPONENT data PATTERN "*.py" EXCLUDE)
install(DIRECTORY tools/study/designer/page DESTINATION ${TELEPALP_DATADIR}/tools/study/designer COMPONENT tools)
install(DIRECTORY tools/study/protocol/page DESTINATION ${TELEPALP_DATADIR}/tools/study/protocol COMPONENT tools)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT data)
install(FILES README.md CHANGELOG.md LICENSE proto/WIRE.md clients/viewer/THIRD_PARTY.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT data)
install(FILES deploy/service/telepalp.sysusers.conf DESTINATION lib/sysusers.d COMPONENT data RENAME telepalp.conf)
install(PROGRAMS deploy/demo DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT demo RENAME telepalp-demo)
install(FILES deploy/service/telepalp-server.service deploy/service/telepalp-meet.service DESTINATION lib/systemd/system COMPONENT server)
install(DIRECTORY deploy/monitoring DESTINATION ${TELEPALP_DATADIR} COMPONENT server)
install(FILES deploy/service/telepalp-relay.conf DESTINATION ${CMAKE_INSTALL_DATADIR}/telepalp COMPONENT server)
install(FILES deploy/service/telepalp-station.service DESTINATION lib/systemd/system COMPONENT station)

# pam_limits reads /etc alone, so a package (prefix /usr) puts the file there; another prefix has its own etc.
install(CODE "
  cmake_path(GET CMAKE_INSTALL_PREFIX PARENT_PATH root)
  if(NOT CMAKE_INSTALL_PREFIX MATCHES \"/usr$\")
    set(root \${CMAKE_INSTALL_PREFIX})
  elseif(root STREQUAL \"/\")
    set(root \"\")
  endif()
  file(INSTALL ${PROJECT_SOURCE_DIR}/deploy/service/telepalp.limits.conf RENAME telepalp.conf
    DESTINATION \${root}/etc/security/limits.d)" COMPONENT station)

# Man pages and completion are written from each program's own --help, so that they cannot differ from it.
get_property(programs GLOBAL PROPERTY TELEPALP_PROGRAMS)
list(TRANSFORM programs REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE program_files)
list(JOIN program_files " " program_files)
install(CODE "
  execute_process(COMMAND sh ${PROJECT_SOURCE_DIR}/deploy/service/write_help_pages
    ${PROJECT_BINARY_DIR}/help_pages ${PROJECT_SOURCE_DIR}/deploy/demo ${program_files}
    COMMAND_ERROR_IS_FATAL ANY)" ALL_COMPONENTS)

function(telepalp_help_pages program component)
  install(FILES ${PROJECT_BINARY_DIR}/help_pages/man1/${program}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
    COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/help_pages/completion
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT ${component} RENAME ${program})
endfunction()
telepalp_help_pages(telepalp-demo demo)
set(packaged "")
foreach(component clients server station tools)
  string(TOUPPER ${component} upper)
  foreach(program ${TELEPALP_${upper}})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${component})
    telepalp_help_pages(${program} ${component})
    list(APPEND packaged ${program})
  endforeach()
endforeach()
foreach(program ${programs})
  if(NOT program IN_LIST packaged)
    message(FATAL_ERROR "${program} is in no package. fix: add it to a list in cmake/TelepalpInstall.cmake")
  endif()
endforeach()

# Scripts that run when a package is installed or removed. Before a removal, the script of a package with services
# stops these services.
set(units_server "telepalp-server.service telepalp-meet.service")
set(units_station telepalp-station.service)
foreach(unit server station)
  set(units ${units_${unit}})
  set(scripts_${unit} ${PROJECT_BINARY_DIR}/package_scripts/${unit})
  configure_file(deploy/service/prerm ${scripts_${unit}}/prerm @ONLY)
  configure_file(deploy/service/postinst ${scripts_${unit}}/postinst COPYONLY)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME telepalp)
set(CPACK_PACKAGE_VENDOR telepalp)
set(CPACK_PACKAGE_CONTACT "telepalp <telepalp@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/package_time.cmake)
set(CPACK_COMPONENTS_ALL data clients server station tools demo)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENT_DATA_DESCRIPTION "telepalp: scenes, data of the demo, and documents")
set(CPACK_COMPONENT_CLIENTS_DESCRIPTION "telepalp: view, record, report, export and replay sessions; impair a link")
set(CPACK_COMPONENT_SERVER_DESCRIPTION "telepalp: server at the patient's site, its keys, and the web page")
set(CPACK_COMPONENT_STATION_DESCRIPTION "telepalp: haptic station at the doctor's site")
set(CPACK_COMPONENT_TOOLS_DESCRIPTION "telepalp: depth codec, a probe of the surface that is felt, studies, and workers for sweeps")
set(CPACK_COMPONENT_DEMO_DESCRIPTION "telepalp: examine a patient by touch, across a network; all programs and the demo")
set(same_version "(= ${PROJECT_VERSION})")
foreach(component clients server station tools)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME telepalp-${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "telepalp-data ${same_version}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_SUGGESTS "libengine-pkcs11-openssl")  # for keys in a hardware token
endforeach()
set(CPACK_DEBIAN_DATA_PACKAGE_NAME telepalp-data)
set(CPACK_DEBIAN_DATA_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DEMO_PACKAGE_NAME telepalp)
set(CPACK_DEBIAN_DEMO_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DEMO_PACKAGE_DEPENDS "bash, util-linux, coreutils, telepalp-clients ${same_version}, telepalp-server ${same_version}, telepalp-station ${same_version}, telepalp-tools ${same_version}")
# Up to 0.1 one package, telepalp, held all files: without these fields, dpkg refuses to give its files to others.
foreach(component data clients server station tools)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_BREAKS "telepalp (<< 0.2)")
  set(CPACK_DEBIAN_${upper}_PACKAGE_REPLACES "telepalp (<< 0.2)")
endforeach()
set(CPACK_DEBIAN_SERVER_PACKAGE_CONTROL_EXTRA ${scripts_server}/postinst ${scripts_server}/prerm)
set(CPACK_DEBIAN_STATION_PACKAGE_CONTROL_EXTRA ${scripts_station}/postinst ${scripts_station}/prerm
  ${PROJECT_SOURCE_DIR}/deploy/service/conffiles)
include(CPack)
