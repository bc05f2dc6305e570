# What an out-of-tree plugin needs: find_package(Blossom) and Blossom::feature.
include(CMakePackageConfigHelpers)
install(EXPORT BlossomTargets NAMESPACE Blossom:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Blossom)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/BlossomConfig.cmake.in ${CMAKE_BINARY_DIR}/BlossomConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Blossom)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/BlossomConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/BlossomConfig.cmake ${CMAKE_BINARY_DIR}/BlossomConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Blossom)

# What a desktop needs to show Blossom among its programs and to know its documents.
set(desktop_files ${PROJECT_SOURCE_DIR}/packaging)
install(FILES ${desktop_files}/blossom.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${desktop_files}/icons/scalable/blossom.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES ${desktop_files}/blossom-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME blossom.xml)
install(FILES ${desktop_files}/blossom.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
