# Flags shared by all of our own targets, and one function for each sort of target.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # A precompiled header carries time stamps; without this sloppiness ccache would never hit.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime CCACHE_IGNOREOPTIONS=--param=ggc* ${CCACHE_PROGRAM})
endif()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
set(BLOSSOM_PLUGIN_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib/blossom/plugins)
set(BLOSSOM_PLUGIN_INSTALL_DIR ${CMAKE_INSTALL_LIBDIR}/blossom/plugins)
# Programs are built with the run path they are installed with: CMake would otherwise pad the one of the build tree with empty
# entries, and an empty entry is the current folder, from which any library would be loaded. Built libraries lie in lib.
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)
set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}" "$ORIGIN/../lib")
list(REMOVE_DUPLICATES CMAKE_INSTALL_RPATH)

add_library(blossom_flags INTERFACE)
add_library(Blossom::flags ALIAS blossom_flags)
target_compile_options(blossom_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual $<$<BOOL:${BLOSSOM_WERROR}>:-Werror>
  # GCC 12 reports these three inside Eigen and the standard library at -O2
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overread>
  # GCC 13 and later report references to what outlives the call.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-dangling-reference>
  # Members of an anonymous namespace's type are as private in a unity file as in their own.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
# GCC tidies its memory whenever that has doubled, which costs an eighth of a build: it begins at 1 GB.
target_compile_options(blossom_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1000000>)
if(BLOSSOM_SANITIZE)
  target_compile_options(blossom_flags INTERFACE -fsanitize=${BLOSSOM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(blossom_flags INTERFACE -fsanitize=${BLOSSOM_SANITIZE})
endif()

# $<LINK_LIBRARY:LOADED,lib>: loaded with the program though nothing in it calls it. Plugins from elsewhere, which have no run path,
# find it there; Debian's compiler drops what is not called.
set(CMAKE_CXX_LINK_LIBRARY_USING_LOADED_SUPPORTED ON)
set(CMAKE_CXX_LINK_LIBRARY_USING_LOADED "LINKER:--push-state,--no-as-needed" "<LINK_ITEM>" "LINKER:--pop-state")

# blossom_compile_by_folder(TARGET): the files of each folder are compiled at once, because most of a file's time goes into the headers
# that its neighbours include, too. Folders, unlike batches of a number, stay the same when a file comes or goes.
function(blossom_compile_by_folder target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    cmake_path(GET source PARENT_PATH folder)
    string(REPLACE "${CMAKE_CURRENT_SOURCE_DIR}" "" place "${folder}")
    string(MAKE_C_IDENTIFIER "${target}${place}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()

# blossom_automoc(TARGET): calls moc for each header that asks for it.
if(BLOSSOM_BUILD_UI)
  get_target_property(BLOSSOM_MOC Qt6::moc LOCATION)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/quick-moc.in ${CMAKE_BINARY_DIR}/cmake/quick-moc @ONLY FILE_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endif()
function(blossom_automoc target)
  set_target_properties(${target} PROPERTIES AUTOMOC ON AUTOMOC_EXECUTABLE ${CMAKE_BINARY_DIR}/cmake/quick-moc)
endfunction()

# blossom_precompiled(TARGET HEADERS): compiled with the precompiled headers given. They include fmt, whose macro has to be the same.
function(blossom_precompiled target headers)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:fmt::fmt>)
  target_precompile_headers(${target} REUSE_FROM ${headers})
endfunction()

# Glue declares, checks, shows and hands on; what takes long is done in kernels, geometry, formats and pictures. More optimisation
# makes it take up to a half longer to compile.
set(BLOSSOM_GLUE_OPTIMIZATION $<$<CONFIG:Release>:-O1>)

# blossom_glue(TARGET HEADERS): compiles it with less optimisation, and the precompiled headers given, which are compiled likewise.
function(blossom_glue target headers)
  target_compile_options(${target} PRIVATE ${BLOSSOM_GLUE_OPTIMIZATION})
  blossom_precompiled(${target} ${headers})
endfunction()

# blossom_room(NAME [GLUE] PUBLIC libs.. PRIVATE libs..)
# A room is a shared library made of every .cpp in its folder and the folders in it; headers are included as "NAME/header.h" or
# "NAME/folder/header.h".
function(blossom_room name)
  cmake_parse_arguments(ROOM "GLUE" "" "PUBLIC;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp)
  list(FILTER sources EXCLUDE REGEX "/main(_[a-z]+)?\\.cpp$")
  add_library(blossom_${name} SHARED ${sources})
  blossom_compile_by_folder(blossom_${name})
  add_library(Blossom::${name} ALIAS blossom_${name})
  set_target_properties(blossom_${name} PROPERTIES EXPORT_NAME ${name} VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}
    INSTALL_RPATH "$ORIGIN")
  target_include_directories(blossom_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/blossom>)
  target_link_libraries(blossom_${name} PUBLIC ${ROOM_PUBLIC} PRIVATE ${ROOM_PRIVATE} $<BUILD_INTERFACE:Blossom::flags>)
  if(ROOM_GLUE)
    blossom_glue(blossom_${name} blossom_glue_headers)
  else()
    blossom_precompiled(blossom_${name} blossom_headers)
  endif()
  install(TARGETS blossom_${name} EXPORT BlossomTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/blossom/${name} FILES_MATCHING PATTERN "*.h")
endfunction()
