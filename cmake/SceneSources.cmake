# SPDX-License-Identifier: MIT
# OMBRAGE_SCENE_SOURCES_DIGEST: a generated source with a digest of everything that decides what a scene file becomes. Archived scenes
# carry it, so that a changed reader never meets what an older one read.
file(GLOB scene_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/scene/*.h ${PROJECT_SOURCE_DIR}/src/scene/*.cpp
     ${PROJECT_SOURCE_DIR}/src/core/image*.h ${PROJECT_SOURCE_DIR}/src/core/image*.cpp ${PROJECT_SOURCE_DIR}/src/core/strings.*
     ${PROJECT_SOURCE_DIR}/include/ombrage/image.h ${PROJECT_SOURCE_DIR}/include/ombrage/scene.h)
list(FILTER scene_sources EXCLUDE REGEX "_test\\.cpp$")
set(scene_sources_list ${PROJECT_BINARY_DIR}/generated/scene_sources.txt)
list(JOIN scene_sources "\n" scene_source_lines)
file(CONFIGURE OUTPUT ${scene_sources_list} CONTENT "${scene_source_lines}\n" @ONLY)
set(OMBRAGE_SCENE_SOURCES_DIGEST ${PROJECT_BINARY_DIR}/generated/scene_sources_digest.cpp)
add_custom_command(OUTPUT ${OMBRAGE_SCENE_SOURCES_DIGEST}
  COMMAND ${CMAKE_COMMAND} -DLIST=${scene_sources_list} -DOUTPUT=${OMBRAGE_SCENE_SOURCES_DIGEST}
          -P ${PROJECT_SOURCE_DIR}/cmake/SceneSourcesScript.cmake
  DEPENDS ${scene_sources} ${scene_sources_list} ${PROJECT_SOURCE_DIR}/cmake/SceneSourcesScript.cmake
  COMMENT "Digest of the scene readers" VERBATIM)

# ombrage-import, the process that reads files under guard. It lies beside the program.
function(ombrage_import_program)
  add_executable(ombrage_import ${PROJECT_SOURCE_DIR}/src/scene/import_main.cpp)
  set_target_properties(ombrage_import PROPERTIES OUTPUT_NAME ombrage-import RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  target_include_directories(ombrage_import PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(ombrage_import PRIVATE ombrage_scene ombrage_warnings)
endfunction()
