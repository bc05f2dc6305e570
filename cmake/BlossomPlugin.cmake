# blossom_plugin(ID): a plugin made of plugin.json, all .cpp below kernel, *.cpp (the feature types) and all .cpp below manipulators in the current folder.
# The kernel is a static library of its own, so that tests and benchmarks can link it without the plugin.
function(blossom_plugin id)
  file(GLOB_RECURSE kernel_sources CONFIGURE_DEPENDS kernel/*.cpp)
  add_library(blossom_${id}_kernel STATIC ${kernel_sources})
  blossom_compile_by_folder(blossom_${id}_kernel)
  target_precompile_headers(blossom_${id}_kernel REUSE_FROM blossom_headers)
  target_include_directories(blossom_${id}_kernel PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(blossom_${id}_kernel PUBLIC Blossom::geometry PRIVATE Blossom::flags)

  file(GLOB feature_sources CONFIGURE_DEPENDS *.cpp)
  if(NOT feature_sources)
    message(STATUS "The plugin ${id} declares no feature types yet: only its kernel is built.")
    return()
  endif()
  add_library(blossom_${id} MODULE ${feature_sources})
  blossom_compile_by_folder(blossom_${id})
  # Declarations and calls of the kernel, which take twice as long to compile with more optimisation. The shared headers are
  # compiled with more, too, and GCC 14 does not let them be used with less.
  target_compile_options(blossom_${id} PRIVATE $<$<CONFIG:Release>:-O1>)
  target_link_libraries(blossom_${id} PRIVATE blossom_${id}_kernel Blossom::feature fmt::fmt Blossom::flags)
  set(modules blossom_${id})

  file(GLOB_RECURSE manipulator_sources CONFIGURE_DEPENDS manipulators/*.cpp manipulators/*.h)
  if(BLOSSOM_BUILD_UI AND manipulator_sources)
    add_library(blossom_${id}_manipulators MODULE ${manipulator_sources})
    blossom_compile_by_folder(blossom_${id}_manipulators)
    target_precompile_headers(blossom_${id}_manipulators REUSE_FROM blossom_window_headers)
    target_link_libraries(blossom_${id}_manipulators PRIVATE blossom_${id}_kernel Blossom::ui Blossom::flags)
    blossom_automoc(blossom_${id}_manipulators)  # tools have signals
    list(APPEND modules blossom_${id}_manipulators)
  endif()

  add_dependencies(programs ${modules})
  set(folder ${BLOSSOM_PLUGIN_OUTPUT_DIRECTORY}/${id})
  set_target_properties(${modules} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${folder} INSTALL_RPATH "$ORIGIN/../../..")
  configure_file(plugin.json ${folder}/plugin.json COPYONLY)
  install(TARGETS ${modules} LIBRARY DESTINATION ${BLOSSOM_PLUGIN_INSTALL_DIR}/${id})
  install(FILES plugin.json DESTINATION ${BLOSSOM_PLUGIN_INSTALL_DIR}/${id})
endfunction()
