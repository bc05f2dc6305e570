# Every third-party library, found in one place. The reason for each stands in CONTRIBUTING.md.
find_package(OpenCASCADE REQUIRED)             # B-rep, STEP, IGES
# OpenCASCADE 7.8 has one toolkit for each format where 7.6 had several.
if(TARGET TKDESTEP)
  set(OCCT_STEP TKDESTEP)
  set(OCCT_IGES TKDEIGES)
else()
  set(OCCT_STEP TKSTEP TKSTEPBase TKXDESTEP)
  set(OCCT_IGES TKIGES TKXDEIGES)
endif()
find_package(MPI REQUIRED COMPONENTS C)        # Debian's VTK configuration asks for it
set(VTK_MODULE_ENABLE_VTK_GUISupportQt NO)     # Debian builds that module on Qt 5
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms
  FiltersCore FiltersGeneral FiltersSources
  RenderingCore RenderingOpenGL2 RenderingFreeType RenderingAnnotation InteractionStyle InteractionWidgets IOImage IOOggTheora)
find_package(Eigen3 REQUIRED)
find_package(TBB REQUIRED)
find_package(Boost 1.74 REQUIRED COMPONENTS filesystem)
find_package(nlohmann_json REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(pugixml REQUIRED)
find_package(2Geom REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(DXFLIB REQUIRED IMPORTED_TARGET dxflib)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo cairo-pdf cairo-ps)  # pages of PDF and PostScript
pkg_check_modules(ZIP REQUIRED IMPORTED_TARGET libzip)
find_package(ZLIB REQUIRED)                    # what a damaged zip still holds, without its directory; checksums of journals
pkg_check_modules(EGL REQUIRED IMPORTED_TARGET egl)
find_package(Freetype REQUIRED)                # outlines of letters
find_package(Fontconfig REQUIRED)              # which fonts are installed
find_package(CGAL REQUIRED)                    # exact arrangements, polyhedra, Voronoi diagrams of segments
# Debian's CMake package of OpenSubdiv names static libraries that its packages leave out.
find_path(OPENSUBDIV_INCLUDE_DIR opensubdiv/bfr/surface.h REQUIRED)
find_library(OPENSUBDIV_LIBRARY osdCPU REQUIRED)  # subdivision surfaces
if(BLOSSOM_BUILD_UI)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Widgets OpenGL Svg DBus)
endif()
if(BLOSSOM_BUILD_TESTS)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Test)
  find_package(benchmark REQUIRED)
endif()
