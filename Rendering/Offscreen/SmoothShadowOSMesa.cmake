# smoothshadow_add_osmesa_twin(<executable>)
#
# Adds the executable <executable>-osmesa: the same object files, linked so that all of OpenGL in
# the process comes from OSMesa, as "osmesa" of vtkOffscreenWindows needs. libOSMesa is linked
# before everything else, and the executable answers for GLX's function lookup.
#
# Call it in the directory of <executable>, after the last target_link_libraries of it. Where
# libOSMesa is not installed no twin is made; ask with if (TARGET <executable>-osmesa).

find_library(SMOOTHSHADOW_OSMESA_LIBRARY NAMES OSMesa
  DOC "Mesa's software renderer (Debian: libosmesa6-dev)")
mark_as_advanced(SMOOTHSHADOW_OSMESA_LIBRARY)
set_property(GLOBAL PROPERTY smoothshadow_osmesa_source
  "${CMAKE_CURRENT_LIST_DIR}/OSMesaExecutable.cxx")

function (smoothshadow_add_osmesa_twin target)
  if (NOT SMOOTHSHADOW_OSMESA_LIBRARY)
    message(STATUS "SmoothShadow: no ${target}-osmesa, libOSMesa was not found")
    return ()
  endif ()
  get_property(source GLOBAL PROPERTY smoothshadow_osmesa_source)
  set(twin "${target}-osmesa")
  add_executable("${twin}" "${source}" "$<TARGET_OBJECTS:${target}>")
  # Libraries and VTK's libraries find OpenGL's symbols in the order of the link: OSMesa first.
  target_link_libraries("${twin}" PRIVATE "${SMOOTHSHADOW_OSMESA_LIBRARY}")
  get_target_property(libraries "${target}" LINK_LIBRARIES)
  if (libraries)
    target_link_libraries("${twin}" PRIVATE ${libraries})
  endif ()
  set_target_properties("${twin}" PROPERTIES
    CXX_STANDARD 17
    CXX_STANDARD_REQUIRED ON
    ENABLE_EXPORTS ON)
  foreach (property IN ITEMS
      LINK_OPTIONS LINK_DIRECTORIES RUNTIME_OUTPUT_DIRECTORY
      INSTALL_RPATH INSTALL_RPATH_USE_LINK_PATH BUILD_RPATH)
    get_target_property(value "${target}" "${property}")
    if (NOT value STREQUAL "value-NOTFOUND")
      set_target_properties("${twin}" PROPERTIES "${property}" "${value}")
    endif ()
  endforeach ()
endfunction ()
