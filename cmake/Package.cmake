set(CPACK_PACKAGE_NAME blossom)
set(CPACK_PACKAGE_CONTACT "Blossom maintainers <maintainers@blossom.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
# A package fits one release of Debian: the libraries have other names in the next.
cmake_host_system_information(RESULT debian_release QUERY DISTRIB_VERSION_ID)
set(CPACK_DEBIAN_PACKAGE_VERSION "${PROJECT_VERSION}~deb${debian_release}")
if(debian_release VERSION_GREATER_EQUAL 13)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS qt6-svg-plugins)  # a plugin of Qt, which no library names; part of libqt6svg6 before
endif()
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR}/lib)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS fonts-dejavu-core)  # the standard font of texts
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
include(CPack)
