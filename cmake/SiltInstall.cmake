# cmake --install gives bin/silt, the libraries with their headers, the scenes, and a package for
# find_package(silt) with the targets silt::core, silt::sim, silt::tracker, ….
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/silt)

get_property(libraries GLOBAL PROPERTY SILT_LIBRARIES)
install(TARGETS ${libraries} EXPORT siltTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT siltTargets NAMESPACE silt:: DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/siltConfig.cmake.in
  ${PROJECT_BINARY_DIR}/siltConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/siltConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/siltConfig.cmake ${PROJECT_BINARY_DIR}/siltConfigVersion.cmake
  DESTINATION ${package_dir})

if(TARGET silt)
  install(TARGETS silt RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
if(EXISTS ${PROJECT_SOURCE_DIR}/scenes)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/silt/scenes
    PATTERN "__pycache__" EXCLUDE)
endif()
