# What `cmake --install` puts where, and the Debian package of it (scripts/package). Included last, from the top.
include(GNUInstallDirs)

install(TARGETS strandline)
# The editor's pages, which npm builds and CMake does not: ./run serve or scripts/package have made them.
if(STRANDLINE_EDITOR)
  install(CODE "if(NOT EXISTS [==[${CMAKE_SOURCE_DIR}/web/dist/index.html]==])
    message(WARNING \"the editor's pages are not built, so strandline serve will have none: cd web && npm ci && npm run build\")
  endif()")
  install(DIRECTORY web/dist/ DESTINATION "${CMAKE_INSTALL_DATADIR}/strandline/web" OPTIONAL)
endif()

# The program prints its own manual page and completion, when everything is built (or the target `manual`): another processor's program
# does so by CMAKE_CROSSCOMPILING_EMULATOR, and nothing of it runs while it is installed.
set(manual "${CMAKE_CURRENT_BINARY_DIR}/manual")
file(MAKE_DIRECTORY "${manual}")
add_custom_command(OUTPUT "${manual}/strandline.1.gz" "${manual}/strandline"
  COMMAND strandline manual man > "${manual}/strandline.1"
  COMMAND gzip -9nf "${manual}/strandline.1"
  COMMAND strandline manual bash > "${manual}/strandline"
  DEPENDS strandline VERBATIM COMMENT "Writing the manual page and the completion")
add_custom_target(manual ALL DEPENDS "${manual}/strandline.1.gz" "${manual}/strandline")
install(FILES "${manual}/strandline.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(FILES "${manual}/strandline" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")

install(FILES README.md packaging/copyright DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY docs drawings DESTINATION "${CMAKE_INSTALL_DOCDIR}")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "Strandline")
set(CPACK_PACKAGE_CONTACT "Strandline maintainers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "drivable paths for drawing robots")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Strandline turns a drawing (SVG, picture or text) into one drivable path for a
drawing robot on beach, turf or paper: order of the strokes, fills, corners,
curves within the robot's limits and a timed trajectory, proved from its file.
It comes with an editor in the browser (strandline serve) and writes what
robots, maps, ROS, ArduPilot, plotters and sand tables read.")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS hershey-fonts-data)  # read at run time; libraries are found by dpkg-shlibdeps
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "fonts-dejavu-core, xdg-utils")  # text in drawings; --open
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
include(CPack)
