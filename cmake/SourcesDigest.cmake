# SPDX-License-Identifier: MIT
# ombrage_sources_digest(OUTPUT_VARIABLE NAME [EXTRA text] FILES files...): a generated source that defines
# `const char* const ombrage::NAME`, a digest of the files' names and contents and of the text.
function(ombrage_sources_digest output_variable name)
  cmake_parse_arguments(ARG "" "EXTRA" "FILES" ${ARGN})
  set(list ${PROJECT_BINARY_DIR}/generated/${name}.txt)
  set(output ${PROJECT_BINARY_DIR}/generated/${name}.cpp)
  list(JOIN ARG_FILES "\n" lines)
  file(CONFIGURE OUTPUT ${list} CONTENT "${lines}\n" @ONLY)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DLIST=${list} -DROOT=${PROJECT_SOURCE_DIR} -DOUTPUT=${output} -DNAME=${name} "-DEXTRA=${ARG_EXTRA}"
            -P ${PROJECT_SOURCE_DIR}/cmake/SourcesDigestScript.cmake
    DEPENDS ${ARG_FILES} ${list} ${PROJECT_SOURCE_DIR}/cmake/SourcesDigestScript.cmake
    COMMENT "Digest of sources: ${name}" VERBATIM)
  set(${output_variable} ${output} PARENT_SCOPE)
endfunction()

# Everything that decides what a scene file becomes. Archived scenes carry it, so that a changed reader never meets what an older one read.
file(GLOB scene_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/scene/*.h ${PROJECT_SOURCE_DIR}/src/scene/*.cpp
     ${PROJECT_SOURCE_DIR}/src/core/image*.h ${PROJECT_SOURCE_DIR}/src/core/image*.cpp ${PROJECT_SOURCE_DIR}/src/core/strings.*
     ${PROJECT_SOURCE_DIR}/include/ombrage/image.h ${PROJECT_SOURCE_DIR}/include/ombrage/scene.h)
list(FILTER scene_sources EXCLUDE REGEX "_test\\.cpp$")
ombrage_sources_digest(OMBRAGE_SCENE_SOURCES_DIGEST kSceneSourcesDigest FILES ${scene_sources})

# Everything that decides what is measured: code and shaders of all layers below the report, the compiler and its options. Stored results
# carry it, so that a program that differs never takes them for its own.
file(GLOB_RECURSE measuring_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/ombrage/*.h ${PROJECT_SOURCE_DIR}/src/*.h
     ${PROJECT_SOURCE_DIR}/src/*.cpp ${PROJECT_SOURCE_DIR}/src/*.glsl ${PROJECT_SOURCE_DIR}/src/*.vert ${PROJECT_SOURCE_DIR}/src/*.frag
     ${PROJECT_SOURCE_DIR}/src/*.geom ${PROJECT_SOURCE_DIR}/src/*.comp)
list(FILTER measuring_sources EXCLUDE REGEX "_test\\.cpp$|/src/report/")
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
ombrage_sources_digest(OMBRAGE_MEASURING_SOURCES_DIGEST kMeasuringSourcesDigest FILES ${measuring_sources}
  EXTRA "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} ${CMAKE_SYSTEM_PROCESSOR}")
